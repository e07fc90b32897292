// SPDX-License-Identifier: Apache-2.0
/// Changes of a world between steps are recorded, and repeated from the recording.
#include <hawser/repeater.h>
#include "record/changes.h"
#include "record/recording_listener.h"
#include "record/recording_writer.h"
#include "record/small_scene.h"
#include "support/editor.h"
#include "support/tier.h"

#include <optional>

namespace hawser::test {

using record::Recording;

namespace {

/// Step a world with the changes of its recording. @return number of frames with another motion: a
/// recording contains the actions of systems, not the systems.
int differences(const Recording& r, World& world) {
    int wrong = 0;
    record::Repeater repeater(r);
    for (std::size_t i = 0; i < r.frame_count(); ++i) {
        const record::Frame head = r.frame_head(i);
        while (world.step_count() < head.step) {
            repeater.before_step(world);
            if (world.step() != Status::ok) return -1;
        }
        wrong += world.state().motion_hash() != head.hash ? 1 : 0;
    }
    return wrong;
}

/// Edit a world at random, record it, and repeat it from the recording.
void repeat_edits(std::uint32_t seed) {
    WorldDef def{.on_diverged = OnDiverged::warn};
    World world(def), again(def);
    record::SceneInfo info;
    info.name = "edits";
    const auto file = fresh_folder() / "r.hwr";
    Editor editor(seed, {&world});
    const Editor same_start(seed, {&again});
    int edits = 0;
    {
        record::RecordingWriter out(file, info, world,
                                    {.step = world.settings().step,
                                     .instruction_set = instruction_set(),
                                     .version = version(),
                                     .processor = "test"});
        record::RecordingListener listener(out, world);
        for (int step = 0; step < 90; ++step) {
            for (int k = 0; k < 2; ++k, ++edits) editor.edit();
            if (step == 40) world.set_force(world.bodies()[1], {0, 0, 900.0}, Vec3::Zero());
            if (step == 50) world.set_velocity(world.bodies()[2], {.linear = {1, 0, 0}});
            if (step == 60) world.set_pose(world.bodies()[2], {.position = {0, 0, 6}});
            listener.flush();
            ASSERT_EQ(world.step(), Status::ok);
            listener.flush(step);  // values set by systems in the step
            out.add_loads(world);
            out.add_frame(world);
        }
        out.finish(world, record::Ending::finished);
    }
    const Recording r = Recording::open(file);
    EXPECT_EQ(r.damage, "");
    EXPECT_EQ(r.start_bodies, 9U);
    EXPECT_GT(r.bodies.size(), r.start_bodies);
    ASSERT_EQ(r.frame_count(), 91U);
    again.state().restore(r.snapshot);
    EXPECT_EQ(differences(r, again), 0);
    EXPECT_EQ(again.state().motion_hash(), world.state().motion_hash());
    // In the last frame, existing bodies have their positions.
    const record::Frame last = r.frame(90);
    std::size_t there = 0;
    for (std::size_t b = 0; b < r.bodies.size(); ++b) there += last.there[b] ? 1 : 0;
    EXPECT_EQ(there, world.bodies().size());
    for (const BodyId id : world.bodies()) {
        const BodyDef& d = world.body_def(id);
        if (d.name.empty()) continue;
        std::optional<std::size_t> found;
        for (std::size_t b = 0; b < r.bodies.size(); ++b)
            if (last.there[b] && r.bodies[b].name == d.name) found = b;
        ASSERT_TRUE(found) << d.name;
        // Single precision of some metres.
        EXPECT_LT((last.poses[*found].position - world.pose(id).position).norm(), 1e-5);
    }
}

}  // namespace

TEST(Changes, RandomEditsAreRepeatedFromTheRecording) {
    for (const std::uint32_t seed : seeds(11, 1, 4, 40)) {
        SCOPED_TRACE(seed);
        repeat_edits(seed);
        if (HasFatalFailure()) return;
    }
}

TEST(Changes, AnInputOfALaterThingIsNoCommandOfTheScene) {
    SmallScene scene, again;
    const auto file = fresh_folder() / "r.hwr";
    {
        record::RecordingWriter out(file, scene.info, scene.world,
                                    {.step = scene.world.settings().step,
                                     .instruction_set = instruction_set(),
                                     .version = version(),
                                     .processor = "test"});
        record::RecordingListener listener(out, scene.world);
        scene.world.set_input({0}, 20.0);
        const InputId lift = scene.world.add_input(
            {.name = "lift", .body = BodyId{2}, .component = 2, .unit = "N", .spring = 0.0});
        scene.world.set_input(lift, 700.0);
        for (int i = 0; i < 5; ++i) {
            listener.flush();
            ASSERT_EQ(scene.world.step(), Status::ok);
            out.add_frame(scene.world);
        }
        out.finish(scene.world, record::Ending::finished);
    }
    const Recording r = Recording::open(file);
    EXPECT_EQ(r.damage, "");
    ASSERT_EQ(r.inputs.size(), 1U);
    EXPECT_EQ(r.inputs[0].value, 20.0);
    again.world.state().restore(r.snapshot);
    EXPECT_EQ(differences(r, again.world), 0);
    EXPECT_GT(again.world.velocity(BodyId{2}).linear.z(), 0.0) << "it was lifted";
    const InputDef& lift = again.world.input_def(again.world.find_input("lift"));
    EXPECT_EQ(lift.unit, "N");
    EXPECT_EQ(lift.spring, 0.0);
}

TEST(Changes, BytesThatAreNoneAreRefused) {
    SmallScene scene;
    const std::vector<std::byte> unknown{std::byte{200}};
    EXPECT_THROW(record::apply_changes(unknown, scene.world), record::BadBytes);
    const std::vector<std::byte> cut{std::byte{6}, std::byte{0}};  // a removal without an id
    EXPECT_THROW(record::apply_changes(cut, scene.world), record::BadBytes);
    record::ChangeBytes bytes;
    bytes.removed(BodyId{7, 0});
    EXPECT_THROW(record::apply_changes(bytes.bytes(), scene.world), DefError);
    bytes.clear();
    BodyDef heavy{.name = "wrong", .kind = BodyKind::lump, .mass = -1.0};
    bytes.added(heavy);
    EXPECT_THROW(record::apply_changes(bytes.bytes(), scene.world), DefError);
    EXPECT_EQ(scene.world.bodies().size(), 3U);
}

}  // namespace hawser::test
