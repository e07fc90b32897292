// SPDX-License-Identifier: Apache-2.0
/// Runs that start from a saved state: control file and timeline together, recordings of objects
/// that exist by then, verification by separate code; and recordings of failed steps.
#include <hawser/hawser.h>
#include <hawser/recording.h>
#include <hawser/session.h>

#include "support/repeat.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>

namespace hawser::test {
namespace {

struct RestoredFolder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("hawser_restored_" + std::to_string(::getpid()));
    RestoredFolder() { std::filesystem::create_directories(path); }
    ~RestoredFolder() { std::filesystem::remove_all(path); }
    [[nodiscard]] std::string file(const char* name) const { return (path / name).string(); }
};

/// A wire that is cut at 1 s in the sea, and a winch that hauls in nodes.
constexpr const char* kCutAtSea = R"({
  "version": 1, "name": "cut_at_sea", "settings": {"step": 0.02},
  "line_types": {"wire": {"mass_per_length": 5, "EA": 5e6, "diameter": 0.04, "cd_normal": 1.5}},
  "bodies": [
    {"name": "tug", "kind": "fixed", "position": [0, 0, 3]},
    {"name": "barge", "kind": "fixed", "position": [60, 0, 2]}],
  "cables": [
    {"name": "tow", "line_type": "wire", "from": {"body": "tug"}, "to": {"body": "barge"},
     "length": 64, "elements": 32, "shape": "hanging", "consistent_mass": true}],
  "winches": [{"name": "hoist", "cable": "tow", "core_radius": 0.5, "width": 1, "stored": 30,
     "inertia": 60, "torque_haul": 4e4, "brake_static": 2e4}],
  "sea": {"depth": 50, "waves": [{"kind": "regular", "height": 1, "period": 6}],
          "current": [{"speed": 0.5, "direction_deg": 90}]},
  "timeline": [
    {"at": 0.5, "set": {"hoist.mode": "speed", "hoist.speed": -1.5, "sea.waves": 0.7}},
    {"at": 1, "cut": "tow", "s": 30}]
})";

constexpr int kRestoredSteps = 250;
const SessionDef kUncontrolled{.scene_text = kCutAtSea};

/// Run to the end. @return the hash at the end.
std::uint64_t finish_run(Session& session) {
    while (session.world().step_count() < kRestoredSteps)
        if (session.step() != Status::ok) break;
    EXPECT_EQ(session.objection(), "") << session.time();
    EXPECT_EQ(session.world().step_count(), kRestoredSteps);
    return session.world().state().hash();
}

void save_at(const SessionDef& def, int step, const std::string& file) {
    Session session(def);
    while (session.world().step_count() < step) ASSERT_EQ(session.step(), Status::ok);
    session.save(file);
}

/// A fault: values of the control file from before the save were set again, over later values of
/// the timeline.
TEST(SessionRestored, GoesOnWithControlFileAndTimeline) {
    const RestoredFolder folder;
    std::ofstream(folder.file("c.csv")) << "time,sea.waves,hoist.speed\n"
                                           "0.2,1.4,0.1\n0.3,1.5,\n1.5,,-0.5\n1.6,,-1\n3,0.2,\n";
    SessionDef def = kUncontrolled;
    def.control = folder.file("c.csv");
    Session whole(def);
    const std::uint64_t end = finish_run(whole);
    for (const int at : {5, 11, 40, 60, 100, 200}) {
        save_at(def, at, folder.file("at.hws"));
        SessionDef rest = def;
        rest.restore = folder.file("at.hws");
        Session again(rest);
        EXPECT_EQ(finish_run(again), end) << at;
    }
}

/// Values of a file for the time before the save apply if the run did not have them: another file.
TEST(SessionRestored, TakesWhatAnotherControlFileHasByThen) {
    const RestoredFolder folder;
    save_at(kUncontrolled, 100, folder.file("at.hws"));
    std::ofstream(folder.file("c.csv")) << "time,sea.waves,hoist.speed\n0.2,1.4,0.1\n1.5,,-0.5\n";
    SessionDef rest = kUncontrolled;
    rest.restore = folder.file("at.hws");
    rest.control = folder.file("c.csv");
    const Session again(rest);
    EXPECT_EQ(again.world().system_signal("sea.waves"), 0.7);  // Set by the timeline at 0.5 s.
    EXPECT_EQ(again.world().system_signal("hoist.speed"), -0.5);
}

