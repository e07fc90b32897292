// SPDX-License-Identifier: Apache-2.0
#include "step_seaway.h"

#include <hawser/scene.h>

#include "fraction_of.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <numbers>
#include <stdexcept>

namespace hawser::bench {

const char* const kSeawayFormula =
    R"(Seaway: the k-th hull found (copies of the site in turn) is forced at the start of each step, at time t, by
    F_z = A r heave sin(w t + k P),  M_x = A r roll sin(w t + k P + 1),  M_y = A r pitch sin(w t + k P + 2)
with A = --amplitude, P = --phase [rad], w = 2 pi/period and the ramp r = min(1, t/8 s). Hulls and their
periods [s], heave [N], roll and pitch [N m] by default:
    rig 12 1.5e6 0 0      ahts1 9 14e6 4.2e6 150e6      ahts2 8.2 14e6 4.2e6 150e6
--hull NAME PERIOD HEAVE ROLL PITCH, once a hull, replaces them. Hulls are the bodies NAME and NAME/hull, of
copies of the site sK_NAME and sK_NAME/hull. The timeline of a scene is not run. A step is uncertified if its
natural map is above settings.contact_tolerance or a row still asks to switch. Factorisations and their
work (in one LDLT of the matrix) are exact and repeatable, milliseconds are CPU time of the calling thread.
Exit code 1 if a step failed or is uncertified.)";

std::vector<HullForcing> default_hulls() {
    return {{"rig", 12.0, 1.5e6, 0.0, 0.0},
            {"ahts1", 9.0, 14e6, 4.2e6, 150e6},
            {"ahts2", 8.2, 14e6, 4.2e6, 150e6}};
}

namespace {

double seaway_cpu() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct ForcedHull {
    BodyId body;
    HullForcing by;
};

/// Find the hulls of the site, then those of its copies in turn.
std::vector<ForcedHull> find_hulls(const World& w, const std::vector<HullForcing>& wanted) {
    constexpr int kMostCopies = 1000;
    std::vector<ForcedHull> found;
    for (int copy = -1; copy < kMostCopies; ++copy) {
        const std::string prefix = copy < 0 ? "" : fmt::format("s{}_", copy);
        for (const HullForcing& h : wanted)
            for (const char* part : {"", "/hull"})
                if (const BodyId b = w.find_body(prefix + h.name + part); w.alive(b))
                    found.push_back({b, h});
    }
    return found;
}

void force_hulls(World& w, const std::vector<ForcedHull>& hulls, const SeawayOptions& options) {
    const double t = w.time(), scale = options.amplitude * std::min(1.0, t / 8.0);
    int k = 0;
    for (const ForcedHull& h : hulls) {
        const double angle = 2.0 * std::numbers::pi * t / h.by.period + options.phase * k++;
        const Vec3 force(0.0, 0.0, h.by.heave * std::sin(angle));
        const Vec3 moment(h.by.roll * std::sin(angle + 1.0), h.by.pitch * std::sin(angle + 2.0),
                          0.0);
        w.set_force(h.body, force * scale, moment * scale);
    }
}

/// Costs of the steps of a run.
struct SeawaySteps {
    std::vector<double> ms, factorisations, work;
    int uncertified = 0;
    Status status = Status::ok;
};

nlohmann::json print_costs(const char* name, const std::vector<double>& values) {
    const double p50 = fraction_of(values, 0.5), p95 = fraction_of(values, 0.95),
                 p99 = fraction_of(values, 0.99), worst = fraction_of(values, 1.0);
    const auto ratio = [&](double value) { return p50 > 0.0 ? value / p50 : 0.0; };
    fmt::print("  {:<15} {:>9.2f} {:>9.2f} {:>9.2f} {:>9.2f}   {:>6.2f} {:>6.2f}\n", name, p50, p95,
               p99, worst, ratio(p99), ratio(worst));
    return {{"median", p50}, {"p95", p95}, {"p99", p99}, {"worst", worst}};
}

SeawaySteps run_steps(scene::Scene& scene, const SeawayOptions& options) {
    World& w = scene.world;
    const std::vector<ForcedHull> hulls =
        find_hulls(w, options.hulls.empty() ? default_hulls() : options.hulls);
    if (hulls.empty())
        throw std::runtime_error(options.scene + ": no hull to force; name some with --hull");
    std::ofstream csv;
    if (!options.csv.empty()) {
        csv.open(options.csv);
        csv << "time,ms,factorisations,partial,iterations,work,natural_map,flips_left,"
               "wire_repeats\n";
    }
    SeawaySteps all;
    const auto steps = std::lround(options.seconds / w.settings().step);
    for (long i = 0; i < steps && all.status == Status::ok; ++i) {
        force_hulls(w, hulls, options);
        const double start = seaway_cpu();
        all.status = w.step();
        const StepStats& s = w.stats();
        all.ms.push_back(1e3 * (seaway_cpu() - start));
        all.factorisations.push_back(s.factorisations);
        all.work.push_back(s.factor_work);
        const bool certified = s.natural_map <= w.settings().contact_tolerance && s.flips_left == 0;
        all.uncertified += certified ? 0 : 1;
        if (csv.is_open())
            csv << fmt::format("{:.6g},{:.4f},{},{},{},{:.4f},{:.3g},{},{}\n", w.time(),
                               all.ms.back(), s.factorisations, s.partial_factorisations,
                               s.newton_iterations, s.factor_work, s.natural_map, s.flips_left,
                               s.wire_repeats);
    }
    return all;
}

}  // namespace

int run_seaway(const SeawayOptions& options) {
    scene::Options read;
    read.threads = options.threads;
    scene::Scene scene = scene::load_file(options.scene, read);
    scene.world.prepare();
    const SeawaySteps all = run_steps(scene, options);
    const World& w = scene.world;
    fmt::print("{} in a seaway, amplitude {:g}, phase {:g} rad, {:g} s, {} thread(s), {}\n",
               options.scene, options.amplitude, options.phase, w.time(), options.threads,
               instruction_set());
    fmt::print("  {:<15} {:>9} {:>9} {:>9} {:>9}   {:>6} {:>6}\n", "of a step", "median", "p95",
               "p99", "worst", "p99/m", "max/m");
    nlohmann::json out{{"scene", options.scene},         {"amplitude", options.amplitude},
                       {"phase", options.phase},         {"steps", all.ms.size()},
                       {"uncertified", all.uncertified}, {"status", to_string(all.status)}};
    out["ms"] = print_costs("ms", all.ms);
    out["factorisations"] = print_costs("factorisations", all.factorisations);
    out["work"] = print_costs("factor work", all.work);
    const double first = all.factorisations.empty() ? 0.0 : all.factorisations.front();
    out["first_step_factorisations"] = first;
    out["hash"] = fmt::format("{:016x}", w.state().hash());
    fmt::print("  first step {:.0f} factorisations; {} steps, {} uncertified; state {:016x}\n",
               first, all.ms.size(), all.uncertified, w.state().hash());
    if (all.status != Status::ok) {
        const auto verdict = w.verdict();
        const Finding& found = verdict.of(verdict.judge);
        fmt::print("  the step at {:g} s failed: {}; monitor {}: {:g} since {:g} s\n", w.time(),
                   to_string(all.status), to_string(verdict.judge), found.value, found.time);
    }
    if (!options.json.empty()) std::ofstream(options.json) << out.dump(2) << '\n';
    return all.status == Status::ok && all.uncertified == 0 ? 0 : 1;
}

}  // namespace hawser::bench
