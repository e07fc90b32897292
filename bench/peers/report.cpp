// SPDX-License-Identifier: Apache-2.0
#include "report.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace hawser::bench {
namespace {

using nlohmann::json;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::string cell(const std::optional<double>& v, double scale = 1.0) {
    return v ? fmt::format("{:.2g}", scale * *v) : "-";
}

json number(const std::optional<double>& v) {
    return v && std::isfinite(*v) ? json(*v) : json(nullptr);
}

/// Contact points at the end of a frame: minimum, median, maximum. All 0 without contacts.
struct Points {
    int min = 0, median = 0, max = 0;
};
Points points(const PeerResult& r) {
    if (r.contacts.empty()) return {};
    std::vector<int> v = r.contacts;
    std::sort(v.begin(), v.end());
    return {v.front(), v[v.size() / 2], v.back()};
}

std::string verdict(const PeerResult& r) {
    std::string text = r.holds ? "yes" : "no: " + r.reason_unusable;
    if (!r.unchecked.empty()) text += " (" + r.unchecked + " not checked: no reference)";
    if (!r.holds) text += fmt::format(", {:.2f} s simulated", r.simulated);
    return text;
}

}  // namespace

std::vector<Demand> demands(const Scene& scene, const PeerResult& r) {
    const Wanted& w = scene.wanted;
    const Measures& m = r.measures;
    std::vector<Demand> all;
    const auto at_most = [&](const char* what, double value, double limit) {
        if (limit > 0.0) all.push_back({what, value, limit, value <= limit});
    };
    at_most("gap [m]", m.gap, w.gap);
    at_most("tension error, rms", m.tension_error.value_or(kNone), w.tension);
    at_most("drop of the top [m]", m.drop.value_or(kNone), w.moved);
    at_most("sideways [m]", m.sideways.value_or(kNone), w.moved);
    at_most("median frame, CPU [ms]", r.cpu_ms, w.ms);
    at_most("most contact points", points(r).max, w.contacts[1]);
    if (w.contacts[0] > 0) {
        const double least = points(r).min;
        all.push_back({"fewest contact points, at least", least, static_cast<double>(w.contacts[0]),
                       least >= w.contacts[0]});
    }
    return all;
}

void print_header(const Scene& scene) {
    fmt::print("\n{} ({}), {} bodies, {} joints, one thread\n", scene.name, scene.code,
               scene.bodies.size(), scene.joints.size());
    fmt::print("{:<22}{:>5}{:>11}{:>10}", "engine", "sub", "ms/frame", "p99");
    if (scene.touching) fmt::print("{:>9}", "cpu ms");
    if (scene.top >= 0)
        fmt::print("{:>10}{:>13}{:>10}", "drop [m]", "sideways [m]", "contacts");
    else if (scene.touching)
        fmt::print("{:>10}{:>11}{:>10}{:>10}", "gap [m]", "tension %", "sink [m]", "contacts");
    else
        fmt::print("{:>10}{:>11}{:>10}{:>11}", "gap [m]", "tension %", "energy %", "path [m]");
    fmt::print("  holds\n");
}

void print_row(const Scene& scene, const PeerResult& r) {
    const Measures& m = r.measures;
    fmt::print("{:<22}{:>5}{:>11.3f}{:>10.3f}", r.engine, r.substeps, r.ms_per_frame, r.ms_p99);
    if (scene.touching) fmt::print("{:>9.3f}", r.cpu_ms);
    const std::string touching = r.contacts.empty() ? "-" : std::to_string(points(r).median);
    if (scene.top >= 0)
        fmt::print("{:>10}{:>13}{:>10}", cell(m.drop), cell(m.sideways), touching);
    else if (scene.touching)
        fmt::print("{:>10.2g}{:>11}{:>10}{:>10}", m.gap, cell(m.tension_error, 100.0), cell(m.sink),
                   touching);
    else
        fmt::print("{:>10.2g}{:>11}{:>10}{:>11}", m.gap, cell(m.tension_error, 100.0),
                   cell(m.energy_drift, 100.0), cell(m.block_error));
    fmt::print("  {}\n", verdict(r));
    std::fflush(stdout);
}

bool print_verdict(const Scene& scene, const std::vector<PeerResult>& results) {
    const PeerResult *ours = nullptr, *best = nullptr;
    for (const PeerResult& r : results) {
        if (r.engine == "hawser")
            ours = &r;
        else if (r.holds && (!best || r.ms_per_frame < best->ms_per_frame))
            best = &r;
    }
    if (best)
        fmt::print("fastest peer that holds: {} with {} substeps ({}), {:.3f} ms per frame\n",
                   best->engine, best->substeps, best->settings, best->ms_per_frame);
    else if (results.size() > (ours ? 1U : 0U))
        fmt::print("no peer that was run holds\n");
    if (best && ours) {
        const double ratio = best->ms_per_frame / ours->ms_per_frame;
        fmt::print("ours: {:.3f} ms, {:.2f} times {}\n", ours->ms_per_frame,
                   ratio > 1.0 ? ratio : 1.0 / ratio, ratio > 1.0 ? "faster" : "slower");
    }
    bool met = true;
    if (ours) {
        for (const Demand& d : demands(scene, *ours)) {
            fmt::print("ours: {:<32}{:>10.3g}  limit {:<8g}{}\n", d.what, d.value, d.limit,
                       d.met ? "ok" : "FAIL");
            met = met && d.met;
        }
    }
    std::fflush(stdout);
    return met;
}

json to_json(const Scene& scene, const PeerResult& r) {
    const Measures& m = r.measures;
    const bool energy = !scene.touching;
    json j = {{"engine", r.engine},
              {"scene", r.scene},
              {"settings", r.settings},
              {"substeps", r.substeps},
              {"holds", r.holds},
              {"why_not", r.reason_unusable},
              {"unchecked", r.unchecked},
              {"simulated_s", r.simulated},
              {"ms_per_frame", r.ms_per_frame},
              {"ms_p99", r.ms_p99},
              {"cpu_ms_per_frame", r.cpu_ms},
              {"gap_m", number(m.gap)},
              {"tension_error", number(m.tension_error)},
              {"tension_error_substeps", number(m.substep_ripple)},
              {"tension_mean_error", number(m.tension_mean)},
              {"tension_ripple", number(m.tension_ripple)},
              {"tension_worst", number(m.tension_worst)},
              {"energy_drift", energy ? number(m.energy_drift) : json(nullptr)},
              {"energy_drift_end", energy ? number(m.energy_end) : json(nullptr)},
              {"block_error_m", number(m.block_error)},
              {"mode_amplitude", number(m.mode_amplitude)},
              {"drop_m", number(m.drop)},
              {"sideways_m", number(m.sideways)},
              {"sink_m", number(m.sink)},
              {"contacts", nullptr},
              {"frame_ms", r.frame_ms},
              {"tension_times_s", r.tension_times},
              {"tensions_N", r.tensions}};
    if (!r.contacts.empty()) {
        const Points p = points(r);
        j["contacts"] = {{"min", p.min}, {"median", p.median}, {"max", p.max}};
    }
    if (r.engine != "hawser") return j;
    j["demands"] = json::array();
    for (const Demand& d : demands(scene, r))
        j["demands"].push_back(
            {{"what", d.what}, {"value", number(d.value)}, {"limit", d.limit}, {"met", d.met}});
    return j;
}

}  // namespace hawser::bench
