// SPDX-License-Identifier: Apache-2.0
// hawser-bench exercise: times of the steps of an exercise, relative to a scene at rest.
#include <hawser/exercise.h>
#include <hawser/hawser.h>

#include "commands.h"
#include "fraction_of.h"
#include "record/control.h"
#include "verdict.h"

#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace hawser::bench {
namespace {

constexpr const char* kExerciseFormula =
    R"(Runs alternate: the reference scene at rest, then the exercise with its control file, --runs times.
All runs of a scene have the same bits, so that the time of a step is the least over the runs. Times are wall
time of the whole step, with systems, monitors and scoring. Exit code 1 if a step failed, if two runs
differ, or if a bar is missed: median <= 2, 99 % <= 3 and worst <= 6 times the median of the reference, and
99.9 % of the steps below 16.7 ms.)";

struct ExerciseArguments {
    std::string exercise = "exercises/anchor_handling.json", control, csv;
    std::string reference = "scenes/anchor_contact.json";
    double reference_seconds = 20.0, until = 1e9;
    int runs = 3, threads = 2;
};

/// Work of a step: the same in all runs, and beside other programs.
struct StepWork {
    std::int32_t factorisations = 0, substitutions = 0, newton_iterations = 0;
    std::int32_t repeats = 0;  ///< Repeated solutions for wires and for larger joint forces.
    double factor_work = 0.0;  ///< Flops of the factorisations over those of one LDLᵀ [1].
    std::array<double, kStageCount> stage_ms{};  ///< Wall time of each stage in the last run [ms].
};

/// Least wall time of each step over repeated runs [ms], and the state at the end.
struct LeastTimes {
    std::vector<double> ms;
    std::vector<StepWork> work;  ///< Work of each step, of the last run.
    std::uint64_t hash = 0;
    double end = 0.0;  ///< Time at the end [s].
    bool repeats = true;

    void add(const std::vector<double>& run, std::uint64_t final_hash) {
        if (ms.empty()) {
            ms = run;
            hash = final_hash;
            return;
        }
        repeats = repeats && run.size() == ms.size() && final_hash == hash;
        for (std::size_t i = 0; i < std::min(ms.size(), run.size()); ++i)
            ms[i] = std::min(ms[i], run[i]);
    }
    [[nodiscard]] double at(double fraction) const { return fraction_of(ms, fraction); }
};

/// Run a step and append its wall time [ms]. @throws std::runtime_error if it fails.
template <class Step>
void time_step(std::vector<double>& ms, const World& world, Step&& step) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    const Status status = step();
    ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
    if (status != Status::ok)
        throw std::runtime_error(
            fmt::format("the step at {:.3f} s failed: {}", world.time(), to_string(status)));
}

void run_reference(const ExerciseArguments& arguments, LeastTimes& least) {
    scene::Options options;
    options.threads = arguments.threads;
    scene::Scene scene = scene::load_file(arguments.reference, options);
    World& world = scene.world;
    std::vector<double> ms;
    for (int i = 0; i < 60; ++i) (void)world.step();  // allocate and warm up
    while (world.time() < arguments.reference_seconds)
        time_step(ms, world, [&] { return world.step(); });
    least.add(ms, world.state().hash());
}

void run_exercise(const ExerciseArguments& arguments, LeastTimes& least) {
    scene::Options options;
    options.threads = arguments.threads;
    exercise::Loaded loaded = exercise::load_file(arguments.exercise, options);
    std::vector<std::string> inputs, roles;
    for (const exercise::Station& station : loaded.exercise.stations)
        for (const std::string& input : station.inputs) {
            inputs.push_back(input);
            roles.push_back(station.name);
        }
    const auto changes = record::read_control(arguments.control, inputs);
    Session session(std::move(loaded.scene));
    exercise::Run run(loaded.exercise, session);
    std::vector<double> ms;
    least.work.clear();
    std::size_t next = 0;
    while (!run.ended() && session.time() < arguments.until - 1e-6) {
        for (; next < changes.size() && changes[next].time <= session.time() + 1e-6; ++next) {
            const auto k = static_cast<std::size_t>(changes[next].input);
            run.set_input(roles[k], inputs[k], changes[next].value);
        }
        time_step(ms, session.world(), [&] { return run.step(); });
        const StepStats& stats = session.world().stats();
        least.work.push_back({stats.factorisations,
                              stats.substitutions,
                              stats.newton_iterations,
                              stats.wire_repeats + stats.restiffened,
                              stats.factor_work,
                              {}});
        for (std::size_t k = 0; k < kStageCount; ++k)
            least.work.back().stage_ms[k] = 1e3 * stats.stage_seconds[k];
    }
    least.end = session.time();
    least.add(ms, session.world().state().hash());
    fmt::print(stderr, "  {} to {:.1f} s: {}, {:.4g} points\n", loaded.exercise.name,
               session.time(), run.result().end, run.result().points);
}

