// SPDX-License-Identifier: Apache-2.0
// hawser-bench deadline: a scene whose load doubles for a while, in full and within a budget.
#include "commands.h"
#include "deadline_load.h"
#include "observe/control.h"
#include "observe/degradations.h"
#include "observe/host.h"
#include "observe/summary.h"
#include "scene/scene.h"

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

constexpr int kPhases = 3, kUncounted = 60, kExactRow = 10;
constexpr const char* kPhaseNames[kPhases] = {"before", "load", "after"};

struct DeadlineOptions {
    std::string scene = "scenes/anchor_contact.json";
    std::string control = "scenes/anchor_lines.control.csv", json;
    double budget_ms = 5.0;
    int stacks = 120, steps = 300, threads = 1;
};

/// What a phase of a run took and left.
struct PhaseFigures {
    std::vector<double> cpu, wall, map;  ///< [ms], [ms], [1]
    int contacts = 0, degraded = 0;
    double momentum = 0.0;     ///< Largest relative residual.
    double violation = 0.0;    ///< [m]
    double drift = 0.0;        ///< Σ |unexplained energy| of single steps [J].
    double exchanged = 0.0;    ///< Σ |change of kinetic + potential energy| [J].
    double penetration = 0.0;  ///< [m]
    double speed = 0.0;        ///< [m/s]
};

struct DeadlineRun {
    std::array<PhaseFigures, kPhases> phase;
    std::vector<Degradation> left_out;  ///< By step.
    observe::Degradations log;
    std::vector<Vec3> at_end_of_load;  ///< Where boxes were.
    std::uint64_t hash = 0;
    double step = 0.0;      ///< h [s]
    int exact_after = -1;   ///< Steps until the first of kExactRow exact ones in a row.
    int late_analysis = 0;  ///< Steps beyond the budget in which something was analysed.
};

double share_point(std::vector<double> v, double p) {
    if (v.empty()) return 0.0;
    std::sort(v.begin(), v.end());
    return v[static_cast<std::size_t>(p * static_cast<double>(v.size() - 1))];
}

/// One run of the scene. @param repeat  Degradations to impose; null: what the budget says.
class DeadlineRunner {
  public:
    DeadlineRunner(const DeadlineOptions& options, double budget_ms, const DeadlineRun* repeat)
        : o_(options),
          scene_(load(options, budget_ms)),
          cargo_(scene_.world, options.stacks),
          repeat_(repeat) {
        std::vector<std::string> names;
        for (std::int32_t i = 0; i < scene_.world.input_count(); ++i)
            names.push_back(scene_.world.input_def({i}).name);
        if (!options.control.empty()) control_ = observe::read_control(options.control, names);
    }

    DeadlineRun run() {
        for (int i = 0; i < kPhases * o_.steps; ++i) take(i);
        out_.hash = scene_.world.state_hash();
        out_.step = scene_.world.settings().step;
        return std::move(out_);
    }

  private:
    static scene::Scene load(const DeadlineOptions& o, double budget_ms) {
        scene::Options options;
        options.threads = o.threads;
        options.budget = 1e-3 * budget_ms;
        return scene::load_file(o.scene, options);
    }

    void take(int i) {
        World& w = scene_.world;
        for (; next_ < control_.size() && control_[next_].time <= w.time() + 1e-9; ++next_)
            w.set_input({control_[next_].input}, control_[next_].value);
        if (i == o_.steps) cargo_.set_down(w);
        if (i == 2 * o_.steps) {
            for (const BodyId b : cargo_.boxes()) out_.at_end_of_load.push_back(w.pose(b).position);
            cargo_.take_away(w);
        }
        cargo_.move_deck(w);
        if (repeat_) w.degrade_next_step(repeat_->left_out[static_cast<std::size_t>(i)]);
        if (w.step() != Status::ok)
            throw std::runtime_error(
                fmt::format("step {} failed: {}", i, to_string(w.stats().status)));
        note(i);
    }

