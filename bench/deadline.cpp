// SPDX-License-Identifier: Apache-2.0
// hawser-bench deadline: a scene whose load doubles temporarily, without and with a budget.
#include "commands.h"
#include "deadline_load.h"
#include "deadline_run.h"
#include "record/host.h"
#include "verdict.h"

#include <fmt/core.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>

namespace hawser::bench {
namespace {

constexpr const char* kFooter = R"(Phases of equal length: before the load, with it, after it.
Exit code 1 where a criterion is not met: 99 % of steps within the budget (solver_cpu_ms, the first
60 steps left out), something degraded under the load, exact again within 60 steps after it, the state
physical, and the same state hash when the degradations are repeated without a clock.)";

double quantile(std::vector<double> v, double p) {
    if (v.empty()) return 0.0;
    std::sort(v.begin(), v.end());
    return v[static_cast<std::size_t>(p * static_cast<double>(v.size() - 1))];
}

/// Return the fraction of the steps of all phases within a limit.
double fraction_within(const DeadlineRun& run, double limit_ms) {
    double in = 0.0, all = 0.0;
    for (const PhaseFigures& f : run.phase) {
        in += static_cast<double>(
            std::count_if(f.cpu.begin(), f.cpu.end(), [&](double x) { return x <= limit_ms; }));
        all += static_cast<double>(f.cpu.size());
    }
    return in / std::max(1.0, all);
}

void print_run(const char* name, const DeadlineRun& run) {
    for (std::size_t k = 0; k < kDeadlinePhases; ++k) {
        const PhaseFigures& f = run.phase[k];
        fmt::print(
            "{:<8} {:<7} {:>8} {:>7.2f} {:>7.2f} {:>7.2f} {:>7.2f} {:>8.2f} {:>7.2f} {:>7.2f} "
            "{:>9} "
            "{:>9.1e} {:>9.1e}\n",
            name, kPhaseNames[k], f.contacts, quantile(f.cpu, 0.5), quantile(f.cpu, 0.95),
            quantile(f.cpu, 0.99), quantile(f.cpu, 1.0), quantile(f.wall, 0.5),
            quantile(f.wall, 0.95), quantile(f.wall, 0.99), f.degraded, quantile(f.map, 0.95),
            quantile(f.map, 1.0));
    }
}

double separation(const DeadlineRun& a, const DeadlineRun& b) {
    double most = 0.0;
    for (std::size_t k = 0; k < a.at_end_of_load.size(); ++k)
        most = std::max(most, (a.at_end_of_load[k] - b.at_end_of_load[k]).norm());
    return most;
}

/// Check properties that a budget may not change.
void check_physics(Verdict& verdict, double h, const DeadlineRun& exact, const DeadlineRun& kept) {
    const PhaseFigures &e = exact.phase[1], &k = kept.phase[1];
    // Ten times the tolerance of a solved step; solved steps reach 1e-14.
    verdict.require(
        "momentum", "", k.momentum <= 1e-9,
        fmt::format("momentum balanced: residual {:.1e} (exact {:.1e})", k.momentum, e.momentum));
    verdict.require(
        "joints", "", k.violation <= std::max(2.0 * e.violation, 1e-3),
        fmt::format("joints hold: {:.2e} m (exact {:.2e} m)", k.violation, e.violation));
    verdict.require("penetration", "", k.penetration <= std::max(2.0 * e.penetration, 5e-3),
                    fmt::format("boxes do not sink in: {:.2f} mm (exact {:.2f} mm)",
                                1e3 * k.penetration, 1e3 * e.penetration));
    // When the deck reverses, one iteration finds a box's sliding direction a step late. The lower
    // box is then pushed by the friction of three box weights, on both faces, for one step more.
    const double late = 3.0 * DeckCargo::kFriction * 9.81 * h;
    verdict.require(
        "speed", "", k.speed <= DeckCargo::kSpeed + late,
        fmt::format("no box is faster than the deck, {:.3f} m/s, and a step's friction, "
                    "{:.3f} m/s: {:.3f} m/s (exact {:.3f} m/s)",
                    DeckCargo::kSpeed, late, k.speed, e.speed));
    const double drift = k.drift / k.exchanged, least = e.drift / e.exchanged;
    verdict.require(
        "energy", "", drift <= std::max(2.0 * least, 0.01),
        fmt::format("energy out of nothing: {:.2e} of what was exchanged (exact {:.2e})", drift,
                    least));
}

nlohmann::json run_json(const DeadlineRun& run) {
    nlohmann::json phases;
    for (std::size_t k = 0; k < kDeadlinePhases; ++k) {
        const PhaseFigures& f = run.phase[k];
        const auto points = [](const std::vector<double>& v) {
            return nlohmann::json{{"p50", quantile(v, 0.5)},
                                  {"p95", quantile(v, 0.95)},
                                  {"p99", quantile(v, 0.99)},
                                  {"max", quantile(v, 1.0)}};
        };
        phases[kPhaseNames[k]] = {{"contacts", f.contacts},
                                  {"solver_cpu_ms", points(f.cpu)},
                                  {"step_ms", points(f.wall)},
                                  {"natural_map", points(f.map)},
                                  {"degraded", f.degraded},
                                  {"momentum_residual", f.momentum},
                                  {"violation", f.violation},
                                  {"penetration", f.penetration},
                                  {"speed", f.speed},
                                  {"energy_drift", f.drift},
                                  {"energy_exchanged", f.exchanged}};
    }
    return phases;
}

int compare_deadline(const DeadlineOptions& o) {
    const DeadlineRun exact = run_deadline(o, 0.0, nullptr);
    const DeadlineRun kept = run_deadline(o, o.budget_ms, nullptr);
    const DeadlineRun again = run_deadline(o, 0.0, &kept);
    fmt::print("{}, {} boxes on a moving deck for {} of {} steps, {} thread(s), {}, {}\n\n",
               o.scene, DeckCargo::kHigh * o.stacks, o.steps, kDeadlinePhases * o.steps, o.threads,
               instruction_set(), record::processor_model());
    fmt::print("{:<16} {:>8} {:>31} {:>24} {:>9} {:>19}\n", "", "contact", "solver_cpu_ms",
               "step_ms (wall)", "degraded", "natural map");
    fmt::print("{:<16} {:>8} {:>7} {:>7} {:>7} {:>7} {:>8} {:>7} {:>7} {:>9} {:>9} {:>9}\n",
               "run, phase", "points", "p50", "p95", "p99", "max", "p50", "p95", "p99", "steps",
               "p95", "max");
    print_run("exact", exact);
    print_run("budget", kept);
    const report::Degradations& d = kept.log;
    fmt::print("\nload: {:.2f} times the solver time of before in the exact run (medians)\n",
               quantile(exact.phase[1].cpu, 0.5) / quantile(exact.phase[0].cpu, 0.5));
    fmt::print(
        "degradations: friction iterations in {} steps, {} times: {} by prediction, {} by clock; "
        "another iteration would have ended by {:.2f} ms\n",
        d.all.steps, d.spans, d.by_cause[static_cast<std::size_t>(DegradedBy::prediction)],
        d.by_cause[static_cast<std::size_t>(DegradedBy::clock)], 1e3 * d.all.foreseen);
    fmt::print(
        "beyond the budget: {} steps with a first touch analysed, {} with one iteration, {} "
        "with more\n",
        kept.late_with_analysis, kept.late_with_one_iteration, kept.late_with_more_iterations);
    fmt::print("boxes {:.3f} m from where the exact run has them at the end of the load\n\n",
               separation(exact, kept));
    Verdict verdict;
    const double within = fraction_within(kept, o.budget_ms);
    verdict.require("within_budget", "", within >= 0.99,
                    fmt::format("{:.2f} % of steps within {} ms (exact: {:.2f} %)", 100.0 * within,
                                o.budget_ms, 100.0 * fraction_within(exact, o.budget_ms)));
    verdict.require("degraded_under_load", "", kept.phase[1].degraded > 0,
                    "the load had something degraded");
    verdict.require(
        "exact_again", "", kept.exact_after >= 0 && kept.exact_after <= 60,
        fmt::format("exact again {} steps after the load ended ({} of the steps after that "
                    "degraded)",
                    kept.exact_after, kept.phase[2].degraded));
    check_physics(verdict, kept.step, exact, kept);
    verdict.require("repeatable", "", again.hash == kept.hash,
                    fmt::format("repeated without a clock: state hash {:016x}", again.hash));
    if (!o.json.empty())
        std::ofstream(o.json) << nlohmann::json{{"budget_ms", o.budget_ms},
                                                {"within", within},
                                                {"exact_again_steps", kept.exact_after},
                                                {"exact", run_json(exact)},
                                                {"budget", run_json(kept)},
                                                {"verdicts", verdict.json()}}
                                     .dump(2)
                              << '\n';
    return verdict.exit_code();
}

}  // namespace

int deadline_command(int argc, char** argv) {
    CLI::App app("Steps within a budget while the load of a scene doubles.",
                 "hawser-bench deadline");
    app.footer(kFooter);
    DeadlineOptions o;
    app.add_option("SCENE", o.scene, "Scene file")->capture_default_str();
    app.add_option("--control", o.control, "Input values over time (CSV); empty: none")
        ->capture_default_str();
    app.add_option("--budget", o.budget_ms,
                   "CPU time of the solver's slowest thread in a step [ms]")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    app.add_option("--stacks", o.stacks, "Stacks of two boxes that are the load")
        ->check(CLI::Range(1, 2000))
        ->capture_default_str();
    app.add_option("--steps", o.steps, "Steps of a phase, at least 100")
        ->check(CLI::Range(100, 100000))
        ->capture_default_str();
    app.add_option("--threads", o.threads, "Threads")->check(CLI::Range(1, 256));
    app.add_option("--json", o.json, "Write the figures to this file");
    CLI11_PARSE(app, argc, argv);
    return compare_deadline(o);
}

}  // namespace hawser::bench
