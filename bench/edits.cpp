// SPDX-License-Identifier: Apache-2.0
// hawser-bench edits: cost of additions and removals in a running world.
#include <hawser/scene.h>
#include "commands.h"
#include "linear/timing.h"
#include "verdict.h"

#include <fmt/core.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace hawser::bench {
namespace {

constexpr const char* kEditsFooter =
    R"(Before each second step one edit: a lump on a line, a line between two hulls, a shape, a wire of ten
elements, each added, and removed two steps later. The time of a step with an edit includes the edit
itself. Figures count after so many rounds of all edits as warm up. Exit code 1 where a bar is
missed: the median step with an edit at most 1.3 times that of a step without, no new plan, no
growth (bench/scenes/frozen/anchor_contact.json).

--own adds and removes nothing: of so many --steps of the scene, those before which nodes of its
wires came or went are compared with the others (bench/scenes/frozen/anchor_adaptive.json, which has them in its
first 10 s). The bar is the same; plans and growths are printed.)";

/// An object that is added and removed.
struct Coming {
    const char* name;
    std::function<void()> add, remove;
    std::vector<double> seconds = {};  ///< Times of steps with an addition or removal.
};

/// Objects of the edits: two hulls, and the last addition.
struct EditedWire {
    explicit EditedWire(World& w) : world(w) {
        for (const BodyId b : w.bodies())
            if (w.body_def(b).kind == BodyKind::rigid) hulls.push_back(b);
        if (hulls.size() < 2) throw std::runtime_error("the scene has no two rigid bodies");
    }
    [[nodiscard]] InteractionDef line(BodyId a, BodyId b) const {
        InteractionDef d;
        d.kind = InteractionKind::Stretch;
        d.body = {a, b};
        const double separation = (world.pose(a).position - world.pose(b).position).norm();
        return d.set("EA", 1e5).set("length", 1.01 * separation);
    }
    void add_lump() {
        const Vec3 below = world.pose(hulls[0]).position - Vec3(0, 0, 15);
        body = world.add_body({.kind = BodyKind::lump, .position = below, .mass = 100.0});
        (void)world.add_interaction(line(hulls[0], body));
    }
    void add_wire() {
        WireDef def;
        def.name = "edited";
        def.from = hulls[0];
        def.length = 30.0;
        def.EA = 1e6;
        def.mass_per_length = 20.0;
        wire = world.wires().add(def);
    }

    World& world;
    std::vector<BodyId> hulls;
    BodyId body{};
    InteractionId joint{};
    ShapeId shape{};
    WireId wire{};
};

struct EditFigures {
    double plain_ms = 0.0, edit_ms = 0.0;
    std::int64_t plans = 0, repairs = 0, growths = 0;
    std::size_t bytes = 0;  ///< Additional memory of the world at the end.
};

constexpr double kMaxRatio = 1.3;

std::string edit_line(const EditFigures& f) {
    return fmt::format("a step with an edit {:.3g} ms, {:.3g} times one without, to be {}",
                       f.edit_ms, f.edit_ms / f.plain_ms, kMaxRatio);
}

double timed_step(World& world, const std::function<void()>& before) {
    const auto start = std::chrono::steady_clock::now();
    if (before) before();
    if (world.step() != Status::ok) throw std::runtime_error("a step failed");
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

EditFigures measure_edits(World& world, std::vector<Coming>& kinds, int warm, int rounds) {
    std::vector<double> plain, with;
    StepStats before;
    std::size_t held = 0;
    for (int round = 0; round < warm + rounds; ++round) {
        if (round == warm) {
            before = world.stats();
            held = world.solver().memory_bytes();
        }
        for (Coming& kind : kinds)
            for (const auto* edit : {&kind.add, &kind.remove}) {
                const double seconds = timed_step(world, *edit);
                const double other = timed_step(world, nullptr);
                if (round < warm) continue;
                kind.seconds.push_back(seconds);
                with.push_back(seconds);
                plain.push_back(other);
            }
    }
    const StepStats& s = world.stats();
    return {1e3 * median(plain),        1e3 * median(with),
            s.plans - before.plans,     s.repairs - before.repairs,
            s.growths - before.growths, std::max(world.solver().memory_bytes(), held) - held};
}

/// Time steps of a scene whose wires edit themselves.
EditFigures measure_own_edits(World& world, int steps) {
    std::vector<double> plain, with;
    for (int i = 0; i < steps; ++i) {
        const StepStats before = world.stats();
        const double seconds = timed_step(world, nullptr);
        const StepStats& now = world.stats();
        const bool edited = now.plans + now.repairs != before.plans + before.repairs;
        if (i > 0)
            (edited ? with : plain).push_back(seconds);  // the first step allocates
                                                         // everything
    }
    if (with.empty()) throw std::runtime_error("no step of the scene had an edit");
    const StepStats& s = world.stats();
    fmt::print("{} of {} steps with edits\n", with.size(), steps);
    return {1e3 * median(plain), 1e3 * median(with), s.plans, s.repairs, s.growths, 0};
}

int report_own(const std::string& file, const EditFigures& f, const std::string& json) {
    fmt::print("{}: a step {:.3g} ms, {} plans, {} repairs, {} growths\n", file, f.plain_ms,
               f.plans, f.repairs, f.growths);
    Verdict verdict;
    verdict.require("edit", "", f.edit_ms <= kMaxRatio * f.plain_ms, edit_line(f));
    if (!json.empty())
        std::ofstream(json) << nlohmann::json{{"scene", file},         {"step_ms", f.plain_ms},
                                              {"edit_ms", f.edit_ms},  {"plans", f.plans},
                                              {"repairs", f.repairs},  {"growths", f.growths},
                                              {"bars", verdict.json()}}
                                   .dump(2)
                            << '\n';
    return verdict.exit_code();
}

}  // namespace

