// SPDX-License-Identifier: Apache-2.0
// hawser-bench step: median time of a whole step, memory, and their growth with the scene. With
// --seaway, the distribution of costs over the steps of a run with forced hulls.
#include <hawser/scene.h>

#include "commands.h"
#include "coupling_simulated.h"
#include "step_seaway.h"

#include <fmt/core.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <tuple>

namespace hawser::bench {
namespace {

struct Figures {
    int scale = 1, bodies = 0, equations = 0, islands = 0;
    double median_ms = 0.0, p99_ms = 0.0, bytes_per_body = 0.0;
    std::array<double, kStageCount> stage_ms{};

    [[nodiscard]] double us_per_body() const { return 1e3 * median_ms / bodies; }
    /// Return a bandwidth if all memory of the world passes once per step: a lower bound.
    [[nodiscard]] double gb_per_s() const { return 1e-6 * bytes_per_body * bodies / median_ms; }
};

double step_percentile(std::vector<double> v, double p) {
    if (v.empty()) return 0.0;
    std::sort(v.begin(), v.end());
    return v[static_cast<std::size_t>(p * static_cast<double>(v.size() - 1))];
}

/// A world that is timed in turns with others.
struct Subject {
    scene::Scene scene;
    int scale;
    std::vector<double> ms;
    std::array<std::vector<double>, kStageCount> stages;

    void run(int steps, bool count) {
        for (int i = 0; i < steps; ++i) {
            if (scene.world.step() != Status::ok)
                throw std::runtime_error(fmt::format("scale {}: step failed: {}", scale,
                                                     to_string(scene.world.stats().status)));
            if (!count) continue;
            ms.push_back(1e3 * scene.world.stats().step_seconds);
            for (std::size_t s = 0; s < kStageCount; ++s)
                stages[s].push_back(1e3 * scene.world.stats().stage_seconds[s]);
        }
    }

    [[nodiscard]] Figures figures() const {
        const StepStats& s = scene.world.stats();
        Figures f;
        f.scale = scale;
        f.bodies = s.bodies;
        f.equations = s.equations;
        f.islands = s.islands;
        f.median_ms = step_percentile(ms, 0.5);
        f.p99_ms = step_percentile(ms, 0.99);
        f.bytes_per_body = static_cast<double>(scene.world.solver().memory_bytes()) / s.bodies;
        for (std::size_t k = 0; k < kStageCount; ++k)
            f.stage_ms[k] = step_percentile(stages[k], 0.5);
        return f;
    }
};

/// Print the step times of a scene with more threads than the machine may have, simulated from the
/// task times of one thread. The costs of the pool are measured here.
void print_simulated_schedule(const std::string& file, int scale) {
    constexpr std::size_t kSpans = std::size_t{1} << 20U;
    constexpr int kWarm = 60, kSteps = 60;
    scene::Options options;
    options.scale = scale;
    scene::Scene scene = scene::load_file(file, options);
    for (int i = 0; i < kWarm + kSteps; ++i) {
        if (i == kWarm) scene.world.solver().start_trace(kSpans);
        if (scene.world.step() != Status::ok) throw std::runtime_error("a traced step failed");
    }
    const split::SimulatedStep s = split::simulate_steps(scene.world, measure_pool_costs());
    fmt::print("simulated schedule of {} steps at scale {}, from the spans of one thread:\n",
               s.steps, scale);
    fmt::print("{:>8} {:>10} {:>9}\n", "threads", "ms", "speed-up");
    for (std::size_t k = 0; k < s.ms.size(); ++k)
        fmt::print("{:>8} {:>10.4g} {:>9.2f}\n", split::kSimulatedThreads[k], s.ms[k],
                   s.ms[0] / s.ms[k]);
    fmt::print("serial: {:.0f} % of the step, by stage", 100.0 * s.serial);
    for (int k = 0; k < kStageCount; ++k)
        if (const double share = s.serial_of[static_cast<std::size_t>(k)]; share >= 0.01)
            fmt::print(" {} {:.0f} %", to_string(static_cast<Stage>(k)), 100.0 * share);
    fmt::print("\n");
}

/// Options of --seaway, and their parsed values.
struct SeawayArguments {
    bool on = false;
    SeawayOptions options;
    std::vector<std::tuple<std::string, double, double, double, double>> hulls;

