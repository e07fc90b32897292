// SPDX-License-Identifier: Apache-2.0
// hawser-bench coupling: the splits of the paper beside exact coupling, on the same cuts
// (docs/methods.md, 10).
#include "observe/coupling.h"
#include "commands.h"
#include "coupling_chains.h"
#include "coupling_simulated.h"
#include "coupling_stiffness.h"
#include "linear/timing.h"
#include "scene/scene.h"

#include <fmt/core.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace hawser::bench::split {
namespace {

using Json = nlohmann::ordered_json;

struct Mode {
    Coupling coupling;
    Predictor predictor;
    [[nodiscard]] std::string name() const {
        using observe::to_string;
        return coupling == Coupling::exact
                   ? "exact"
                   : fmt::format("{} {}", to_string(coupling), to_string(predictor));
    }
};

constexpr Mode kModes[] = {
    {Coupling::exact, Predictor::hold},       {Coupling::kinematic, Predictor::hold},
    {Coupling::kinematic, Predictor::forces}, {Coupling::kinematic, Predictor::clique},
    {Coupling::compliant, Predictor::hold},   {Coupling::compliant, Predictor::forces},
    {Coupling::compliant, Predictor::clique},
};

struct CouplingOptions {
    std::vector<std::string> scenes{"scenes/anchor_lines.json", "scenes/anchor_contact.json",
                                    "scenes/heavy_hook.json", "scenes/tow_zigzag.json"};
    std::vector<int> threads{1, 2};
    int parts = 4, steps = 120, rounds = 4;
    bool stiffness = true;
    double stiffness_seconds = 10.0;  ///< Room for the search of one mode [s].
    std::string json;
};

/// The partitioner cuts wires of lumps; a chain of links is cut into stretches of equal length.
void cut_chains(scene::Scene& scene, int parts) {
    for (const scene::Cable& cable : scene.cables)
        for (std::size_t i = 0; i < cable.nodes.size(); ++i)
            scene.world.set_group(
                cable.nodes[i],
                "part " + std::to_string(i * static_cast<std::size_t>(parts) / cable.nodes.size()));
}

scene::Scene load(const std::string& file, const Mode& mode, int parts, int threads) {
    using observe::to_string;
    scene::Options options;
    options.threads = threads;
    // Groups are made for all modes by the same split.
    options.set = {"settings.coupling=kinematic",
                   fmt::format("settings.predictor={}", to_string(mode.predictor)),
                   fmt::format("settings.parts={}", parts)};
    scene::Scene scene = scene::load_file(file, options);
    if (scene.world.cuts().empty()) cut_chains(scene, parts);
    if (mode.coupling != Coupling::kinematic)
        for (const CutView& cut : scene.world.cuts())
            scene.world.set_coupling(cut.interaction, mode.coupling);
    return scene;
}

/// Whether anything moves faster than things do here, or is no number.
bool runaway(const World& world) {
    for (std::int32_t b = 0; b < world.body_count(); ++b)
        if (!(world.velocity(BodyId{b}).linear.norm() < 100.0)) return true;
    return false;
}

struct Quality {
    observe::CouplingFigures figures;
    double lost_at = -1.0;  ///< Time at which a step failed or something ran away [s]; −1: none.
    double energy_drift = 0.0, energy_exchanged = 0.0;  ///< [J]
    int islands = 0, cuts = 0;
};

double explained(const Energy& e) {
    return e.mechanical() - e.applied - e.driven + e.dissipated + e.friction + e.contact + e.damped;
}

Quality measure_quality(World& world, int steps) {
    Quality q;
    observe::CouplingObserver observer(world);
    double start = 0.0, low = HUGE_VAL, high = -HUGE_VAL;
    for (int i = 0; i < steps; ++i) {
        observer.before_step(world);
        if (world.step() != Status::ok || runaway(world)) {
            q.lost_at = world.time();
            break;
        }
        observer.after_step(world);
        const Energy e = world.energy();
        if (i == 0) start = explained(e);
        low = std::min(low, e.kinetic);
        high = std::max(high, e.kinetic);
        q.energy_drift = explained(e) - start;
    }
    q.energy_exchanged = high - low;
    q.figures = observer.result(world, q.lost_at < 0.0);
    q.islands = world.stats().islands;
    q.cuts = world.stats().cuts;
    return q;
}

struct Timed {
    World world;
    std::vector<double> wall, cpu;  ///< [ms]
    bool lost = false;
    void run(int steps) {
        for (int i = 0; i < steps && !lost; ++i) {
            lost = world.step() != Status::ok || runaway(world);
            if (lost) break;
            wall.push_back(1e3 * world.stats().step_seconds);
            cpu.push_back(1e3 * world.stats().solver_cpu_seconds);
        }
    }
};

Json row_of(const Mode& mode, const Quality& q, const std::vector<Timed*>& timed,
            const CouplingOptions& o, const Stiffness& stiffness, const SimulatedStep& simulated) {
    const observe::CouplingFigures& f = q.figures;
    Json times = Json::object(), predicted = Json::object();
    for (std::size_t k = 0; k < kSimulatedThreads.size(); ++k)
        predicted[std::to_string(kSimulatedThreads[k])] = simulated.ms[k];
    for (std::size_t t = 0; t < o.threads.size(); ++t)
        times[std::to_string(o.threads[t])] = {{"step_ms", median(timed[t]->wall)},
                                               {"solver_cpu_ms", median(timed[t]->cpu)},
                                               {"steps", timed[t]->wall.size()}};
    return {{"mode", mode.name()},
            {"cuts", q.cuts},
            {"islands", q.islands},
            {"threads", times},
            {"simulated_step_ms", predicted},
            {"serial_share", simulated.serial},
            {"lost_at", q.lost_at < 0.0 ? Json() : Json(q.lost_at)},
            {"momentum_defect", {{"rms", f.defect_rms}, {"max", f.defect_max}}},
            {"interface_residual", f.residual_max},
            {"jerk",
             {{"split", f.jerk_max},
              {"exact", f.jerk_exact_max},
              {"difference", f.jerk_difference_max}}},
            {"tension_error", {{"rms", f.tension_error_rms}, {"max", f.tension_error_max}}},
            {"energy_drift", q.energy_drift},
            {"energy_exchanged", q.energy_exchanged},
            {"spectral_radius", f.spectral_radius},
            {"largest_stable_stiffness",
             {{"stable", stiffness.stable}, {"unstable", stiffness.unstable}}}};
}

void print_row(const Mode& mode, const Quality& q, const std::vector<Timed*>& timed,
               const Stiffness& stiffness, double defect_exact) {
    const observe::CouplingFigures& f = q.figures;
    fmt::print("  {:<17} {:>5} {:>7}", mode.name(), q.cuts, q.islands);
    for (const Timed* t : timed) fmt::print(" {:>8.3f} {:>8.3f}", median(t->wall), median(t->cpu));
    if (mode.coupling == Coupling::exact) {
        fmt::print(" {:>9.1e}\n", defect_exact);
        return;
    }
    fmt::print(" {:>9.1e} {:>9.2g} {:>9.2g} {:>9.2g} {:>9.2g} {:>8} {:>9}", f.defect_max,
               f.jerk_max, f.jerk_exact_max, 100.0 * f.tension_error_rms, q.energy_drift,
               q.lost_at >= 0.0 ? "-" : fmt::format("{:.4f}", f.spectral_radius),
               fmt::format("{}{:.2g}", stiffness.found() ? "" : ">", stiffness.stable));
    if (q.lost_at >= 0.0) fmt::print("  ran away at {:.2f} s", q.lost_at);
    fmt::print("\n");
}

/// What the simulation of the steps of one thread says, and how far from two threads it is.
void print_simulated(const std::vector<SimulatedStep>& simulated,
                     const std::vector<std::vector<Timed>>& timed, const CouplingOptions& o) {
    const auto two = std::find(o.threads.begin(), o.threads.end(), 2) - o.threads.begin();
    const bool measured = two < static_cast<std::ptrdiff_t>(o.threads.size());
    fmt::print("  SIMULATED from one thread's spans [ms]\n  {:<17}", "");
    for (const int t : kSimulatedThreads) fmt::print(" {:>8}", fmt::format("{} t", t));
    fmt::print(" {:>13} {:>8}  serial by stage\n", "2 t, of meas.", "serial");
    for (std::size_t m = 0; m < simulated.size(); ++m) {
        const SimulatedStep& s = simulated[m];
        fmt::print("  {:<17}", kModes[m].name());
        for (const double ms : s.ms) fmt::print(" {:>8.3f}", ms);
        const double real = measured ? median(timed[m][static_cast<std::size_t>(two)].wall) : 0.0;
        fmt::print(" {:>13}", real > 0.0 ? fmt::format("{:+.0f} %", 100.0 * (s.ms[1] / real - 1.0))
                                         : std::string("-"));
        fmt::print(" {:>6.0f} % ", 100.0 * s.serial);
        for (int k = 0; k < kStageCount; ++k)
            if (s.serial_of[static_cast<std::size_t>(k)] >= 0.02)
                fmt::print(" {} {:.0f}", to_string(static_cast<Stage>(k)),
                           100.0 * s.serial_of[static_cast<std::size_t>(k)]);
        fmt::print("\n");
    }
}

/// Exact beside the fastest split that stayed, on two threads: the bar is 15 %.
Json compare_exact(const std::vector<std::vector<Timed>>& timed, const std::vector<bool>& lost,
                   const CouplingOptions& o) {
    Json out = Json::array();
    constexpr double kBar = 1.15;
    for (std::size_t t = 0; t < o.threads.size(); ++t) {
        std::size_t best = 0;
        for (std::size_t m = 1; m < timed.size(); ++m)
            if (!lost[m] && (best == 0 || median(timed[m][t].wall) < median(timed[best][t].wall)))
                best = m;
        if (best == 0) {
            fmt::print("  {} thread(s): no split stayed within bounds\n", o.threads[t]);
            continue;
        }
        const double wall = median(timed[0][t].wall) / median(timed[best][t].wall);
        const double cpu = median(timed[0][t].cpu) / median(timed[best][t].cpu);
        fmt::print("  {} thread(s): exact takes {:.2f} of the step time of {} ({:.2f} of its cpu)",
                   o.threads[t], wall, kModes[best].name(), cpu);
        if (o.threads[t] == 2)
            fmt::print(": {} {:.0f} %", wall <= kBar ? "within" : "NOT within",
                       100.0 * (kBar - 1.0));
        fmt::print("\n");
        out.push_back({{"threads", o.threads[t]},
                       {"fastest_split", kModes[best].name()},
                       {"step_ratio", wall},
                       {"cpu_ratio", cpu}});
    }
    return out;
}

/// Spans of a traced step: some hundreds; 12 MB.
constexpr std::size_t kSpans = std::size_t{1} << 18;

struct Measured {
    std::vector<std::vector<Timed>> timed;  ///< By mode and number of threads.
    std::vector<SimulatedStep> simulated;   ///< By mode.
};

/// By turns, so that what else the machine does meets all of them.
Measured measure_times(const std::string& file, const CouplingOptions& o, const PoolCosts& costs) {
    Measured out;
    std::vector<Timed> traced;
    for (const Mode& mode : kModes) {
        std::vector<Timed>& list = out.timed.emplace_back();
        for (const int t : o.threads)
            list.push_back({load(file, mode, o.parts, t).world, {}, {}, false});
        traced.push_back({load(file, mode, o.parts, 1).world, {}, {}, false});
        traced.back().world.start_trace(kSpans);
    }
    for (int round = 0; round < o.rounds; ++round) {
        fmt::print(stderr, "{}: round {} of {}\n", file, round + 1, o.rounds);
        for (std::size_t m = 0; m < traced.size(); ++m) {
            for (Timed& t : out.timed[m]) t.run(std::max(1, o.steps / o.rounds));
            traced[m].run(std::max(1, o.steps / o.rounds));
        }
    }
    for (const Timed& t : traced) out.simulated.push_back(simulate_steps(t.world, costs));
    return out;
}

/// From the state that exact steps reach: a split may have lost it.
Stiffness stiffness_of(const std::string& file, const Mode& mode,
                       const std::vector<InteractionId>& cuts, const CouplingOptions& o) {
    fmt::print(stderr, "{}: largest stable stiffness, {}\n", file, mode.name());
    World state = load(file, mode, o.parts, 1).world;
    World steady = load(file, kModes[0], o.parts, 1).world;
    for (int i = 0; i < 30; ++i) (void)steady.step();
    state.copy_state(steady);
    return largest_stable(state, cuts, o.stiffness_seconds);
}

Json compare(const std::string& file, const CouplingOptions& o, const PoolCosts& costs) {
    fmt::print("\n{}: cut into {}\n  {:<17} {:>5} {:>7}", file, o.parts, "", "cuts", "islands");
    for (const int t : o.threads) fmt::print(" {:>8} {:>8}", fmt::format("{} t ms", t), "cpu ms");
    fmt::print(" {:>9} {:>9} {:>9} {:>9} {:>9} {:>8} {:>9}\n", "defect", "jerk", "of exact",
               "tension %", "drift J", "radius", "stable k");
    Measured times = measure_times(file, o, costs);
    std::vector<InteractionId> cuts;
    for (const CutView& c : load(file, kModes[1], o.parts, 1).world.cuts())
        cuts.push_back(c.interaction);
    Json rows = Json::array();
    std::vector<bool> lost;
    for (std::size_t m = 0; m < std::size(kModes); ++m) {
        World world = load(file, kModes[m], o.parts, 1).world;
        const bool exact = kModes[m].coupling == Coupling::exact;
        double defect = 0.0;
        Quality q;
        if (exact) {
            for (int i = 0; i < o.steps && world.step() == Status::ok; ++i)
                defect = std::max(defect, world.stats().momentum_defect);
            q.figures.defect_max = defect;
            q.islands = world.stats().islands;
        } else {
            q = measure_quality(world, o.steps);
        }
        Stiffness stiffness;
        if (o.stiffness && !exact) stiffness = stiffness_of(file, kModes[m], cuts, o);
        std::vector<Timed*> list;
        for (Timed& t : times.timed[m]) list.push_back(&t);
        lost.push_back(q.lost_at >= 0.0);
        print_row(kModes[m], q, list, stiffness, defect);
        rows.push_back(row_of(kModes[m], q, list, o, stiffness, times.simulated[m]));
    }
    print_simulated(times.simulated, times.timed, o);
    const Json ratios = compare_exact(times.timed, lost, o);
    return {{"scene", file}, {"parts", o.parts}, {"modes", rows}, {"exact_over_split", ratios}};
}

int run(int argc, char** argv) {
    CLI::App app("The splits of the paper beside exact coupling, on the same cuts.",
                 "hawser-bench coupling");
    CouplingOptions o;
    bool theory = false;
    app.add_option("SCENES", o.scenes, "Scene files")->capture_default_str();
    app.add_option("--parts", o.parts, "Parts to cut into")->capture_default_str();
    app.add_option("--steps", o.steps, "Steps of each mode")->capture_default_str();
    app.add_option("--rounds", o.rounds, "Turns of each mode")->capture_default_str();
    app.add_option("--threads", o.threads, "Numbers of threads")->capture_default_str();
    app.add_flag("!--no-stiffness", o.stiffness, "Leave the largest stable stiffness out");
    app.add_option("--stiffness-seconds", o.stiffness_seconds,
                   "Processor time of one search for the largest stable stiffness [s]; what is not "
                   "found within a tenth of a decade by then is printed with >")
        ->capture_default_str();
    app.add_flag("--theory", theory, "Two bodies and the chain of twelve only, no scenes");
    app.add_option("--json", o.json, "Write the figures to this file");
    CLI11_PARSE(app, argc, argv);

    Json out = {{"two_bodies", two_body_boundaries()}, {"chain", chain_predictors()}};
    if (!theory) {
        fmt::print(
            "\nms: median of a whole step; cpu: of the solver's slowest thread. defect: "
            "momentum out of nothing,\nlargest, of h g m. jerk [m/s3], of exact: of exact "
            "steps from the same states. tension: rms error\nat the cuts. stable k: largest "
            "stiffness of the cuts with spectral radius <= {}, of their own.\n"
            "Simulated: spans of one thread dealt out to more (hawser/schedule.h).\n",
            kGrowth);
        const PoolCosts costs = measure_pool_costs();
        Json scenes = Json::array();
        for (const std::string& file : o.scenes) scenes.push_back(compare(file, o, costs));
        out["scenes"] = scenes;
    }
    if (!o.json.empty()) std::ofstream(o.json) << out.dump(2) << '\n';
    return 0;
}

}  // namespace
}  // namespace hawser::bench::split

int hawser::bench::coupling_command(int argc, char** argv) {
    return hawser::bench::split::run(argc, argv);
}
