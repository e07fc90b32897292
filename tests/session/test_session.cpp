// SPDX-License-Identifier: Apache-2.0
/// Sessions against worlds that are stepped by hand, and against replays of their recordings.
#include <hawser/hawser.h>
#include <hawser/repeater.h>
#include <hawser/session.h>

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

namespace fs = std::filesystem;

/// A box on a rod, driven by an input, and a box in free fall.
const std::string kScene = R"({
  "version": 1, "name": "swing", "settings": {"step": 0.01},
  "bodies": [
    {"name": "ground", "kind": "fixed"},
    {"name": "bob", "mass": 3.0, "box": [0.1, 0.1, 0.1], "position": [1, 0, 0]},
    {"name": "free", "mass": 2.0, "box": [0.1, 0.2, 0.3], "position": [5, 0, 0]}],
  "interactions": [{"name": "rod", "kind": "distance", "bodies": ["ground", "bob"],
                    "length": 1.0}],
  "inputs": [{"name": "push_x", "body": "bob", "component": "force_x", "min": -50, "max": 50},
             {"name": "push_z", "body": "bob", "component": "force_z", "min": -50, "max": 50}]
})";

/// Folder of one test, deleted by the destructor.
struct Folder {
    fs::path path = fs::temp_directory_path() / ("hawser_session_" + std::to_string(::getpid()));
    Folder() { fs::create_directories(path); }
    ~Folder() { fs::remove_all(path); }
    [[nodiscard]] std::string operator/(const char* name) const { return (path / name).string(); }
};

double push_at(int step) { return 20.0 * std::sin(0.1 * step); }

void push(World& driven, int step) {
    if (step % 3 == 0) driven.set_input(InputId{0}, push_at(step));
}

/// Make changes like a client: several in a step, some beyond the range of the input.
void drive(World& driven, int step) {
    if (step % 3 == 0) driven.set_input(InputId{0}, push_at(step));
    if (step % 7 == 0) driven.set_input(InputId{1}, 100.0 * push_at(step));
    if (step == 10)
        driven.add_body(
            {.name = "late", .kind = BodyKind::lump, .position = {9, 0, 0}, .mass = 1.0});
    if (step == 40) driven.remove_body(driven.find_body("late"));
    if (step == 20) driven.set_force(BodyId{2}, {1.0, -2.0, 30.0}, {0.1, 0.0, -0.2});
    if (step == 20) driven.set_force(BodyId{1}, {5.0, 0.0, 0.0}, Vec3::Zero());
    if (step == 20) driven.set_input(InputId{0}, 4.0);
    if (step == 60) driven.set_force(BodyId{2}, Vec3::Zero(), Vec3::Zero());
}

std::uint64_t hash_of_world(int steps) {
    scene::Scene scene = scene::load_text(kScene, "swing");
    for (int k = 0; k < steps; ++k) {
        drive(scene.world, k);
        EXPECT_EQ(scene.world.step(), Status::ok);
    }
    return scene.world.state().hash();
}

/// Replay a recording. @return number of frames with its hash, before the first difference.
std::size_t repeated(const record::Recording& recording, bool with_changes = true) {
    scene::Scene scene = scene::load_text(recording.scene_text, "recorded");
    scene.world.prepare();
    scene.world.state().restore(recording.snapshot);
    record::Repeater repeater(recording);
    for (std::size_t i = 0; i < recording.frame_count(); ++i) {
        const record::Frame frame = recording.frame_head(i);
        while (scene.world.step_count() < frame.step) {
            if (with_changes) repeater.before_step(scene.world);
            if (scene.world.step() != Status::ok) return i;
        }
        if (scene.world.state().hash() != frame.hash) return i;
    }
    return recording.frame_count();
}

TEST(Session, StepsAsTheWorldDoes) {
    Session session({.scene_text = kScene});
    for (int k = 0; k < 100; ++k) {
        drive(session.world(), k);
        ASSERT_EQ(session.step(), Status::ok);
    }
    EXPECT_EQ(session.finish(), record::Ending::finished);
    EXPECT_DOUBLE_EQ(session.time(), 1.0);
    EXPECT_EQ(session.world().state().hash(), hash_of_world(100));
}

