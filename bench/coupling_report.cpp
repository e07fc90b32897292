// SPDX-License-Identifier: Apache-2.0
#include "coupling_report.h"

#include "linear/timing.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hawser::bench::split {
namespace {

/// Return the value, or null if it was not measured.
Json value_or_null(double value, bool measured) { return measured ? Json(value) : Json(); }

std::string printed(double value, bool measured, const char* format = "{:.2g}") {
    return measured ? fmt::format(fmt::runtime(format), value) : "-";
}

/// Return the index of a number of threads among those timed; their count if it is not.
std::size_t thread_index(const CouplingOptions& o, int threads) {
    return static_cast<std::size_t>(std::find(o.threads.begin(), o.threads.end(), threads) -
                                    o.threads.begin());
}

}  // namespace

Json row_of(const ModeFigures& m, const CouplingOptions& o) {
    const Quality& q = m.quality;
    const verify::CouplingFigures& f = q.figures;
    const bool split = m.mode.coupling != Coupling::exact;
    const bool some_steps = f.steps > 1;  // jerk needs three velocities
    const bool searched = m.stiffness.stable > 0.0 || m.stiffness.unstable > 0.0;
    Json times = Json::object(), predicted = Json::object();
    for (std::size_t k = 0; k < kSimulatedThreads.size(); ++k)
        predicted[std::to_string(kSimulatedThreads[k])] =
            value_or_null(m.simulated.ms[k], m.simulated.steps > 0);
    for (std::size_t t = 0; t < o.threads.size(); ++t) {
        const bool some = !m.timed[t].wall.empty();
        times[std::to_string(o.threads[t])] = {
            {"step_ms", some ? Json(median(m.timed[t].wall)) : Json()},
            {"solver_cpu_ms", some ? Json(median(m.timed[t].cpu)) : Json()},
            {"steps", m.timed[t].wall.size()}};
    }
    return {{"mode", m.mode.name()},
            {"cuts", q.cuts},
            {"islands", q.islands},
            {"threads", times},
            {"simulated_step_ms", predicted},
            {"serial_share", value_or_null(m.simulated.serial, m.simulated.steps > 0)},
            {"lost_at", value_or_null(q.time_of_loss, q.failed_or_diverged())},
            {"momentum_defect", {{"rms", f.defect_rms}, {"max", f.defect_max}}},
            {"interface_residual", value_or_null(f.residual_max, split)},
            {"jerk",
             {{"run", value_or_null(f.jerk_max, some_steps)},
              {"exact", value_or_null(f.jerk_exact_max, split && some_steps)},
              {"difference", value_or_null(f.jerk_difference_max, split && some_steps)}}},
            {"tension_error",
             {{"rms", value_or_null(f.tension_error_rms, split)},
              {"max", value_or_null(f.tension_error_max, split)}}},
            {"energy_drift", value_or_null(q.energy_drift, some_steps)},
            {"energy_exchanged", value_or_null(q.energy_exchanged, some_steps)},
            {"spectral_radius", value_or_null(f.spectral_radius, !q.failed_or_diverged())},
            {"largest_stable_stiffness",
             {{"stable", value_or_null(m.stiffness.stable, searched)},
              {"unstable", value_or_null(m.stiffness.unstable, m.stiffness.unstable > 0.0)}}}};
}