void print_times(const std::string& name, const LeastTimes& t, double unit) {
    fmt::print("  {:<28} {:>7} {:>8.3f} {:>8.3f} {:>8.3f} {:>8.3f}   {:>5.2f} {:>5.2f} {:>5.2f}\n",
               name, t.ms.size(), t.at(0.5), t.at(0.99), t.at(0.999), t.at(1.0), t.at(0.5) / unit,
               t.at(0.99) / unit, t.at(1.0) / unit);
}

/// Print the mean time of each stage, over all steps and over the slowest 2 %.
void print_stages(const LeastTimes& t) {
    const double slow = t.at(0.98);
    std::array<double, kStageCount> all{}, slowest{};
    double steps = 0.0, slow_steps = 0.0;
    for (std::size_t i = 0; i < t.ms.size(); ++i) {
        steps += 1.0;
        if (t.ms[i] >= slow) slow_steps += 1.0;
        for (std::size_t k = 0; k < kStageCount; ++k) {
            all[k] += t.work[i].stage_ms[k];
            if (t.ms[i] >= slow) slowest[k] += t.work[i].stage_ms[k];
        }
    }
    fmt::print("  mean time of a stage in the last run [ms]: all steps, slowest 2 %\n");
    for (std::size_t k = 0; k < kStageCount; ++k)
        fmt::print("    {:<12} {:>7.3f} {:>7.3f}\n", to_string(static_cast<Stage>(k)),
                   all[k] / steps, slowest[k] / slow_steps);
}

int report_times(const ExerciseArguments& arguments, const LeastTimes& rest,
                 const LeastTimes& sailed) {
    const double unit = rest.at(0.5);
    fmt::print("{} thread(s), {}, least of {} runs, wall time of a step [ms]\n", arguments.threads,
               instruction_set(), arguments.runs);
    fmt::print("  {:<28} {:>7} {:>8} {:>8} {:>8} {:>8}   {:>5} {:>5} {:>5}\n", "", "steps",
               "median", "99 %", "99.9 %", "worst", "p50/r", "p99/r", "max/r");
    print_times(arguments.reference, rest, unit);
    print_times(arguments.exercise, sailed, unit);
    print_stages(sailed);
    const auto slow = std::max_element(sailed.ms.begin(), sailed.ms.end()) - sailed.ms.begin();
    fmt::print("  end at {:.2f} s, state {:016x}; slowest step {} at {:.2f} s\n", sailed.end,
               sailed.hash, slow,
               sailed.end * static_cast<double>(slow + 1) / static_cast<double>(sailed.ms.size()));
    Verdict verdict;
    verdict.require("repeats", "", rest.repeats && sailed.repeats, "the runs have the same bits");
    const auto bar = [&](const char* name, double fraction, double limit) {
        const double ratio = sailed.at(fraction) / unit;
        verdict.require(
            name, "", ratio <= limit,
            fmt::format("{} {:.2f} of {:g} times the median at rest", name, ratio, limit));
    };
    bar("median", 0.5, 2.0);
    bar("99 %", 0.99, 3.0);
    bar("worst", 1.0, 6.0);
    verdict.require("frame", "", sailed.at(0.999) < 1e3 / 60.0,
                    fmt::format("99.9 % of the steps within {:.3g} of 16.7 ms", sailed.at(0.999)));
    return verdict.exit_code();
}

}  // namespace

int exercise_command(int argc, char** argv) {
    CLI::App app("Times of the steps of an exercise, relative to a scene at rest.",
                 "hawser-bench exercise");
    ExerciseArguments a;
    app.add_option("EXERCISE", a.exercise, "Exercise file")->capture_default_str();
    app.add_option("--control", a.control, "Control file; default: that beside the exercise");
    app.add_option("--reference", a.reference, "Scene at rest")->capture_default_str();
    app.add_option("--until", a.until, "End of the exercise [s]; default: its own end")
        ->check(CLI::PositiveNumber);
    app.add_option("--runs", a.runs, "Runs of each")
        ->capture_default_str()
        ->check(CLI::Range(1, 99));
    app.add_option("--threads", a.threads, "Threads")
        ->capture_default_str()
        ->check(CLI::Range(1, 256));
    app.add_option("--csv", a.csv, "Write the time and the work of each step to this file");
    app.footer(kExerciseFormula);
    CLI11_PARSE(app, argc, argv);
    if (a.control.empty())
        a.control = a.exercise.substr(0, a.exercise.rfind(".json")) + ".control.csv";
    LeastTimes rest, sailed;
    for (int run = 0; run < a.runs; ++run) {
        run_reference(a, rest);
        run_exercise(a, sailed);
    }
    if (!a.csv.empty()) {
        std::ofstream csv(a.csv);
        csv << "step,ms,factorisations,factor_work,newton_iterations,substitutions,repeats\n";
        for (std::size_t i = 0; i < sailed.ms.size(); ++i) {
            const StepWork& w = sailed.work[i];
            csv << fmt::format("{},{:.4f},{},{:.3f},{},{},{}\n", i, sailed.ms[i], w.factorisations,
                               w.factor_work, w.newton_iterations, w.substitutions, w.repeats);
        }
    }
    return report_times(a, rest, sailed);
}

}  // namespace hawser::bench