/// A fault: such recordings belonged to no world, or were rejected if nodes had been removed.
TEST(SessionRestored, IsRecordedAndRepeated) {
    const RestoredFolder folder;
    Session whole(kUncontrolled);
    const std::uint64_t end = finish_run(whole);
    for (const int at : {20, 60, 200}) {
        save_at(kUncontrolled, at, folder.file("at.hws"));
        SessionDef rest = kUncontrolled;
        rest.restore = folder.file("at.hws");
        rest.record = folder.file("run.hwr");
        Session again(rest);
        EXPECT_EQ(again.world().step_count(), at);
        EXPECT_EQ(finish_run(again), end) << at;
        again.finish();
        const record::Recording recording = record::Recording::open(folder.file("run.hwr"));
        EXPECT_EQ(recording.damage, "");
        for (const int threads : {1, 2})
            EXPECT_EQ(expect_repeats(recording, threads).scene.world.step_count(), kRestoredSteps);
    }
}

/// A fault: the wire's end at the cut was treated like one attached to a body from the start.
TEST(SessionRestored, IsVerified) {
    const RestoredFolder folder;
    for (const int at : {20, 60, 200}) {
        save_at(kUncontrolled, at, folder.file("at.hws"));
        SessionDef rest = kUncontrolled;
        rest.restore = folder.file("at.hws");
        rest.verify = true;
        Session again(rest);
        (void)finish_run(again);
        // Back to its start, within the run.
        Session first(kUncontrolled);
        while (first.world().step_count() < at) ASSERT_EQ(first.step(), Status::ok);
        again.restore(first.world().state().structure(), first.world().state().save());
        (void)finish_run(again);
    }
}

/// Sets an input in each step, and loads a body with NaN in the last one.
class Pushing final : public System {
  public:
    Pushing(InputId input, BodyId body) : input_(input), body_(body) {}
    [[nodiscard]] std::string_view name() const noexcept override { return "pushing"; }
    void prestep(Prestep& now, Loads& loads) noexcept override {
        now.set_input(input_, 1.0 + 0.1 * static_cast<double>(now.count));
        loads.add_force(body_, {now.count < 30 ? 1.0 : std::nan(""), 0.0, 0.0});
    }
    void visit_state(StateVisitor&) override {}
    [[nodiscard]] std::unique_ptr<System> clone() const override {
        return std::make_unique<Pushing>(input_, body_);
    }

  private:
    InputId input_;
    BodyId body_;
};

/// A fault: values set in the failed step were replayed, although the world had undone them.
TEST(SessionRestored, RecordsOfAStepThatFailedWhatStays) {
    const RestoredFolder folder;
    {
        scene::Scene scene = scene::load_text(
            R"({"version": 1, "name": "pushed", "settings": {"step": 0.02},
                "bodies": [{"name": "ball", "kind": "lump", "mass": 2}],
                "inputs": [{"name": "push", "body": "ball", "component": "force_x"}]})",
            "pushed");
        scene.world.add_system(std::make_unique<Pushing>(scene.world.find_input("push"),
                                                         scene.world.find_body("ball")));
        Session session(std::move(scene), {.record = folder.file("run.hwr")});
        Status status = Status::ok;
        while (status == Status::ok) status = session.step();
        EXPECT_EQ(status, Status::bad_load);
        EXPECT_EQ(session.world().step_count(), 30);
        session.finish();
    }
    const record::Recording recording = record::Recording::open(folder.file("run.hwr"));
    EXPECT_EQ(recording.ending, record::Ending::failed);
    EXPECT_EQ(expect_repeats(recording, 1).scene.world.step_count(), 30);
}

/// A replay has no winch, which had the mass of the wire paid out.
TEST(SessionRestored, RecordsWhatComesOffADrum) {
    const RestoredFolder folder;
    std::string text = kCutAtSea;
    const std::string cut = R"({"at": 1, "cut": "tow", "s": 30})";
    text.replace(text.find(cut), cut.size(),
                 R"({"at": 1, "detach": {"wire": "tow", "end": "first"}})");
    for (const char* speed : {"-1.5", "0", "1.5"}) {
        std::string one = text;
        one.replace(one.find("-1.5"), 4, speed);
        {
            Session session({.scene_text = one, .record = folder.file("run.hwr"), .verify = true});
            (void)finish_run(session);
            session.finish();
        }
        const record::Recording recording = record::Recording::open(folder.file("run.hwr"));
        EXPECT_EQ(expect_repeats(recording, 1).scene.world.step_count(), kRestoredSteps) << speed;
    }
}

}  // namespace
}  // namespace hawser::test
