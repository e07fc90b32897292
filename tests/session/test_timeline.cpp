// SPDX-License-Identifier: Apache-2.0
/// Timed operations of a scene: in sessions, their recordings and saved states.
#include <hawser/hawser.h>
#include <hawser/session.h>

#include "support/repeat.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

struct TimelineFolder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("hawser_timeline_" + std::to_string(::getpid()));
    TimelineFolder() { std::filesystem::create_directories(path); }
    ~TimelineFolder() { std::filesystem::remove_all(path); }
    [[nodiscard]] std::string file(const char* name) const { return (path / name).string(); }
};

/// A tow that is cut, falls, and is taken by a hook; a winch that hauls.
const std::string kTow = R"({
  "version": 1, "name": "tow", "settings": {"step": 0.02},
  "line_types": {"wire": {"mass_per_length": 5, "EA": 5e6, "drag": 40, "diameter": 0.04}},
  "bodies": [
    {"name": "tug", "kind": "fixed", "position": [0, 0, 10]},
    {"name": "barge", "kind": "fixed", "position": [60, 0, 10]},
    {"name": "load", "mass": 400, "sphere": 0.5, "position": [0, 10, 5]}],
  "cables": [
    {"name": "tow", "line_type": "wire", "from": {"body": "tug"}, "to": {"body": "barge"},
     "length": 62, "elements": 31, "shape": "hanging"},
    {"name": "fall", "line_type": "wire", "from": {"at": [0, 10, 20]}, "to": {"body": "load"},
     "elements": 8}],
  "winches": [{"name": "hoist", "cable": "fall", "core_radius": 0.5, "width": 1, "stored": 30,
     "inertia": 60, "torque_haul": 4e4, "brake_static": 2e4, "wrap_friction": 0.1}],
  "inputs": [{"name": "push", "body": "load", "component": "force_x", "min": -500, "max": 500}],
  "timeline": [
    {"at": 2, "join": {"wire": "tow", "to": "tow/2", "gear": "pelican_hook", "name": "hook",
      "mass": 30, "length": 0.5, "reach": 50}},
    {"at": 0.5, "set": {"hoist.mode": "speed", "hoist.speed": -0.5, "push": 100}},
    {"at": 1, "cut": "tow", "s": 30, "description": "the tow parts"},
    {"at": 3, "release": "hook"},
    {"at": 4, "detach": {"wire": "tow/2", "end": "last"}},
    {"at": 4, "attach": {"wire": "tow/2", "end": "last", "body": "barge", "name": "eye",
      "reach": 0.5}}]
})";

struct Seen {
    std::vector<std::uint64_t> hashes;
    std::vector<std::pair<std::string, double>> events;
};

/// Run to a step. @param save  File for the state before step `at`; 0: none.
Seen run_to(Session& session, int steps, const std::string& save = "", int at = 0) {
    Seen out;
    while (session.world().step_count() < steps) {
        if (at > 0 && session.world().step_count() == at) session.save(save);
        EXPECT_EQ(session.step(), Status::ok) << session.time();
        out.hashes.push_back(session.world().state().hash());
        for (const Event& e : session.events())
            if (e.kind == EventKind::cut || e.kind == EventKind::join ||
                e.kind == EventKind::detach || e.kind == EventKind::release)
                out.events.emplace_back(to_string(e.kind), e.time);
    }
    return out;
}

TEST(SessionTimeline, DoesWhatItSaysAtItsTimes) {
    Session session({.scene_text = kTow});
    ASSERT_EQ(session.scene().timeline.size(), 6U);
    EXPECT_EQ(to_string(session.scene().timeline[1]), "the tow parts: cut tow at 30 m");
    EXPECT_EQ(to_string(session.scene().timeline[3]), "release hook");
    const Seen seen = run_to(session, 300);
    const std::vector<std::string> kinds{"cut", "join", "release", "detach", "join"};
    const std::vector<double> times{1.0, 2.0, 3.0, 4.0, 4.0};
    ASSERT_EQ(seen.events.size(), kinds.size());
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        EXPECT_EQ(seen.events[k].first, kinds[k]);
        EXPECT_NEAR(seen.events[k].second, times[k], 1e-9);
    }
    const World& w = session.world();
    EXPECT_GT(w.pose(w.find_body("load")).position.z(), 5.5) << "hauled";
    EXPECT_EQ(w.input(w.find_input("push")), 100.0);
    EXPECT_NEAR(w.wires().length(w.wires().find("tow")), 30.0, 1e-9);
    EXPECT_EQ(w.wires().nodes(w.wires().find("tow/2")).size(), 17U);
    EXPECT_TRUE(w.find_interaction("eye").valid());
}

