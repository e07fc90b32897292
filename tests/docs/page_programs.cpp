// SPDX-License-Identifier: Apache-2.0
// C++ blocks of the pages of docs/ other than library.md, compiled and not run. The test in
// page_blocks_test.cpp compares them with the pages.
#include <hawser/exercise.h>
#include <hawser/hawser.h>
#include <hawser/recording.h>
#include <hawser/repeater.h>
#include <hawser/scene.h>
#include <hawser/session.h>

#include <algorithm>
#include <cstdio>
#include <span>
#include <string>

namespace hawser::test {
namespace {

// docs/cranes.md
[[maybe_unused]] void add_crane(hawser::World& world, hawser::BodyId barge) {
    // clang-format off
    hawser::KnuckleCraneDef def;                     // dimensions as above
    def.name = "crane";
    def.mount = {.on = barge, .point = {0, 0, 2}};
    const hawser::CraneIds ids = world.add(def);     // bodies, joints, lines, system: all or nothing
    world.set_system_signal("crane.hoist", 0.3);
    // clang-format on
    (void)ids;
}

// docs/sea.md
[[maybe_unused]] void add_sea(hawser::World& world, hawser::WireId tow) {
    hawser::SeaDef sea{.depth = 150.0};
    sea.waves.push_back({.kind = hawser::WaveKind::jonswap, .height = 3.0, .period = 9.0});
    sea.lines.push_back({.wire = tow, .sections = {{20, {.diameter = 0.076, .cd_normal = 1.8}}}});
    world.add(sea);
}

// docs/vessels.md
[[maybe_unused]] double turn_ship() {
    hawser::World world;
    hawser::PublishedShip ship = hawser::kvlcc2(hawser::KvlccScale::full);
    ship.vessel.body = world.add_body(ship.body);
    world.add(ship.vessel);
    // clang-format off
    const hawser::TurningCircle t = hawser::turning_circle(world, ship.vessel, 0.611, 600.0);
    // clang-format on
    return t.advance;
}

// docs/exercises.md
[[maybe_unused]] void run_exercise() {
    // clang-format off
    auto loaded = hawser::exercise::load_file("exercises/tow_out.json");
    hawser::Session session(std::move(loaded.scene), {.record = "run.hwr"});
    hawser::exercise::Run run(loaded.exercise, session);
    while (!run.ended()) {
        run.set_input("winch", "winch_speed", 0.5);  // throws Refused where the role may not
        if (run.step() != hawser::Status::ok) break;
    }
    session.finish();
    // clang-format on
}

// docs/library_session.md
[[maybe_unused]] void load_scene() {
    // clang-format off
    hawser::scene::Options options;
    options.threads = 2;
    options.set = {"bodies.rig.mass=2e7"};           // as --set of the program
    hawser::scene::Scene scene = hawser::scene::load_file("scenes/anchor_lines.json", options);
    scene.world.step();
    for (const hawser::scene::Cable& cable : scene.cables)
        std::printf("%s: %.0f N\n", cable.name.c_str(), -scene.world.force(cable.stretch.front())[0]);
    // clang-format on
}

[[maybe_unused]] void record_run() {
    hawser::Session session({.scene = "scenes/anchor_lines.json", .record = "run.hwr"});
    while (session.time() < 10.0) {
        session.set_input("ahts1/tow_winch", session.time() < 5.0 ? 0.0 : -0.2);
        if (session.step() != hawser::Status::ok) break;
    }
    session.finish();
}

struct Peak : hawser::Observer {
    double tension = 0.0;
    hawser::InteractionId line;
    void after_step(const hawser::World& world, std::span<const hawser::Event>) override {
        tension = std::max(tension, -world.force(line)[0]);
    }
    std::string objection() const override {
        return tension > 3e6 ? "the line carries more than 3 MN" : "";
    }
};

[[maybe_unused]] void replay_run() {
    // clang-format off
    const auto run = hawser::record::Recording::open("run.hwr");
    for (std::size_t i = 0; i < run.frame_count(); ++i) {
        const hawser::record::Frame frame = run.frame(i);   // poses in single precision
        // read frame.time, frame.poses, frame.tensions
    }

    hawser::scene::Scene again = hawser::scene::load_text(run.scene_text, "again");
    again.world.prepare();
    again.world.state().restore(run.snapshot);
    hawser::record::Repeater repeater(run);
    while (again.world.step_count() < run.end_step) {
        repeater.before_step(again.world);
        if (again.world.step() != hawser::Status::ok) break;
    }
    // again.world.state().hash() == run.end_hash, with the same instruction set
    // clang-format on
}

}  // namespace
}  // namespace hawser::test
