// SPDX-License-Identifier: Apache-2.0
/// Actions of systems are recorded as data: a replay needs none of their code.
#include <hawser/hawser.h>
#include <hawser/repeater.h>

#include "record/recording_listener.h"
#include "record/recording_writer.h"
#include "record/small_scene.h"

#include <cmath>

namespace hawser::test {

using record::Recording;

namespace {

/// Water around the box, and a system that pushes it by the scene's input and by an input that
/// rotates with the body.
struct Hand final : System {
    BodyId box;
    InputId push, thruster;
    double phase = 0.0;
    [[nodiscard]] std::string_view name() const noexcept override { return "hand"; }
    void visit_state(StateVisitor& visitor) override { visitor.visit(phase); }
    void prestep(Prestep& now, Loads& loads) noexcept override {
        phase += 0.1;
        now.set_input(push, 40.0 * std::sin(phase));
        now.set_input(thruster, 15.0 * std::cos(phase));
        Eigen::Matrix<double, 6, 6> water = Eigen::Matrix<double, 6, 6>::Zero();
        water.diagonal() << 30, 50, 60, 2, 3, 4;
        water(3, 1) = water(1, 3) = 5.0;  // sway and roll
        loads.add_mass(box, water);
        loads.add_damping(box, (20.0 * water).eval());
        loads.add_force(box, {3.0, 0.0, 1.0 + std::sin(phase)});
    }
};

InputId add_thruster(World& world) {
    return world.add_input({.name = "thruster", .body = BodyId{2}, .component = 0, .local = true});
}

}  // namespace

TEST(SystemsRecorded, AreRepeatedWithoutTheirCode) {
    SmallScene scene, again;
    const InputId thruster = add_thruster(scene.world);
    (void)add_thruster(again.world);
    auto hand = std::make_unique<Hand>();
    hand->box = BodyId{2};
    hand->push = scene.world.find_input("box.push");
    hand->thruster = thruster;
    const System& acting = scene.world.add_system(std::move(hand));
    for (int i = 0; i < 3; ++i) ASSERT_EQ(scene.world.step(), Status::ok);
    const auto file = fresh_folder() / "r.hwr";
    {
        record::RecordingWriter out(file, scene.info, scene.world,
                                    {.step = scene.world.settings().step,
                                     .instruction_set = instruction_set(),
                                     .version = version(),
                                     .processor = "test"});
        record::RecordingListener listener(out, scene.world);
        for (int i = 0; i < 60; ++i) {
            if (i == 40) (void)scene.world.remove_system(acting);
            listener.flush();
            ASSERT_EQ(scene.world.step(), Status::ok);
            out.add_loads(scene.world);
            out.add_frame(scene.world);
        }
        out.finish(scene.world, record::Ending::finished);
    }
    const Recording r = Recording::open(file);
    EXPECT_EQ(r.damage, "");
    EXPECT_EQ(r.loads.size(), 40U);
    EXPECT_EQ(r.inputs.size(), 80U);
    again.world.state().restore(r.snapshot);
    record::Repeater repeater(r);
    for (std::size_t i = 0; i < r.frame_count(); ++i) {
        const record::Frame head = r.frame_head(i);
        while (again.world.step_count() < head.step) {
            repeater.before_step(again.world);
            ASSERT_EQ(again.world.step(), Status::ok);
        }
        ASSERT_EQ(again.world.state().motion_hash(), head.hash) << "frame " << i;
    }
    EXPECT_EQ(again.world.state().motion_hash(), scene.world.state().motion_hash());
    EXPECT_GT(scene.world.velocity(BodyId{2}).linear.norm(), 1e-3) << "it moves";
}

}  // namespace hawser::test
