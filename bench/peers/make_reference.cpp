// SPDX-License-Identifier: Apache-2.0
#include "make_reference.h"

#include "peers.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

namespace hawser::bench {
namespace {

Reference series(const PeerResult& r) { return {r.tension_times, {}, r.tensions}; }

/// Return the relative rms difference of `a` to `b` after the first second, at the times of `b`.
double difference(const Reference& a, const Reference& b) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < b.t.size(); ++i) {
        if (b.t[i] < kSettle || !a.covers(b.t[i])) continue;
        for (std::size_t k = 0; k < b.tension.size(); ++k) {
            const double e = a.tension_at(k, b.t[i]) / b.tension[k][i] - 1.0;
            sum += e * e;
            ++count;
        }
    }
    return count > 0 ? std::sqrt(sum / count) : 0.0;
}

PeerResult simulate(const Scene& scene, double duration, int substeps) {
    const Reference none;
    Trial trial(engine_by_name("hawser"), scene, none, substeps, duration);
    while (trial.frame()) {
    }
    return trial.result();
}

/// Write nine digits: differences of the finest runs are small.
void write(const std::string& path, const Reference& fine, const Reference& coarse) {
    std::ofstream out(path);
    out << "t";
    for (std::size_t k = 0; k < fine.tension.size(); ++k) out << ",tension_" << k + 1;
    for (std::size_t k = 0; k < fine.tension.size(); ++k) out << ",coarse_" << k + 1;
    for (std::size_t i = 0; i < fine.t.size(); ++i) {
        if (!coarse.covers(fine.t[i])) continue;
        out << fmt::format("\n{:.9f}", fine.t[i]);
        for (const auto& values : fine.tension) out << fmt::format(",{:.9g}", values[i]);
        for (std::size_t k = 0; k < fine.tension.size(); ++k)
            out << fmt::format(",{:.9g}", coarse.tension_at(k, fine.t[i]));
    }
    out << '\n';
    if (!out) throw std::runtime_error("cannot write " + path);
}

}  // namespace

void make_reference(const Scene& scene, double duration, const std::string& folder) {
    if (scene.towed.empty())
        throw std::invalid_argument(scene.name + ": nothing is towed, so there is no tension");
    std::vector<PeerResult> runs;
    for (int n = 1; n <= kFine; n *= 2) {
        fmt::print(stderr, "{}: {} substeps, {:g} s\n", scene.name, n, duration);
        runs.push_back(simulate(scene, duration, n));
    }
    const Reference fine = series(runs.back()), coarse = series(runs[runs.size() - 2]);
    fmt::print("\n{}: tow tension against {} substeps, rms after {:g} s\n{:>9}{:>14}{:>10}{:>10}\n",
               scene.name, kFine, kSettle, "substeps", "difference", "gap [m]", "ms/frame");
    for (const PeerResult& r : runs)
        fmt::print("{:>9}{:>14.3g}{:>10.2g}{:>10.3f}\n", r.substeps, difference(series(r), fine),
                   r.measures.gap, r.ms_per_frame);
    const std::string path = folder + "/" + scene.name + ".csv";
    write(path, fine, coarse);
    fmt::print("wrote {}\n", path);
}

}  // namespace hawser::bench
