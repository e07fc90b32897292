// SPDX-License-Identifier: Apache-2.0
#include "linear/schedule.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace hawser::bench {

void print_schedule_head(const PoolCosts& costs) {
    fmt::print(
        "Task times of one thread, dealt out to p threads by the simulator. A loop costs {:.2f} us "
        "until\nanother thread has begun and {:.2f} us to join; a task costs {:.3f} us to take.\n"
        "{:<18} {:<14} {:>9} {:>9} {:>9} {:>6} {:>5}  {:>5} {:>5} {:>5} {:>5} {:>5} {:>7} {:>7}\n",
        1e6 * costs.start, 1e6 * costs.join, 1e6 * costs.deal, "matrix", "work", "T(1) ms",
        "T(2) ms", "simulated", "dev", "x 2", "x 4", "x 8", "x 16", "x 32", "x 64", "serial",
        "path");
}

void print_schedule(const ScheduleReport& r) {
    auto line = [&](const char* what, const ScheduleTimes& t) {
        fmt::print(
            "{:<18} {:<14} {:>9.4g} {:>9.4g} {:>9.4g} {:>5.1f}% {:>5.2f}{} {:>5.2f} {:>5.2f} "
            "{:>5.2f} {:>5.2f} {:>5.2f} {:>6.1f}% {:>6.1f}%\n",
            r.name, what, 1e3 * t.one, 1e3 * t.two, 1e3 * t.predicted[1], 100.0 * t.deviation(),
            t.one / t.two, r.quiet ? ' ' : '*', t.speed_up[2], t.speed_up[3], t.speed_up[4],
            t.speed_up[5], t.speed_up[6], 100.0 * t.serial / t.predicted[0],
            100.0 * t.critical / t.predicted[0]);
    };
    line("factor + solve", r.solve);
    line("all", r.whole);
}

void print_schedule_loops(const ScheduleReport& r) {
    fmt::print("{:>20} {:>10} {:>10} {:>12} {:>8} {:>8}\n", "phase", "T(1) us", "T(2) us",
               "simulated us", "dev", "gain");
    for (const SchedulePhase& p : r.phases)
        fmt::print("{:>20} {:>10.2f} {:>10.2f} {:>12.2f} {:>7.1f}% {:>8.2f}\n", p.name, 1e6 * p.one,
                   1e6 * p.two, 1e6 * p.predicted, 100.0 * (p.predicted / p.two - 1.0),
                   p.one / p.two);
    fmt::print("{:>20} {:>6} {:>12} {:>10} {:>10} {:>10} {:>8}\n", "phase", "tasks", "before us",
               "tasks us", "path us", "8 threads", "speed-up");
    for (const ScheduleLoop& l : r.loops) {
        if (l.tasks == 0)
            fmt::print("{:>20} {:>6} {:>12.2f}\n", l.phase, "-", 1e6 * l.before);
        else
            fmt::print("{:>20} {:>6} {:>12.2f} {:>10.2f} {:>10.2f} {:>10.2f} {:>8.2f}\n", l.phase,
                       l.tasks, 1e6 * l.before, 1e6 * l.sum, 1e6 * l.path, 1e6 * l.eight,
                       l.sum / l.eight);
    }
    if (r.disturbed > 0)
        fmt::print("  {} of {} samples were disturbed by other programs and taken again\n",
                   r.disturbed, r.samples);
}

nlohmann::json to_json(const ScheduleReport& r) {
    auto times = [](const ScheduleTimes& t) {
        return nlohmann::json{{"t1_ms", 1e3 * t.one},
                              {"t2_ms", 1e3 * t.two},
                              {"t1_best_ms", 1e3 * t.one_best},
                              {"t2_best_ms", 1e3 * t.two_best},
                              {"simulated_seconds", t.predicted},
                              {"simulated_speed_up", t.speed_up},
                              {"deviation", t.deviation()},
                              {"serial_ms", 1e3 * t.serial},
                              {"critical_ms", 1e3 * t.critical}};
    };
    nlohmann::json loops = nlohmann::json::array(), phases = nlohmann::json::array();
    for (const SchedulePhase& p : r.phases)
        phases.push_back({{"phase", p.name},
                          {"t1_us", 1e6 * p.one},
                          {"t2_us", 1e6 * p.two},
                          {"simulated_us", 1e6 * p.predicted}});
    for (const ScheduleLoop& l : r.loops)
        loops.push_back({{"phase", l.phase},
                         {"tasks", l.tasks},
                         {"before_us", 1e6 * l.before},
                         {"sum_us", 1e6 * l.sum},
                         {"path_us", 1e6 * l.path},
                         {"eight_us", 1e6 * l.eight}});
    return {{"matrix", r.name},
            {"form", r.form},
            {"threads", kScheduleThreads},
            {"factor_solve", times(r.solve)},
            {"all", times(r.whole)},
            {"phases", phases},
            {"loops", loops},
            {"samples", r.samples},
            {"disturbed", r.disturbed}};
}

}  // namespace hawser::bench