/// The verifier has the state before the operations of the first step.
TEST(SessionTimeline, IsVerifiedFromItsFirstStepOn) {
    std::string text = kTow;
    const std::string list = "\"timeline\": [";
    text.insert(text.find(list) + list.size(),
                R"({"at": 0, "detach": {"wire": "tow", "end": "last"}},
                   {"at": 0, "attach": {"wire": "tow", "end": "last", "body": "barge"}}, )");
    Session session({.scene_text = text, .verify = true});
    for (int k = 0; k < 50; ++k) ASSERT_EQ(session.step(), Status::ok) << session.objection();
}

/// Each operation is reported once, after the next step, and again in a run that goes back.
TEST(SessionTimeline, SaysWhatItDid) {
    Session session({.scene_text = kTow});
    const auto reported = [&](double until) {
        std::vector<double> at;
        while (session.time() < until) {
            EXPECT_EQ(session.step(), Status::ok);
            for (const scene::Operation& o : session.operations()) at.push_back(o.at);
        }
        return at;
    };
    EXPECT_TRUE(session.operations().empty());
    EXPECT_EQ(reported(2.5), (std::vector<double>{0.5, 1.0, 2.0}));
    const Structure made_of = session.world().state().structure();
    const std::vector<std::byte> state = session.world().state().save();
    const std::vector<double> rest{3.0, 4.0, 4.0};
    EXPECT_EQ(reported(5.0), rest);
    session.restore(made_of, state);
    EXPECT_TRUE(session.operations().empty());
    EXPECT_EQ(reported(5.0), rest);
}

/// An input that sets a signal does so from a timeline too, with its factor and in its range.
TEST(SessionTimeline, SetsInputsThatSetSignals) {
    const auto with_lever = [](double value) {
        std::string text = kTow;
        const std::string inputs = "\"inputs\": [", push = "\"push\": 100";
        text.insert(text.find(inputs) + inputs.size(),
                    R"({"name": "lever", "signal": "hoist.speed", "factor": 0.25, "min": -4,
                        "max": 4}, )");
        return text.insert(text.find(push), "\"lever\": " + std::to_string(value) + ", ");
    };
    Session session({.scene_text = with_lever(-3.0)});
    while (session.time() < 0.51) ASSERT_EQ(session.step(), Status::ok);
    EXPECT_EQ(session.world().system_signal("hoist.speed"), -0.75);
    try {
        const Session refused({.scene_text = with_lever(-5.0)});
        FAIL() << "out of range";
    } catch (const scene::SceneError& error) {
        EXPECT_EQ(error.path, "/timeline/1/set/lever");
    }
}

TEST(SessionTimeline, RecordingsRepeatItAndSavedStatesGoOn) {
    const TimelineFolder folder;
    Session session({.scene_text = kTow, .record = folder.file("run.hwr")});
    // Saved before each operation's step, just after it, and between.
    Session plain({.scene_text = kTow});
    const Seen all = run_to(session, 260);
    session.finish();
    EXPECT_EQ(run_to(plain, 260).hashes, all.hashes);
    for (const int at : {20, 50, 51, 100, 101, 130, 150, 151, 200, 201, 240}) {
        Session first({.scene_text = kTow});
        (void)run_to(first, at + 1, folder.file("at.hws"), at);
        Session second({.scene_text = kTow, .restore = folder.file("at.hws")});
        ASSERT_EQ(second.world().step_count(), at);
        const Seen rest = run_to(second, 260);
        ASSERT_EQ(rest.hashes.size(), 260U - static_cast<std::size_t>(at));
        EXPECT_TRUE(std::equal(rest.hashes.begin(), rest.hashes.end(), all.hashes.begin() + at))
            << at;
        EXPECT_EQ(rest.events.size(),
                  static_cast<std::size_t>(
                      std::count_if(all.events.begin(), all.events.end(),
                                    [&](const auto& e) { return e.second > 0.02 * at - 1e-9; })))
            << at;
    }
    const record::Recording recording = record::Recording::open(folder.file("run.hwr"));
    for (const int threads : {1, 4}) (void)expect_repeats(recording, threads);
}

