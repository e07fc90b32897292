// SPDX-License-Identifier: Apache-2.0
/// Shipped exercises: their control files pass, worse runs score worse, and the schema is that of
/// the source.
#include <hawser/exercise.h>
#include <hawser/hawser.h>

#include "record/control.h"

#include "support/sanitizer.h"

#include <gtest/gtest.h>

#include <cstdlib>
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