    void add_to(CLI::App& app) {
        auto* seaway =
            app.add_flag("--seaway", on, "Force the hulls as in a seaway; print costs of a step");
        app.add_option("--amplitude", options.amplitude, "Factor of the forces")
            ->capture_default_str()
            ->needs(seaway);
        app.add_option("--phase", options.phase, "Phase from one hull to the next [rad]")
            ->capture_default_str()
            ->needs(seaway);
        app.add_option("--seconds", options.seconds, "Simulated time [s]")
            ->capture_default_str()
            ->check(CLI::PositiveNumber)
            ->needs(seaway);
        app.add_option("--hull", hulls, "NAME PERIOD HEAVE ROLL PITCH, once a hull")->needs(seaway);
        app.add_option("--csv", options.csv, "Write a line a step to this file")->needs(seaway);
    }
    int run(const std::string& file, const std::string& json, int threads) {
        for (const auto& [name, period, heave, roll, pitch] : hulls)
            options.hulls.push_back({name, period, heave, roll, pitch});
        options.scene = file;
        options.json = json;
        options.threads = threads;
        return run_seaway(options);
    }
};

}  // namespace

int step_command(int argc, char** argv) {
    CLI::App app("Median time of a whole step at several scales, alternated in one run.",
                 "hawser-bench step");
    std::string file = "bench/scenes/frozen/anchor_lines.json", json;
    std::vector<int> scales{1, 10, 100};
    int threads = 1, rounds = 5;
    app.add_option("SCENE", file, "Scene file")->capture_default_str();
    app.add_option("--scale", scales, "Copies of the site")->capture_default_str();
    app.add_option("--threads", threads, "Threads")->check(CLI::Range(1, 256));
    app.add_option("--rounds", rounds, "Turns of each scale")->capture_default_str();
    app.add_option("--json", json, "Write the figures to this file");
    SeawayArguments seaway;
    seaway.add_to(app);
    app.footer(kSeawayFormula);
    CLI11_PARSE(app, argc, argv);
    if (seaway.on) return seaway.run(file, json, threads);

    std::vector<Subject> subjects;
    for (const int scale : scales) {
        scene::Options options;
        options.scale = scale;
        options.threads = threads;
        fmt::print(stderr, "loading scale {} …\n", scale);
        subjects.push_back({scene::load_file(file, options), scale, {}, {}});
        subjects.back().run(3, false);
    }
    for (int round = 0; round < rounds; ++round)
        for (Subject& s : subjects) s.run(std::max(4, 240 / s.scale), true);

    fmt::print("{} on {} thread(s), {}\n", file, threads, instruction_set());
    fmt::print("{:>6} {:>9} {:>10} {:>8} {:>10} {:>10} {:>9} {:>8} {:>10} {:>7}\n", "scale",
               "bodies", "equations", "islands", "ms median", "ms p99", "us/body", "ratio",
               "bytes/body", "GB/s");
    nlohmann::json rows = nlohmann::json::array();
    const double first = subjects.front().figures().us_per_body();
    for (const Subject& s : subjects) {
        const Figures f = s.figures();
        fmt::print(
            "{:>6} {:>9} {:>10} {:>8} {:>10.4g} {:>10.4g} {:>9.3f} {:>8.2f} {:>10.0f} "
            "{:>7.2f}\n",
            f.scale, f.bodies, f.equations, f.islands, f.median_ms, f.p99_ms, f.us_per_body(),
            f.us_per_body() / first, f.bytes_per_body, f.gb_per_s());
        nlohmann::json stages;
        for (std::size_t k = 0; k < kStageCount; ++k)
            stages[to_string(static_cast<Stage>(k))] = f.stage_ms[k];
        rows.push_back({{"scale", f.scale},
                        {"bodies", f.bodies},
                        {"equations", f.equations},
                        {"islands", f.islands},
                        {"step_ms", {{"median", f.median_ms}, {"p99", f.p99_ms}}},
                        {"us_per_body", f.us_per_body()},
                        {"ratio", f.us_per_body() / first},
                        {"bytes_per_body", f.bytes_per_body},
                        {"gb_per_s", f.gb_per_s()},
                        {"stage_ms", stages}});
    }
    fmt::print(
        "ratio: cost per body over that of the first scale. GB/s: bytes held over the "
        "median, as if each were touched once.\n");
    if (!json.empty()) std::ofstream(json) << rows.dump(2) << '\n';
    print_simulated_schedule(file, scales.front());
    return 0;
}

}  // namespace hawser::bench