TEST(SessionTimeline, ComposesWithControlAndEndsARunThatItCannotGoOnWith) {
    const TimelineFolder folder;
    std::ofstream(folder.file("c.csv")) << "time,push\n0,5\n0.5,7\n";
    Session session({.scene_text = kTow, .control = folder.file("c.csv")});
    (void)run_to(session, 24);
    EXPECT_EQ(session.world().input(session.world().find_input("push")), 5.0);
    (void)run_to(session, 27);
    // At equal times the control file prevails.
    EXPECT_EQ(session.world().input(session.world().find_input("push")), 7.0);
    session.world().wires().remove(session.world().wires().find("tow"));
    try {
        for (int k = 0; k < 60; ++k) ASSERT_EQ(session.step(), Status::ok);
        FAIL() << "the wire is not there";
    } catch (const DefError& error) {
        EXPECT_STREQ(error.what(),
                     "timeline, 1 s, the tow parts: cut tow at 30 m: there is no wire 'tow' now");
    }
    EXPECT_EQ(session.finish(), record::Ending::failed);
}

std::string refusal(const std::string& from, const std::string& to) {
    std::string text = kTow;
    const auto place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    text.replace(place, from.size(), to);
    try {
        (void)scene::load_text(text, "tow");
    } catch (const scene::SceneError& error) {
        return error.what();
    }
    return "(none)";
}

TEST(SessionTimeline, MistakesAreToldWithTheirPlace) {
    const auto expect = [](const char* from, const char* to, const char* said) {
        EXPECT_EQ(refusal(from, to), said);
    };
    expect(R"("cut": "tow", "s": 30)", R"("cut": "tov", "s": 30)",
           "tow: /timeline/2/cut: there is no wire \"tov\" then; did you mean \"tow\"?");
    expect(R"("s": 30)", R"("s": 62)", "tow: /timeline/2/s: the wire \"tow\" is 62 m long then");
    expect(R"("cut": "tow", "s": 30)", R"("cut": "tow")",
           "tow: /timeline/2: a cut needs the key \"s\", where along the wire");
    expect(R"("to": "tow/2")", R"("to": "tow/3")",
           "tow: /timeline/0/join/to: there is no wire \"tow/3\" then; did you mean \"tow/2\"?");
    expect(R"("hoist.speed")", R"("hoist.sped")",
           "tow: /timeline/1/set/hoist.sped: there is no input \"hoist.sped\"; did you mean "
           "\"hoist.speed\"?");
    expect(R"("hoist.mode": "speed")", R"("hoist.mode": "spede")",
           "tow: /timeline/1/set/hoist.mode: there is no mode \"spede\"; did you mean \"speed\"?");
    expect(R"("release": "hook")", R"("release": "hok")",
           "tow: /timeline/3/release: there is no pelican hook \"hok\" then; did you mean "
           "\"hook\"?");
    expect(R"("body": "barge", "name": "eye")", R"("body": "bargee", "name": "eye")",
           "tow: /timeline/5/attach/body: there is no body \"bargee\"; did you mean \"barge\"?");
    EXPECT_NE(refusal(R"("at": 3)", R"("at": -3)").find("/timeline/3/at"), std::string::npos);
    EXPECT_NE(refusal(R"("at": 3, "release": "hook")", R"("at": 3)").find("needs one of the keys"),
              std::string::npos);
    EXPECT_NE(refusal(R"("end": "last"})", R"("end": "lst"})").find("/timeline/4/detach/end"),
              std::string::npos);
}

}  // namespace
}  // namespace hawser::test
