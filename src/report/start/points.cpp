// SPDX-License-Identifier: Apache-2.0
#include <hawser/exercise.h>
#include <hawser/hawser.h>

#include "report/start/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace hawser::report::start {
namespace {
constexpr double kUnbounded = std::numeric_limits<double>::infinity();
}

void check_points(const exercise::Exercise& e, Findings& out) {
    double possible = 0.0;
    for (const exercise::Goal& goal : e.goals) possible += goal.points;
    if (!(e.pass > possible)) return;
    out.add(false, FindingKind::points, {e.name}, e.pass - possible,
            fmt::format("the exercise needs {:.6g} points (\"pass\"), and its goals give {:.6g} in "
                        "all: it cannot be passed; lower \"pass\", or give goals more points",
                        e.pass, possible));
}

namespace {

/// Return the earliest time at which each goal can be reached, by hold times and goals before [s].
std::vector<double> earliest_times(const exercise::Exercise& e) {
    std::vector<double> out;
    for (const exercise::Goal& goal : e.goals) {
        double start = 0.0;
        for (std::size_t k = 0; k < out.size(); ++k)
            if (!goal.after.empty() && e.goals[k].name == goal.after) start = out[k];
        out.push_back(start + goal.when.hold);
    }
    return out;
}

}  // namespace

void check_task(const exercise::Exercise& e, Findings& out) {
    for (std::size_t i = 0; i < e.phases.size(); ++i)
        if (e.phases[i].goal.empty())
            out.add(false, FindingKind::phase, {e.phases[i].name}, static_cast<double>(i),
                    fmt::format("/phases/{}: the phase \"{}\" has no end condition; name the "
                                "goal that ends it (\"goal\")",
                                i, e.phases[i].name));
    const std::vector<double> earliest = earliest_times(e);
    for (std::size_t i = 0; i < e.goals.size(); ++i) {
        const exercise::Goal& goal = e.goals[i];
        const double latest = std::min(goal.by.value_or(e.duration), e.duration);
        if (earliest[i] <= latest) continue;
        out.add(false, FindingKind::goal, {goal.name}, earliest[i] - latest,
                fmt::format("/goals/{}/{}: no control can reach the goal \"{}\" in time: it counts "
                            "until {:.6g} s, and hold times of it and of goals before it end at "
                            "{:.6g} s or later",
                            i, goal.by && *goal.by <= e.duration ? "by" : "hold", goal.name, latest,
                            earliest[i]));
    }
    for (std::size_t i = 0; i < e.stations.size(); ++i)
        if (e.stations[i].inputs.empty())
            out.add(false, FindingKind::station, {e.stations[i].name}, static_cast<double>(i),
                    fmt::format("/stations/{}/inputs: the station \"{}\" has no inputs: its role "
                                "can set nothing",
                                i, e.stations[i].name));
}

namespace {

/// Range of a control as a slider shows it; unlimited ends are infinite.
struct ControlRange {
    double min = -kUnbounded, max = kUnbounded;
    bool signal = false;  ///< True if it is a signal without an input of the exercise.
};

ControlRange control_range(const scene::Scene& scene, const std::string& name) {
    constexpr double kNoLimit = 1e29;
    const auto limited = [](double min, double max, bool signal) {
        return ControlRange{min < -kNoLimit ? -kUnbounded : min, max > kNoLimit ? kUnbounded : max,
                            signal};
    };
    const World& world = scene.world;
    if (const InputId id = world.find_input(name); id.valid()) {
        const InputDef& def = world.input_def(id);
        return limited(def.min, def.max, false);
    }
    for (const scene::SignalInput& control : scene.signal_inputs)
        if (control.name == name) return limited(control.min, control.max, false);
    for (const SystemSignal& s : world.system_signals())
        if (s.input && s.system + "." + s.name == name) return limited(s.min, s.max, true);
    return {};
}

}  // namespace

void check_controls(const exercise::Exercise& e, const scene::Scene& scene, Findings& out) {
    constexpr double kWidestSignal = 20.0;  // span of a signal that serves as a control by itself
    for (std::size_t i = 0; i < e.stations.size(); ++i)
        for (std::size_t k = 0; k < e.stations[i].inputs.size(); ++k) {
            const std::string& name = e.stations[i].inputs[k];
            const ControlRange range = control_range(scene, name);
            const double span = range.max - range.min;
            if (std::isfinite(span) && (!range.signal || span <= kWidestSignal)) continue;
            out.add(false, FindingKind::range, {name}, static_cast<double>(i),
                    fmt::format("/stations/{}/inputs/{}: the control \"{}\" has {}; {} with "
                                "\"min\" and \"max\"",
                                i, k, name,
                                std::isfinite(span) ? "the range of its signal, which is far "
                                                      "beyond that of a real control"
                                                    : "no range",
                                range.signal ? "define an input" : "define it"));
        }
}

}  // namespace hawser::report::start
