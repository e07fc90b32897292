// SPDX-License-Identifier: Apache-2.0
#include <hawser/exercise.h>

#include "report/start/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace hawser::report::start {

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

}  // namespace hawser::report::start
