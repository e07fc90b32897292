// SPDX-License-Identifier: Apache-2.0
// hawser-bench interface: cost of reading a world for a client (state, outputs, contacts, events,
// save and restore), and of a system without actions.
#include <hawser/scene.h>
#include "commands.h"
#include "verdict.h"

#include <fmt/core.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hawser::bench {
namespace {

constexpr const char* kFooter =
    R"(Medians, each call timed on its own, after steps that bring the scene into motion. Outputs: as many
as asked for, of every kind that the scene has a target for. Exit code 1 where a bar is missed:
state() without a copy, 100 outputs in 5 us, save in 1 ms and restore in 1.5 ms (bench/scenes/frozen/anchor_contact.json),
a system that does nothing in 0.1 us a step.)";

using ReadClock = std::chrono::steady_clock;

/// Return the median time of a call [s]; prepare() runs before each one and is not timed.
template <class Prepare, class Call>
double median_of_calls(int times, const Prepare& prepare, const Call& call) {
    std::vector<double> seconds;
    for (int i = 0; i < times; ++i) {
        prepare();
        const auto start = ReadClock::now();
        call();
        seconds.push_back(std::chrono::duration<double>(ReadClock::now() - start).count());
    }
    std::nth_element(seconds.begin(), seconds.begin() + times / 2, seconds.end());
    return seconds[static_cast<std::size_t>(times / 2)];
}

/// Fill a world with outputs up to a count: each kind in turn, over the bodies and lines in order.
void add_outputs(World& world, const std::vector<scene::Cable>& cables, int wanted) {
    const std::vector<OutputDef> kinds = [&] {
        std::vector<OutputDef> all;
        const auto add = [&](OutputDef def) { all.push_back(std::move(def)); };
        for (std::int32_t b = 0; b < world.body_count(); ++b) {
            if (world.body_def({b}).kind != BodyKind::rigid) continue;
            add({.kind = OutputKind::pose, .body = {b}, .component = "z"});
            add({.kind = OutputKind::pose, .body = {b}, .component = "yaw"});
            add({.kind = OutputKind::velocity, .body = {b}, .component = "x", .local = true});
            add({.kind = OutputKind::distance, .body = {b}, .body_b = {(b + 1) % 7}});
        }
        for (const scene::Cable& cable : cables) {
            if (cable.stretch.empty()) continue;
            // The largest value needs all elements: here those at the ends.
            add({.kind = OutputKind::tension,
                 .line = {cable.stretch.front()},
                 .component = "first"});
            add({.kind = OutputKind::tension, .line = {cable.stretch.back()}, .component = "last"});
        }
        for (std::int32_t i = 0; i < world.interaction_count(); ++i) {
            const KindInfo& kind = kind_info(world.interaction_def({i}).kind);
            if (kind.coordinate == KindCoordinate::none) continue;
            add({.kind = OutputKind::coordinate, .interaction = {i}});
            add({.kind = OutputKind::speed, .interaction = {i}});
            if (kind.is(kMotorKind)) add({.kind = OutputKind::motor_force, .interaction = {i}});
        }
        for (const char* name : {"residual", "kinetic", "driven", "contacts"})
            add({.kind = OutputKind::statistic, .component = name});
        return all;
    }();
    for (int n = 0, tried = 0; n < wanted; ++tried) {
        // Large strides, so that every kind occurs.
        OutputDef def = kinds[static_cast<std::size_t>(tried) * 37 % kinds.size()];
        def.name = fmt::format("output {}", n);
        try {
            world.add_output(def);
            ++n;
        } catch (const DefError&) {
            if (tried > 100 * wanted) throw;  // a scalar body has no position
        }
    }
}

struct ReadFigures {
    double state_ns = 0.0, outputs_us = 0.0, contacts_us = 0.0, events_us = 0.0;
    double save_ms = 0.0, restore_ms = 0.0, hash_ms = 0.0, step_ms = 0.0;
    bool no_copy = true;
    std::size_t bytes = 0, contacts = 0;
};

ReadFigures measure(World& world, int rounds) {
    ReadFigures f;
    std::vector<Event> events;
    std::vector<ContactView> contacts;
    std::vector<std::byte> saved;
    std::uint64_t cursor = 0;
    const auto nothing = [] {};
    // Mark derived data to be computed again.
    const auto touch = [&] { (void)world.events().since(cursor, events); };
    constexpr int kMany = 10'000;
    const double* seen = world.state().arrays().positions.data();
    double sum = 0.0;
    const auto start = ReadClock::now();
    for (int i = 0; i < kMany; ++i) {
        const StateView state = world.state().arrays();
        f.no_copy = f.no_copy && state.positions.data() == seen;
        sum += state.velocities[static_cast<std::size_t>(i) % state.velocities.size()];
    }
    f.state_ns = 1e9 * std::chrono::duration<double>(ReadClock::now() - start).count() / kMany;
    // Setting a pose changes an earlier view: it is the world's own array.
    const BodyId first{0};
    const StateView view = world.state().arrays();
    const std::vector<std::byte> before = world.state().save();
    Pose moved = world.pose(first);
    moved.position.x() += 1.0;
    world.set_pose(first, moved);
    f.no_copy = f.no_copy && view.positions[0] == moved.position.x() && sum == sum;
    world.state().restore(before);

    f.outputs_us =
        1e6 * median_of_calls(20 * rounds, touch, [&] { sum += world.outputs().back(); });
    f.step_ms = 1e3 * median_of_calls(rounds, nothing, [&] { (void)world.step(); });
    f.contacts_us = 1e6 * median_of_calls(rounds, nothing, [&] { world.contacts(contacts); });
    f.contacts = contacts.size();
    f.events_us = 1e6 * median_of_calls(20 * rounds, nothing, touch);
    f.save_ms = 1e3 * median_of_calls(rounds, nothing, [&] { world.state().save(saved); });
    f.bytes = saved.size();
    // Like a client that goes back: some steps later.
    f.restore_ms =
        1e3 *
        median_of_calls(rounds, [&] { (void)world.step(); }, [&] { world.state().restore(saved); });
    f.hash_ms =
        1e3 * median_of_calls(rounds, nothing, [&] { sum += double(world.state().hash() & 1); });
    return f;
}