    void note(int i) {
        const World& w = scene_.world;
        const StepStats& s = w.stats();
        PhaseFigures& f = out_.phase[static_cast<std::size_t>(i / o_.steps)];
        out_.left_out.push_back(s.degradation);
        if (i >= kUncounted) {
            f.cpu.push_back(1e3 * s.solver_cpu_seconds);
            f.wall.push_back(1e3 * s.step_seconds);
            f.map.push_back(s.natural_map);
            out_.log.after_step(s);
            f.degraded += s.degradation.any() ? 1 : 0;
            const bool analysed = s.plans + s.repairs > analyses_;
            out_.late_analysis += analysed && f.cpu.back() > o_.budget_ms ? 1 : 0;
        }
        analyses_ = s.plans + s.repairs;
        f.contacts = std::max(f.contacts, s.contacts);
        f.momentum = std::max(f.momentum, s.momentum_residual);
        f.violation = std::max(f.violation, s.violation_max);
        f.penetration = std::max(f.penetration, cargo_.penetration(w));
        f.speed = std::max(f.speed, cargo_.speed(w));
        const Energy now = w.energy();
        // Where boxes are moved by hand, energy comes from nowhere.
        if (i % o_.steps > 1) {
            f.drift += std::abs(observe::energy_drift(before_, now));
            f.exchanged += std::abs(now.kinetic - before_.kinetic) +
                           std::abs(now.gravity + now.elastic - before_.gravity - before_.elastic);
        }
        before_ = now;
        exact_row_ = s.degradation.any() ? 0 : exact_row_ + 1;
        const int after = i - 2 * o_.steps + 1;
        if (after > 0 && out_.exact_after < 0 && exact_row_ >= std::min(kExactRow, after))
            if (after >= kExactRow) out_.exact_after = std::max(0, after - exact_row_);
    }

    const DeadlineOptions& o_;
    scene::Scene scene_;
    DeckCargo cargo_;
    const DeadlineRun* repeat_;
    std::vector<observe::ControlChange> control_;
    std::size_t next_ = 0;
    std::int64_t analyses_ = 0;
    Energy before_;
    int exact_row_ = 0;
    DeadlineRun out_;
};

/// Share of the steps of all phases within a limit.
double share_within(const DeadlineRun& run, double limit_ms) {
    double in = 0.0, all = 0.0;
    for (const PhaseFigures& f : run.phase) {
        in += static_cast<double>(
            std::count_if(f.cpu.begin(), f.cpu.end(), [&](double x) { return x <= limit_ms; }));
        all += static_cast<double>(f.cpu.size());
    }
    return in / std::max(1.0, all);
}

void print_run(const char* name, const DeadlineRun& run) {
    for (std::size_t k = 0; k < kPhases; ++k) {
        const PhaseFigures& f = run.phase[k];
        fmt::print(
            "{:<8} {:<7} {:>8} {:>7.2f} {:>7.2f} {:>7.2f} {:>7.2f} {:>8.2f} {:>7.2f} {:>7.2f} "
            "{:>9} "
            "{:>9.1e} {:>9.1e}\n",
            name, kPhaseNames[k], f.contacts, share_point(f.cpu, 0.5), share_point(f.cpu, 0.95),
            share_point(f.cpu, 0.99), share_point(f.cpu, 1.0), share_point(f.wall, 0.5),
            share_point(f.wall, 0.95), share_point(f.wall, 0.99), f.degraded,
            share_point(f.map, 0.95), share_point(f.map, 1.0));
    }
}

double apart(const DeadlineRun& a, const DeadlineRun& b) {
    double most = 0.0;
    for (std::size_t k = 0; k < a.at_end_of_load.size(); ++k)
        most = std::max(most, (a.at_end_of_load[k] - b.at_end_of_load[k]).norm());
    return most;
}

/// Criteria, printed as they are asked.
class Verdict {
  public:
    void ask(bool holds, const std::string& what) {
        fmt::print("  {}  {}\n", holds ? "yes" : "NO ", what);
        good_ = good_ && holds;
    }
    [[nodiscard]] bool good() const noexcept { return good_; }

  private:
    bool good_ = true;
};

/// Whether the budgeted run kept to what no budget may change.
void ask_physics(Verdict& verdict, double h, const DeadlineRun& exact, const DeadlineRun& kept) {
    const PhaseFigures &e = exact.phase[1], &k = kept.phase[1];
    // Ten times what a step counts as solved with; steps that are solved leave 1e-14.
    verdict.ask(k.momentum <= 1e-9, fmt::format("momentum balanced: residual {:.1e} (exact {:.1e})",
                                                k.momentum, e.momentum));
    verdict.ask(k.violation <= std::max(2.0 * e.violation, 1e-3),
                fmt::format("joints hold: {:.2e} m (exact {:.2e} m)", k.violation, e.violation));
    verdict.ask(k.penetration <= std::max(2.0 * e.penetration, 5e-3),
                fmt::format("boxes do not sink in: {:.2f} mm (exact {:.2f} mm)",
                            1e3 * k.penetration, 1e3 * e.penetration));
    // Where the deck turns round, one iteration finds which way a box slides a step late: the lower
    // one is then pushed by three box weights' friction, on both its faces, for a step too long.
    const double late = 3.0 * DeckCargo::kFriction * 9.81 * h;
    verdict.ask(k.speed <= DeckCargo::kSpeed + late,
                fmt::format("no box is faster than the deck, {:.3f} m/s, and a step's friction, "
                            "{:.3f} m/s: {:.3f} m/s (exact {:.3f} m/s)",
                            DeckCargo::kSpeed, late, k.speed, e.speed));
    const double drift = k.drift / k.exchanged, least = e.drift / e.exchanged;
    verdict.ask(drift <= std::max(2.0 * least, 0.01),
                fmt::format("energy out of nothing: {:.2e} of what was exchanged (exact {:.2e})",
                            drift, least));
}

