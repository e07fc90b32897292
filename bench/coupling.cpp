// SPDX-License-Identifier: Apache-2.0
// hawser-bench coupling: the splits of the paper beside exact coupling, on the same cuts
// (docs/methods.md, 10).
#include "observe/coupling.h"
#include "commands.h"
#include "coupling_chains.h"
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

/// The same world with cut interactions stiffer by a factor, in the same state.
World stiffened(const World& from, const std::vector<InteractionId>& cuts, double factor,
                const std::vector<Coupling>& coupling) {
    World out(from.settings());
    for (std::int32_t b = 0; b < from.body_count(); ++b) out.add_body(from.body_def(BodyId{b}));
    for (std::int32_t m = 1; m < from.material_count(); ++m)
        out.add_material(from.material_def(MaterialId{m}));
    for (const MaterialPairDef& pair : from.material_pairs()) out.add_material_pair(pair);
    for (std::int32_t s = 0; s < from.shape_count(); ++s) out.add_shape(from.shape_def(ShapeId{s}));
    for (std::int32_t i = 0; i < from.interaction_count(); ++i) {
        InteractionDef d = from.interaction_def(InteractionId{i});
        if (std::find(cuts.begin(), cuts.end(), InteractionId{i}) != cuts.end())
            for (double& compliance : d.compliance) compliance /= factor;
        out.add_interaction(d);
    }
    for (std::int32_t i = 0; i < from.input_count(); ++i) out.add_input(from.input_def(InputId{i}));
    for (std::size_t i = 0; i < coupling.size(); ++i)
        if (out.coupling(InteractionId{static_cast<std::int32_t>(i)}) != coupling[i])
            out.set_coupling(InteractionId{static_cast<std::int32_t>(i)}, coupling[i]);
    out.copy_state(from);
    return out;
}

constexpr double kGrowth = 1.02;  ///< Spectral radius from which a step counts as unstable.

/// Largest factor, 1e-8 to 1e2, of the stiffness of the cuts at which the step is stable.
double largest_stable(const World& world, const std::vector<InteractionId>& cuts) {
    std::vector<Coupling> coupling;
    for (std::int32_t i = 0; i < world.interaction_count(); ++i)
        coupling.push_back(world.coupling(InteractionId{i}));
    auto stable = [&](double exponent) {
        const World w = stiffened(world, cuts, std::pow(10.0, exponent), coupling);
        return observe::spectral_radius(w) <= kGrowth;
    };
    double low = -8.0, high = 2.0;
    if (stable(high)) return std::pow(10.0, high);
    if (!stable(low)) return 0.0;
    while (high - low > 0.1) {
        const double middle = 0.5 * (low + high);
        (stable(middle) ? low : high) = middle;
    }
    return std::pow(10.0, low);
}

double median(std::vector<double> v) {
    if (v.empty()) return 0.0;
    std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
    return v[v.size() / 2];
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
            const CouplingOptions& o, double stiffness) {
    const observe::CouplingFigures& f = q.figures;
    Json times = Json::object();
    // Threads beyond those of this machine: a place for simulated schedules.
    for (std::size_t t = 0; t < o.threads.size(); ++t)
        times[std::to_string(o.threads[t])] = {{"step_ms", median(timed[t]->wall)},
                                               {"solver_cpu_ms", median(timed[t]->cpu)},
                                               {"steps", timed[t]->wall.size()}};
    return {{"mode", mode.name()},
            {"cuts", q.cuts},
            {"islands", q.islands},
            {"threads", times},
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
            {"largest_stable_stiffness", stiffness}};
}

void print_row(const Mode& mode, const Quality& q, const std::vector<Timed*>& timed,
               double stiffness, double defect_exact) {
    const observe::CouplingFigures& f = q.figures;
    fmt::print("  {:<17} {:>5} {:>7}", mode.name(), q.cuts, q.islands);
    for (const Timed* t : timed) fmt::print(" {:>8.3f} {:>8.3f}", median(t->wall), median(t->cpu));
    if (mode.coupling == Coupling::exact) {
        fmt::print(" {:>9.1e}\n", defect_exact);
        return;
    }
    fmt::print(" {:>9.1e} {:>9.2g} {:>9.2g} {:>9.2g} {:>9.2g} {:>8.4f} {:>9.2g}", f.defect_max,
               f.jerk_max, f.jerk_exact_max, 100.0 * f.tension_error_rms, q.energy_drift,
               f.spectral_radius, stiffness);
    if (q.lost_at >= 0.0) fmt::print("  ran away at {:.2f} s", q.lost_at);
    fmt::print("\n");
}

Json compare(const std::string& file, const CouplingOptions& o) {
    fmt::print("\n{}: cut into {}\n  {:<17} {:>5} {:>7}", file, o.parts, "", "cuts", "islands");
    for (const int t : o.threads) fmt::print(" {:>8} {:>8}", fmt::format("{} t ms", t), "cpu ms");
    fmt::print(" {:>9} {:>9} {:>9} {:>9} {:>9} {:>8} {:>9}\n", "defect", "jerk", "of exact",
               "tension %", "drift J", "radius", "stable k");
    std::vector<std::vector<Timed>> timed;
    for (const Mode& mode : kModes) {
        std::vector<Timed>& list = timed.emplace_back();
        for (const int t : o.threads)
            list.push_back({load(file, mode, o.parts, t).world, {}, {}, false});
    }
    // By turns, so that what else the machine does meets all of them.
    for (int round = 0; round < o.rounds; ++round)
        for (std::vector<Timed>& list : timed)
            for (Timed& t : list) t.run(std::max(1, o.steps / o.rounds));
    Json rows = Json::array();
    for (std::size_t m = 0; m < std::size(kModes); ++m) {
        World world = load(file, kModes[m], o.parts, 1).world;
        const Mode reference{Coupling::kinematic, Predictor::hold};
        std::vector<InteractionId> cuts;
        {
            const scene::Scene s = load(file, reference, o.parts, 1);
            for (const CutView& c : s.world.cuts()) cuts.push_back(c.interaction);
        }
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
        // From the state that exact steps reach: a split may have lost it.
        double stiffness = 0.0;
        if (o.stiffness && !exact) {
            World state = load(file, kModes[m], o.parts, 1).world;
            World steady = load(file, kModes[0], o.parts, 1).world;
            for (int i = 0; i < 30; ++i) (void)steady.step();
            state.copy_state(steady);
            stiffness = largest_stable(state, cuts);
        }
        std::vector<Timed*> times;
        for (Timed& t : timed[m]) times.push_back(&t);
        print_row(kModes[m], q, times, stiffness, defect);
        rows.push_back(row_of(kModes[m], q, times, o, stiffness));
    }
    return {{"scene", file}, {"parts", o.parts}, {"modes", rows}};
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
    app.add_flag("--theory", theory, "Two bodies and the chain of twelve only, no scenes");
    app.add_option("--json", o.json, "Write the figures to this file");
    CLI11_PARSE(app, argc, argv);

    Json out = {{"two_bodies", two_body_boundaries()}, {"chain", chain_predictors()}};
    if (!theory) {
        fmt::print(
            "\nms: median of a whole step; cpu: of the solver's slowest thread. defect: "
            "momentum out of nothing,\nlargest, of h g m. jerk [m/s3], of exact: of exact "
            "steps from the same states. tension: rms error\nat the cuts. stable k: largest "
            "stiffness of the cuts with spectral radius <= {}, of their own.\n",
            kGrowth);
        Json scenes = Json::array();
        for (const std::string& file : o.scenes) scenes.push_back(compare(file, o));
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