/// Return the time that an idle system adds to a step [s]: of two small worlds, one has a thousand
/// of them. Takes the least of many times of stage prestep.
double idle_system_seconds() {
    struct Idle final : System {
        std::string own;
        [[nodiscard]] std::string_view name() const noexcept override { return own; }
        void prestep(Prestep&, Loads&) noexcept override {}
    };
    constexpr int kSystems = 1000, kSteps = 300;
    World worlds[2];
    for (World& w : worlds) {
        BodyDef def{.name = "block"};
        def.mass = 1.0;
        def.inertia = Vec3(1, 1, 1).asDiagonal();
        w.add_body(def);
    }
    for (int i = 0; i < kSystems; ++i) {
        auto idle = std::make_unique<Idle>();
        idle->own = fmt::format("idle {}", i);
        worlds[0].add_system(std::move(idle));
    }
    double least[2] = {1.0, 1.0};
    for (int i = 0; i < kSteps; ++i)
        for (const std::size_t k : {0U, 1U}) {
            if (worlds[k].step() != Status::ok) throw std::runtime_error("a step failed");
            if (i == 0) continue;  // the first step calls them before its clock starts
            least[k] = std::min(least[k], worlds[k].stats().stage_seconds[0]);
        }
    return (least[0] - least[1]) / kSystems;
}

}  // namespace

int interface_command(int argc, char** argv) {
    CLI::App app("What it costs a client to read a world.", "hawser-bench interface");
    app.footer(kFooter);
    std::string file = "bench/scenes/frozen/anchor_contact.json", json;
    int steps = 120, rounds = 101, outputs = 100;
    app.add_option("SCENE", file, "Scene file")->capture_default_str();
    app.add_option("--steps", steps, "Steps before")->check(CLI::Range(1, 1000000));
    app.add_option("--rounds", rounds, "Calls of which the median is taken")
        ->check(CLI::Range(1, 100000));
    app.add_option("--outputs", outputs, "Outputs")->check(CLI::Range(1, 100000));
    app.add_option("--json", json, "Write the figures to this file");
    CLI11_PARSE(app, argc, argv);

    scene::Scene scene = scene::load_file(file);
    World& world = scene.world;
    add_outputs(world, scene.cables, outputs);
    for (int i = 0; i < steps; ++i)
        if (world.step() != Status::ok) throw std::runtime_error("a step failed");
    const ReadFigures f = measure(world, rounds);
    fmt::print("{}: {} bodies, {} interactions, {} outputs, {} contacts; a step {:.3g} ms, {}\n",
               file, world.body_count(), world.interaction_count(), world.output_count(),
               f.contacts, f.step_ms, instruction_set());
    fmt::print("  contacts(out) {:.3g} us, events_since {:.3g} us, state_hash {:.3g} ms\n",
               f.contacts_us, f.events_us, f.hash_ms);
    Verdict verdict;
    verdict.require("state", "", f.no_copy,
                    fmt::format("state() {:.3g} ns, the world's own arrays", f.state_ns));
    // The bar is for 100 outputs.
    verdict.require("outputs", "", f.outputs_us <= 5.0 * outputs / 100.0,
                    fmt::format("{} outputs {:.3g} us, to be 5 us a 100", outputs, f.outputs_us));
    verdict.require("save", "", f.save_ms <= 1.0,
                    fmt::format("save of {:.3g} MB {:.3g} ms, to be 1 ms",
                                1e-6 * static_cast<double>(f.bytes), f.save_ms));
    verdict.require("restore", "", f.restore_ms <= 1.5,
                    fmt::format("restore {:.3g} ms, to be 1.5 ms", f.restore_ms));
    const double idle_us = 1e6 * idle_system_seconds();
    verdict.require(
        "idle system", "", idle_us <= 0.1,
        fmt::format("a system that does nothing {:.3g} us a step, to be 0.1 us", idle_us));
    if (!json.empty()) {
        const nlohmann::json figures{{"scene", file},
                                     {"outputs", outputs},
                                     {"contacts", f.contacts},
                                     {"bytes", f.bytes},
                                     {"state_ns", f.state_ns},
                                     {"outputs_us", f.outputs_us},
                                     {"contacts_us", f.contacts_us},
                                     {"events_us", f.events_us},
                                     {"save_ms", f.save_ms},
                                     {"restore_ms", f.restore_ms},
                                     {"hash_ms", f.hash_ms},
                                     {"step_ms", f.step_ms},
                                     {"idle_system_us", idle_us},
                                     {"bars", verdict.json()}};
        std::ofstream(json) << figures.dump(2) << '\n';
    }
    return verdict.exit_code();
}

}  // namespace hawser::bench