nlohmann::json run_json(const DeadlineRun& run) {
    nlohmann::json phases;
    for (std::size_t k = 0; k < kPhases; ++k) {
        const PhaseFigures& f = run.phase[k];
        const auto points = [](const std::vector<double>& v) {
            return nlohmann::json{{"p50", share_point(v, 0.5)},
                                  {"p95", share_point(v, 0.95)},
                                  {"p99", share_point(v, 0.99)},
                                  {"max", share_point(v, 1.0)}};
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
    const DeadlineRun exact = DeadlineRunner(o, 0.0, nullptr).run();
    const DeadlineRun kept = DeadlineRunner(o, o.budget_ms, nullptr).run();
    const DeadlineRun again = DeadlineRunner(o, 0.0, &kept).run();
    fmt::print("{}, {} boxes on a moving deck for {} of {} steps, {} thread(s), {}, {}\n\n",
               o.scene, DeckCargo::kHigh * o.stacks, o.steps, kPhases * o.steps, o.threads,
               instruction_set(), observe::processor_model());
    fmt::print("{:<16} {:>8} {:>31} {:>24} {:>9} {:>19}\n", "", "contact", "solver_cpu_ms",
               "step_ms (wall)", "degraded", "natural map");
    fmt::print("{:<16} {:>8} {:>7} {:>7} {:>7} {:>7} {:>8} {:>7} {:>7} {:>9} {:>9} {:>9}\n",
               "run, phase", "points", "p50", "p95", "p99", "max", "p50", "p95", "p99", "steps",
               "p95", "max");
    print_run("exact", exact);
    print_run("budget", kept);
    const observe::Degradations& d = kept.log;
    fmt::print("\nload: {:.2f} times the solver time of before in the exact run (medians)\n",
               share_point(exact.phase[1].cpu, 0.5) / share_point(exact.phase[0].cpu, 0.5));
    fmt::print(
        "degradations: friction iterations in {} steps, {} times: {} by prediction, {} by clock; "
        "another iteration would have ended by {:.2f} ms\n",
        d.all.steps, d.spans, d.by_cause[static_cast<std::size_t>(DegradedBy::prediction)],
        d.by_cause[static_cast<std::size_t>(DegradedBy::clock)], 1e3 * d.all.foreseen);
    fmt::print(
        "beyond the budget with a first touch analysed: {} steps; boxes {:.3f} m from where the "
        "exact "
        "run has them at the end of the load\n\n",
        kept.late_analysis, apart(exact, kept));
    Verdict verdict;
    const double within = share_within(kept, o.budget_ms);
    verdict.ask(within >= 0.99,
                fmt::format("{:.2f} % of steps within {} ms (exact: {:.2f} %)", 100.0 * within,
                            o.budget_ms, 100.0 * share_within(exact, o.budget_ms)));
    verdict.ask(kept.phase[1].degraded > 0, "the load had something degraded");
    verdict.ask(kept.exact_after >= 0 && kept.exact_after <= 60,
                fmt::format("exact again {} steps after the load ended ({} of the steps after that "
                            "degraded)",
                            kept.exact_after, kept.phase[2].degraded));
    ask_physics(verdict, kept.step, exact, kept);
    verdict.ask(again.hash == kept.hash,
                fmt::format("repeated without a clock: state hash {:016x}", again.hash));
    if (!o.json.empty())
        std::ofstream(o.json) << nlohmann::json{{"budget_ms", o.budget_ms},
                                                {"within", within},
                                                {"exact_again_steps", kept.exact_after},
                                                {"exact", run_json(exact)},
                                                {"budget", run_json(kept)}}
                                     .dump(2)
                              << '\n';
    return verdict.good() ? 0 : 1;
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