TEST(Session, RecordingRepeatsEveryChange) {
    const Folder folder;
    Session session({.scene_text = kScene, .record = folder / "run.hwr", .every = 7});
    for (int k = 0; k < 100; ++k) {
        drive(session.world(), k);
        ASSERT_EQ(session.step(), Status::ok);
    }
    session.finish();
    const auto recording = record::Recording::open(folder / "run.hwr");
    EXPECT_EQ(recording.damage, "");
    EXPECT_EQ(recording.ending, record::Ending::finished);
    EXPECT_EQ(recording.end_step, 100);
    EXPECT_EQ(recording.end_hash, hash_of_world(100));
    // Steps 0, 7, …, 98 and the last state.
    ASSERT_EQ(recording.frame_count(), 16U);
    EXPECT_EQ(recording.inputs.size(), 34U + 15U + 1U);
    EXPECT_EQ(repeated(recording), 16U);
    EXPECT_EQ(repeated(recording, false), 1U) << "without the changes it must come out different";
}

TEST(Session, ControlFileIsAsSettingTheInputs) {
    const Folder folder;
    std::ofstream(folder / "levers.csv") << "time,push_x\n0,3\n0.25,-7\n0.5,2\n";
    Session by_file({.scene_text = kScene, .control = folder / "levers.csv"});
    Session by_hand({.scene_text = kScene});
    for (int k = 0; k < 80; ++k) {
        if (k == 0) by_hand.set_input("push_x", 3.0);
        if (k == 25) by_hand.set_input("push_x", -7.0);
        if (k == 50) by_hand.set_input("push_x", 2.0);
        ASSERT_EQ(by_file.step(), Status::ok);
        ASSERT_EQ(by_hand.step(), Status::ok);
        ASSERT_EQ(by_file.world().state().hash(), by_hand.world().state().hash()) << k;
    }
}

/// Inputs of systems: a file is rejected; values set during the run are clamped and reported.
TEST(Session, SignalsBeyondTheirRange) {
    std::string text = kScene;
    text.insert(text.rfind("]"), R"(, {"name": "waves", "signal": "sea.waves", "factor": 2,
                                       "min": 0, "max": 1})");
    text.insert(text.rfind("}"), R"(, "sea": {"depth": 50})");
    const Folder folder;
    std::ofstream(folder / "levers.csv") << "time,waves,sea.wind\n0,1,3\n1,1.5,3\n";
    try {
        const Session session({.scene_text = text, .control = folder / "levers.csv"});
        ADD_FAILURE();
    } catch (const std::runtime_error& error) {
        const std::string said = error.what();
        EXPECT_NE(said.find("levers.csv:3:3: 1.5 is not within the range of the input \"waves\""),
                  std::string::npos)
            << said;
    }
    Session session({.scene_text = text});
    session.set_input("waves", 0.75);
    EXPECT_EQ(session.world().system_signal("sea.waves"), 1.5);
    session.set_input("waves", 7.0);
    EXPECT_EQ(session.world().system_signal("sea.waves"), 2.0);
    session.set_input("sea.wind", -5.0);
    EXPECT_EQ(session.world().system_signal("sea.wind"), 0.0);
    ASSERT_EQ(session.step(), Status::ok);
    ASSERT_EQ(session.events().size(), 1U);
    EXPECT_EQ(session.events()[0].kind, EventKind::input_clamped);
    EXPECT_EQ(session.events()[0].value, -5.0);
}

TEST(Session, SavedStateGoesOn) {
    const Folder folder;
    Session whole({.scene_text = kScene});
    std::vector<std::byte> bytes;
    for (int k = 0; k < 50; ++k) {
        push(whole.world(), k);
        ASSERT_EQ(whole.step(), Status::ok);
        if (k == 29) whole.save(folder / "at30.hws");
        if (k == 29) bytes = whole.world().state().save();
    }
    for (const SessionDef& def : {SessionDef{.scene_text = kScene, .restore = folder / "at30.hws"},
                                  SessionDef{.scene_text = kScene, .state = bytes}}) {
        Session rest(def);
        EXPECT_EQ(rest.world().step_count(), 30);
        for (int k = 30; k < 50; ++k) {
            push(rest.world(), k);
            ASSERT_EQ(rest.step(), Status::ok);
        }
        EXPECT_EQ(rest.world().state().hash(), whole.world().state().hash());
    }
}

