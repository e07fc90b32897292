// SPDX-License-Identifier: Apache-2.0
/// A failed step has no effect: the next step gives the bits of a world that never tried it,
/// for any edits of systems before the failure. A replay of the recording agrees.
#include <hawser/hawser.h>
#include <hawser/session.h>

#include "support/random.h"
#include "support/repeat.h"
#include "support/tier.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace hawser::test {
namespace {

/// Return the last body that moves in space; invalid if there is none.
BodyId mover(const World& w) {
    BodyId found{};
    for (const BodyId id : w.bodies()) {
        const BodyKind kind = w.body_def(id).kind;
        if (kind == BodyKind::lump || kind == BodyKind::rigid) found = id;
    }
    return found;
}

/// Last system of a world: makes steps fail on request.
class Saboteur final : public System {
  public:
    enum class Means { none, nan_load, bad_input, cancel, refused_edit, late };
    [[nodiscard]] std::string_view name() const noexcept override { return "saboteur"; }
    void prestep(Prestep& now, Loads& loads) noexcept override {
        ++calls;
        const BodyId body = mover(now.world);
        if (means == Means::nan_load)
            loads.add_force(body, Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
        if (means == Means::bad_input) now.set_input(InputId{9999}, 1.0);
        if (means == Means::refused_edit) {
            (void)now.edits.add_body({.name = "late", .kind = BodyKind::lump, .mass = 1.0});
            now.edits.remove_body(BodyId{9999});
        }
        if (means == Means::cancel) world->cancel();
        // Velocities overflow after the solution.
        if (means == Means::late) loads.add_force(body, Vec3::Constant(1e300));
    }
    void visit_state(StateVisitor& visitor) override { visitor.visit(calls); }

    Means means = Means::none;
    World* world = nullptr;
    std::int64_t calls = 0;
};

struct Trial {
    explicit Trial(const std::string& file) : session({.scene = file}), world(session.world()) {
        saboteur = static_cast<Saboteur*>(&world.add_system(std::make_unique<Saboteur>()));
        saboteur->world = &world;
    }
    Session session;
    World& world;
    Saboteur* saboteur = nullptr;
    ShapeId shape{};
};

/// Try a step that fails. @param by_session  Include changes of the timeline before the step, which
/// remain. @return its status.
Status fail(Trial& run, Random& random, bool by_session) {
    run.saboteur->means = static_cast<Saboteur::Means>(random.integer(0, 5));
    if (run.saboteur->means == Saboteur::Means::none) run.world.cancel();
    const Status status = by_session ? run.session.step() : run.world.step();
    run.saboteur->means = Saboteur::Means::none;
    return status;
}

/// Add or remove a shape between steps: a change after which the system repairs less.
void change_shape(Trial& run) {
    World& w = run.world;
    if (w.alive(run.shape)) {
        w.remove_shape(run.shape);
        return;
    }
    for (const BodyId id : w.bodies())
        if (w.body_def(id).kind == BodyKind::fixed) {
            run.shape = w.add_shape({.kind = ShapeKind::sphere,
                                     .body = id,
                                     .position = {1e3, 1e3, -1e3},
                                     .radius = 0.5});
            return;
        }
}

void expect_nothing_left(const std::string& file, int steps, std::uint32_t seed) {
    SCOPED_TRACE(file + ", seed " + std::to_string(seed));
    Trial tried(file), plain(file);
    Random random(seed);
    int failed = 0;
    for (int i = 0; i < steps; ++i) {
        // Before the failed step, and after it.
        const auto change = [&] {
            for (Trial* run : {&tried, &plain}) change_shape(*run);
        };
        if (i % 11 == 10) change();
        while (random.chance(0.4)) {
            const std::uint64_t before = tried.world.state().hash();
            const std::size_t bodies = tried.world.bodies().size();
            const Status status = fail(tried, random, false);
            ASSERT_NE(status, Status::ok) << "a step that should fail passes";
            ++failed;
            ASSERT_EQ(tried.world.state().hash(), before)
                << "step " << i << " " << to_string(status);
            ASSERT_EQ(tried.world.bodies().size(), bodies);
            ASSERT_FALSE(tried.world.find_body("late").valid());
        }
        if (i % 17 == 16) change();
        const Status a = tried.session.step(), b = plain.session.step();
        ASSERT_EQ(a, b) << "step " << i;
        ASSERT_EQ(tried.world.state().hash(), plain.world.state().hash()) << "step " << i;
        if (a != Status::ok) break;
    }
    EXPECT_GT(failed, 0);
    EXPECT_EQ(tried.world.state().save(), plain.world.state().save());
    EXPECT_EQ(tried.world.state().identity(), plain.world.state().identity());
}

std::string scene(const char* name) { return std::string("scenes/") + name + ".json"; }

TEST(FailedStepOfAScene, LeavesNothingBehind) {
    for (const std::uint32_t seed : seeds(1, 1, 3, 10))
        for (const char* name : {"wire_bollard", "anchor_run_fine", "anchor_adaptive",
                                 "crane_knuckle", "box_stack", "wire_pins"})
            expect_nothing_left(scene(name), 30, seed);
}

TEST(FailedStepOfAScene, LeavesNothingBehindAnywhere_full) {
    for (const std::uint32_t seed : seeds(1, 1, 3, 10))
        for (const char* name :
             {"payout", "tow_payout", "wire_bollard", "anchor_run_fine", "anchor_contact",
              "wire_slide", "crane_knuckle", "box_stack", "chain_gypsy", "winch_modes", "wire_pins",
              "chaser", "anchor_adaptive", "tackle", "wire_cross", "wire_edge", "floating_box"})
            expect_nothing_left(scene(name), 300, seed);
}

TEST(FailedStepOfAScene, AReplayAgrees) {
    const std::filesystem::path file = std::filesystem::temp_directory_path() /
                                       ("hawser_failed_" + std::to_string(::getpid()) + ".hwr");
    for (const char* name : {"wire_bollard", "anchor_run_fine"}) {
        SCOPED_TRACE(name);
        int edited = 0;
        {
            Trial run(scene(name));
            run.session.record(file);
            Random random(7);
            for (int i = 0; i < 40; ++i) {
                // Changes between steps and failed steps, in any order.
                const auto inputs = run.world.inputs();
                if (!inputs.empty() && random.chance(0.3)) {
                    const InputId id =
                        inputs[static_cast<std::size_t>(random.integer(0, 999)) % inputs.size()];
                    run.world.set_input(id, run.world.input(id));
                }
                while (random.chance(0.4)) ASSERT_NE(fail(run, random, true), Status::ok);
                const std::size_t before = run.world.bodies().size();
                ASSERT_EQ(run.session.step(), Status::ok);
                edited += run.world.bodies().size() != before ? 1 : 0;
            }
            EXPECT_EQ(run.session.finish(), record::Ending::finished);
        }
        EXPECT_GT(edited, 0) << "or no system has edited anything";
        (void)expect_repeats(record::Recording::open(file), 1);
    }
    std::filesystem::remove(file);
}

}  // namespace
}  // namespace hawser::test