int edits_command(int argc, char** argv) {
    CLI::App app("What it costs to add and remove while a world runs.", "hawser-bench edits");
    app.footer(kEditsFooter);
    std::string file = "bench/scenes/frozen/anchor_contact.json", json;
    int steps = 120, warm = 3, rounds = 25;
    app.add_option("SCENE", file, "Scene file")->capture_default_str();
    app.add_option("--steps", steps, "Steps before")->check(CLI::Range(1, 1000000));
    app.add_option("--warm", warm, "Rounds before it counts")->check(CLI::Range(0, 100000));
    app.add_option("--rounds", rounds, "Rounds of all edits")->check(CLI::Range(1, 100000));
    app.add_option("--json", json, "Write the figures to this file");
    bool own = false;
    app.add_flag("--own", own, "Edits that the scene itself makes in --steps");
    CLI11_PARSE(app, argc, argv);

    scene::Scene scene = scene::load_file(file);
    World& world = scene.world;
    if (own) return report_own(file, measure_own_edits(world, steps), json);
    for (int i = 0; i < steps; ++i) (void)timed_step(world, nullptr);
    EditedWire e(world);
    std::vector<Coming> kinds{
        {"lump", [&] { e.add_lump(); }, [&] { (void)world.remove_body(e.body); }},
        {"line", [&] { e.joint = world.add_interaction(e.line(e.hulls[0], e.hulls[1])); },
         [&] { (void)world.remove_interaction(e.joint); }},
        {"shape",
         [&] {
             e.shape =
                 world.add_shape({.kind = ShapeKind::sphere, .body = e.hulls[0], .radius = 0.5});
         },
         [&] { (void)world.remove_shape(e.shape); }},
        {"wire", [&] { e.add_wire(); }, [&] { (void)world.wires().remove(e.wire); }}};
    const EditFigures f = measure_edits(world, kinds, warm, rounds);
    fmt::print("{}: {} bodies, {} interactions, {} shapes; a step {:.3g} ms, {}\n", file,
               world.bodies().size(), world.interactions().size(), world.shapes().size(),
               f.plain_ms, instruction_set());
    nlohmann::json each;
    for (const Coming& kind : kinds) {
        const double ms = 1e3 * median(kind.seconds);
        fmt::print("  {:<6} {:.3g} ms, {:.3g} times a step without\n", kind.name, ms,
                   ms / f.plain_ms);
        each[kind.name] = ms;
    }
    fmt::print("  {} repairs, {} bytes more\n", f.repairs, f.bytes);
    Verdict verdict;
    verdict.require("edit", "", f.edit_ms <= kMaxRatio * f.plain_ms, edit_line(f));
    verdict.require("plans", "", f.plans == 0, fmt::format("{} new plans, to be none", f.plans));
    verdict.require("growths", "", f.growths == 0,
                    fmt::format("{} growths, to be none", f.growths));
    if (!json.empty()) {
        const nlohmann::json figures{
            {"scene", file},        {"step_ms", f.plain_ms}, {"edit_ms", f.edit_ms},
            {"kinds_ms", each},     {"plans", f.plans},      {"repairs", f.repairs},
            {"growths", f.growths}, {"more_bytes", f.bytes}, {"bars", verdict.json()}};
        std::ofstream(json) << figures.dump(2) << '\n';
    }
    return verdict.exit_code();
}

}  // namespace hawser::bench