void print_row(const ModeFigures& m) {
    const Quality& q = m.quality;
    const verify::CouplingFigures& f = q.figures;
    const bool split = m.mode.coupling != Coupling::exact, some_steps = f.steps > 1;
    fmt::print("  {:<17} {:>5} {:>7}", m.mode.name(), q.cuts, q.islands);
    for (const Timed& t : m.timed) {
        const bool some = !t.wall.empty();
        fmt::print(" {:>8} {:>8}", printed(some ? median(t.wall) : 0.0, some, "{:.3f}"),
                   printed(some ? median(t.cpu) : 0.0, some, "{:.3f}"));
    }
    std::string stable = "-";
    if (m.stiffness.stable > 0.0 || m.stiffness.unstable > 0.0)
        stable = fmt::format("{}{:.2g}", m.stiffness.is_accurate() ? "" : ">", m.stiffness.stable);
    fmt::print(" {:>9.1e} {:>9} {:>9} {:>9} {:>9} {:>8} {:>9}", f.defect_max,
               printed(f.jerk_max, some_steps), printed(f.jerk_exact_max, split && some_steps),
               printed(100.0 * f.tension_error_rms, split), printed(q.energy_drift, some_steps),
               printed(f.spectral_radius, !q.failed_or_diverged(), "{:.4f}"), stable);
    if (q.failed_or_diverged()) fmt::print("  ran away at {:.2f} s", q.time_of_loss);
    fmt::print("\n");
}

void print_simulated(const std::vector<ModeFigures>& modes, const CouplingOptions& o) {
    const std::size_t two = thread_index(o, 2);
    fmt::print("  SIMULATED from one thread's spans [ms]\n  {:<17}", "");
    for (const int t : kSimulatedThreads) fmt::print(" {:>8}", fmt::format("{} t", t));
    fmt::print(" {:>13} {:>8}  serial by stage\n", "2 t, of meas.", "serial");
    for (const ModeFigures& m : modes) {
        const SimulatedStep& s = m.simulated;
        fmt::print("  {:<17}", m.mode.name());
        for (const double ms : s.ms) fmt::print(" {:>8.3f}", ms);
        const bool measured = two < o.threads.size() && !m.timed[two].wall.empty();
        fmt::print(
            " {:>13}",
            measured ? fmt::format("{:+.0f} %", 100.0 * (s.ms[1] / median(m.timed[two].wall) - 1.0))
                     : std::string("-"));
        fmt::print(" {:>6.0f} % ", 100.0 * s.serial);
        for (int k = 0; k < kStageCount; ++k)
            if (s.serial_of[static_cast<std::size_t>(k)] >= 0.02)
                fmt::print(" {} {:.0f}", to_string(static_cast<Stage>(k)),
                           100.0 * s.serial_of[static_cast<std::size_t>(k)]);
        fmt::print("\n");
    }
}

Json compare_exact(const std::vector<ModeFigures>& modes, const std::string& scene,
                   const CouplingOptions& o, Verdict& verdict) {
    constexpr double kBar = 1.15;
    Json out = Json::array();
    for (std::size_t t = 0; t < o.threads.size(); ++t) {
        const ModeFigures* best = nullptr;
        for (const ModeFigures& m : modes)
            if (m.mode.coupling != Coupling::exact && !m.quality.failed_or_diverged() &&
                !m.timed[t].failed_or_diverged &&
                (!best || median(m.timed[t].wall) < median(best->timed[t].wall)))
                best = &m;
        const bool judged = o.threads[t] == 2;
        if (!best) {
            const std::string what =
                fmt::format("on {} thread(s) no split stayed within bounds", o.threads[t]);
            if (judged)
                verdict.require("exact_step_time", scene, true, what);
            else
                fmt::print("  {}\n", what);
            continue;
        }
        const double wall = median(modes[0].timed[t].wall) / median(best->timed[t].wall),
                     cpu = median(modes[0].timed[t].cpu) / median(best->timed[t].cpu);
        const std::string what = fmt::format(
            "on {} thread(s) exact takes {:.2f} of the step time of {} ({:.2f} of its cpu)",
            o.threads[t], wall, best->mode.name(), cpu);
        if (judged)
            verdict.require("exact_step_time", scene, wall <= kBar,
                            fmt::format("{} (bar: {:.2f})", what, kBar));
        else
            fmt::print("  {}\n", what);
        out.push_back({{"threads", o.threads[t]},
                       {"fastest_split", best->mode.name()},
                       {"step_ratio", wall},
                       {"cpu_ratio", cpu}});
    }
    return out;
}

}  // namespace hawser::bench::split