TEST(Session, MistakesChangeAndRecordNothing) {
    const Folder folder;
    Session session({.scene_text = kScene, .record = folder / "run.hwr"});
    const std::uint64_t before = session.world().state().hash();
    try {
        session.set_input("push_y", 1.0);
        ADD_FAILURE() << "an input that is not there was set";
    } catch (const DefError& error) {
        EXPECT_NE(std::string(error.what()).find("\"push_x\""), std::string::npos) << error.what();
    }
    EXPECT_THROW(session.set_input("push_x", std::nan("")), DefError);
    EXPECT_THROW(session.world().set_input(InputId{7}, 1.0), DefError);
    EXPECT_THROW(session.world().set_force(BodyId{9}, Vec3::UnitX(), Vec3::Zero()), DefError);
    EXPECT_EQ(session.world().state().hash(), before);
    session.finish();
    const auto recording = record::Recording::open(folder / "run.hwr");
    EXPECT_TRUE(recording.changes.empty() && recording.inputs.empty());

    EXPECT_THROW(Session(SessionDef{}), DefError);
    EXPECT_THROW(Session({.scene = "a.json", .scene_text = kScene}), DefError);
    EXPECT_THROW(Session({.scene_text = kScene, .every = 0}), DefError);
    EXPECT_THROW(Session({.scene = "there_is_none.json"}), scene::SceneError);
    EXPECT_THROW(Session({.scene_text = kScene, .record = folder / "no/such/folder.hwr"}),
                 record::RecordingError);
}

/// Counts steps, and rejects a given step.
struct Judge : Observer {
    int before = 0, after = 0, refused = -1;
    void before_step(const World&) override { ++before; }
    void after_step(const World&, std::span<const Event>) override { ++after; }
    [[nodiscard]] std::string objection() const override { return after == refused ? "no" : ""; }
};

TEST(Session, ObserverEndsARun) {
    const Folder folder;
    Judge judge;
    judge.refused = 4;
    Session session({.scene_text = kScene, .record = folder / "run.hwr", .verify = true});
    session.observe(judge);
    for (int k = 0; k < 3; ++k) ASSERT_EQ(session.step(), Status::ok) << session.objection();
    EXPECT_EQ(session.step(), Status::diverged);
    EXPECT_EQ(session.objection(), "no");
    EXPECT_EQ(judge.before, 4);
    EXPECT_EQ(judge.after, 4);
    EXPECT_EQ(session.finish(), record::Ending::failed);
    const auto recording = record::Recording::open(folder / "run.hwr");
    EXPECT_EQ(recording.ending, record::Ending::failed);
    EXPECT_EQ(recording.end_step, 4);
}

TEST(Session, CancelledStepIsTakenAgain) {
    Session session({.scene_text = kScene}), other({.scene_text = kScene});
    session.cancel();
    EXPECT_EQ(session.step(), Status::cancelled);
    EXPECT_EQ(session.world().step_count(), 0);
    ASSERT_EQ(session.step(), Status::ok);
    ASSERT_EQ(other.step(), Status::ok);
    EXPECT_EQ(session.world().state().hash(), other.world().state().hash());
    session.cancel();
    EXPECT_EQ(session.step(), Status::cancelled);
    EXPECT_EQ(session.finish(), record::Ending::interrupted);
}

TEST(Session, WorldOfTheCaller) {
    const Folder folder;
    World world({.step = 0.01});
    const BodyId ball = world.add_body({.name = "ball", .kind = BodyKind::lump, .mass = 2.0});
    Session session(std::move(world), {.record = folder / "run.hwr", .csv = folder / "run.csv"});
    session.world().set_force(ball, {0.0, 0.0, 2.0 * 9.81},
                              Vec3::Zero());  // its weight keeps it in place
    for (int k = 0; k < 10; ++k) ASSERT_EQ(session.step(), Status::ok);
    session.finish();
    // Twice the rounding of the weight over 0.1 s, with a margin.
    EXPECT_LT(session.world().pose(ball).position.norm(), 1e-15);
    const auto recording = record::Recording::open(folder / "run.hwr");
    EXPECT_EQ(recording.frame_count(), 11U);
    EXPECT_EQ(recording.scene_text, "");
    EXPECT_TRUE(fs::exists(folder / "run.csv"));
}

}  // namespace
}  // namespace hawser::test
