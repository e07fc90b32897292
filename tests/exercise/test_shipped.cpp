// SPDX-License-Identifier: Apache-2.0
/// Shipped exercises: their control files pass, worse runs score worse, and the schema is that of
/// the source.
#include <hawser/exercise.h>
#include <hawser/hawser.h>
#include <hawser/recording.h>

#include "record/control.h"

#include "support/sanitizer.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace hawser::test {
namespace {

/// Perform an exercise. @param until  Time after which the lines of the control file are left out
/// [s]. @param duration  Duration of the exercise [s].
exercise::Result perform(const std::string& name, double until, double duration = 0.0) {
    exercise::Loaded loaded = exercise::load_file("exercises/" + name + ".json");
    if (duration > 0.0) loaded.exercise.duration = duration;
    std::vector<std::string> inputs, roles;
    for (const exercise::Station& station : loaded.exercise.stations)
        for (const std::string& input : station.inputs) {
            inputs.push_back(input);
            roles.push_back(station.name);
        }
    const auto changes = record::read_control("exercises/" + name + ".control.csv", inputs);
    Session session(std::move(loaded.scene));
    exercise::Run run(loaded.exercise, session);
    std::size_t next = 0;
    while (!run.ended()) {
        for (; next < changes.size() && changes[next].time <= session.time() + 1e-6 &&
               changes[next].time <= until;
             ++next) {
            const auto k = static_cast<std::size_t>(changes[next].input);
            run.set_input(roles[k], inputs[k], changes[next].value);
        }
        const Status status = run.step();
        EXPECT_EQ(status, Status::ok) << session.objection();
        if (status != Status::ok) break;
    }
    return run.result();
}

void expect_passed(const exercise::Result& r) {
    EXPECT_EQ(r.outcome, exercise::Outcome::passed) << exercise::to_json(r);
    EXPECT_EQ(r.points, 100.0) << exercise::to_json(r);
    EXPECT_EQ(r.possible, 100.0);
}

TEST(Exercises, TowOut) {
    expect_passed(perform("tow_out", 1e9));
    // The brake stays on while it fades: wire runs out.
    const exercise::Result bad = perform("tow_out", 100.0, 140.0);
    EXPECT_EQ(bad.outcome, exercise::Outcome::failed);
    EXPECT_LT(bad.points, 70.0);
    EXPECT_GT(bad.penalties[1].times, 0) << "the brake slips";
}

TEST(Exercises, CraneLift) {
    HAWSER_SKIP_IF_SAMPLED();
    expect_passed(perform("crane_lift", 1e9));
    // The hoist is not stopped.
    const exercise::Result bad = perform("crane_lift", 8.0, 60.0);
    EXPECT_EQ(bad.outcome, exercise::Outcome::failed);
    EXPECT_LT(bad.points, 40.0);
}

TEST(Exercises, AnchorOverRoller) {
    HAWSER_SKIP_IF_SAMPLED();
    expect_passed(perform("anchor_over_roller", 1e9));
    // The winch is not stopped: the anchor hits the seabed at 0.9 m/s.
    const exercise::Result bad = perform("anchor_over_roller", 10.0, 80.0);
    EXPECT_EQ(bad.outcome, exercise::Outcome::failed);
    EXPECT_EQ(bad.penalties[0].times, 1) << "hard landing";
    EXPECT_LT(bad.points, 40.0);
}

TEST(Exercises, TowToSeaBeginsUnderAutopilot) {
    HAWSER_SKIP_IF_SAMPLED();
    const exercise::Result begun = perform("tow_to_sea", 1e9, 95.0);
    ASSERT_FALSE(begun.goals.empty());
    EXPECT_EQ(begun.points, 20.0) << exercise::to_json(begun);
    // Nobody switches the autopilot on: the tow drifts.
    const exercise::Result bad = perform("tow_to_sea", -1.0, 95.0);
    EXPECT_EQ(bad.outcome, exercise::Outcome::failed);
    EXPECT_LE(bad.points, 0.0);
}

TEST(Exercises, TowToSea_full) {
    expect_passed(perform("tow_to_sea", 1e9));
    // The brake is not set: the wire runs out, and the tow never turns.
    const exercise::Result bad = perform("tow_to_sea", 300.0);
    EXPECT_EQ(bad.outcome, exercise::Outcome::failed);
    EXPECT_LT(bad.points, 70.0);
}

/// A run of a worse plan: the exercise fails, and the named penalty counts.
void expect_failed(const std::string& name, double until, double duration, double most) {
    const exercise::Result bad = perform(name, until, duration);
    EXPECT_EQ(bad.outcome, exercise::Outcome::failed) << exercise::to_json(bad);
    EXPECT_LE(bad.points, most) << exercise::to_json(bad);
}

/// The first goal of a control file, and the same time without it.
void expect_begun(const std::string& name, double duration, double points) {
    const exercise::Result begun = perform(name, 1e9, duration);
    EXPECT_EQ(begun.points, points) << exercise::to_json(begun);
    expect_failed(name, -1.0, duration, 0.0);
}

TEST(Exercises, SubseaLiftGoesThroughTheSplashZone) { expect_begun("subsea_lift", 45.0, 20.0); }

TEST(Exercises, TowGobBeginsWithTheGobWire) { expect_begun("tow_gob", 105.0, 25.0); }

TEST(Exercises, SubseaLift_full) {
    expect_passed(perform("subsea_lift", 1e9));
    // Lowering in heave compensation is not stopped: the hold above the seabed is missed.
    expect_failed("subsea_lift", 165.0, 260.0, 20.0);
}

TEST(Exercises, Berthing_full) {
    expect_passed(perform("berthing", 1e9));
    // Tugs that do not check the barge: she lands too fast.
    expect_failed("berthing", -1.0, 300.0, 0.0);
}

TEST(Exercises, TowGob_full) {
    expect_passed(perform("tow_gob", 1e9));
    // The gob wire stays slack: the first goal is missed.
    expect_failed("tow_gob", 0.0, 300.0, 0.0);
}

TEST(Exercises, EmergencyRelease_full) {
    expect_passed(perform("emergency_release", 1e9));
    // The autopilot runs away and nobody releases the tow.
    expect_failed("emergency_release", 0.0, 400.0, 25.0);
}

/// Perform the first seconds of an exercise with a recording: a station sets its first input, and
/// the instructor triggers the first fault and ends the exercise. Return the live score.
std::string first_seconds(const std::filesystem::path& file, const std::string& recording) {
    exercise::Loaded loaded = exercise::load_file(file);
    Session session(std::move(loaded.scene), {.record = recording, .every = 20});
    exercise::Run run(loaded.exercise, session);
    const auto until = [&](double time) {
        while (session.time() < time && !run.ended()) ASSERT_EQ(run.step(), Status::ok);
    };
    until(0.5);
    const exercise::Station& station = loaded.exercise.stations.front();
    run.set_input(station.name, station.inputs.front(), 0.0);
    if (!loaded.exercise.faults.empty())
        run.trigger("instructor", loaded.exercise.faults.front().name);
    until(3.0);
    run.end("ended by the instructor", false);
    (void)session.finish();
    return exercise::to_json(run.result());
}

/// The debriefing of a recording has the score of the live run, with the actions of the instructor.
TEST(Exercises, RecordingsOfAllHaveTheLiveScore_full) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "hawser_scores";
    std::filesystem::create_directories(folder);
    int seen = 0;
    for (const auto& entry : std::filesystem::directory_iterator("exercises")) {
        if (!exercise::is_exercise(entry.path())) continue;
        SCOPED_TRACE(entry.path().string());
        ++seen;
        const std::string recording = (folder / entry.path().stem()).string() + ".hwr";
        const std::string live = first_seconds(entry.path(), recording);
        const exercise::Rescored again = exercise::rescore(record::Recording::open(recording));
        EXPECT_TRUE(again.same) << again.difference;
        EXPECT_EQ(exercise::to_json(again.result), live);
    }
    EXPECT_GE(seen, 10);
    std::filesystem::remove_all(folder);
}

TEST(Exercises, SchemaIsThatOfTheSource) {
    const char* const file = "schema/exercise-1.json";
    if (std::getenv("HAWSER_WRITE_GENERATED") != nullptr)
        std::ofstream(file) << exercise::schema_text();
    std::ifstream stream(file);
    std::stringstream stored;
    stored << stream.rdbuf();
    EXPECT_TRUE(stored.str() == exercise::schema_text())
        << file << " is not what the source generates; run scripts/write_scene_documents.sh";
}

}  // namespace
}  // namespace hawser::test
