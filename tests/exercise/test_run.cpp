// SPDX-License-Identifier: Apache-2.0
/// Exercises as they run: permissions of roles, effects of faults, and recordings that reproduce
/// both.
#include "exercise/small_exercise.h"

#include <cmath>
#include <tuple>

namespace hawser::test {
namespace {

using exercise::EntryKind;
using exercise::Refused;

TEST(ExerciseRun, OnlyWhoMaySetsAnInput) {
    const Yard yard;
    Running e(yard.load());
    exercise::Run& run = *e.run;
    for (const char* role : {"instructor", "watcher", "winch", "deck"})
        EXPECT_TRUE(run.is_role(role)) << role;
    EXPECT_FALSE(run.is_role("cook"));
    run.set_input("deck", "push", 100.0);
    run.set_input("instructor", "push", 120.0);
    EXPECT_THROW(run.set_input("winch", "push", 1.0), Refused);
    EXPECT_THROW(run.set_input("watcher", "hoist.speed", 1.0), Refused);
    EXPECT_THROW(run.set_input("cook", "push", 1.0), Refused);
    EXPECT_THROW(run.set_input("instructor", "puhs", 1.0), DefError);
    EXPECT_THROW(run.set_input("instructor", "push", NAN), DefError);
    for (const char* role : {"deck", "watcher", "winch", "cook"}) {
        EXPECT_THROW(run.trigger(role, "worn"), Refused) << role;
        EXPECT_THROW(run.clear(role, "worn"), Refused) << role;
    }
    EXPECT_THROW(run.trigger("instructor", "wron"), DefError);
    try {
        run.set_input("winch", "push", 1.0);
    } catch (const Refused& refused) {
        EXPECT_STREQ(refused.what(), "\"winch\" may not set \"push\"; who may: instructor, deck");
    }
    e.steps(1);
    EXPECT_EQ(e.input("push"), 120.0);
    EXPECT_EQ(run.asked("push"), 120.0);
    EXPECT_TRUE(std::isnan(run.asked("hoist.brake"))) << "nobody has";
    run.set_input("winch", "heave_half", 1.0);
    e.steps(1);
    EXPECT_EQ(e.input("hoist.speed"), -0.5) << "by the factor of the scene's lever";
    EXPECT_EQ(run.asked("heave_half"), 1.0);
}

TEST(ExerciseRun, FaultsComeBetweenLeversAndWorld) {
    const Yard yard;
    Running e(yard.load());
    exercise::Run& run = *e.run;
    e.steps(1);
    EXPECT_EQ(e.input("hoist.mode"), 0.0) << "the timeline of the scene";
    run.trigger("instructor", "blackout");
    e.steps(1);
    EXPECT_EQ(e.input("hoist.mode"), static_cast<double>(WinchMode::free));
    run.set_input("winch", "hoist.mode", static_cast<double>(WinchMode::brake));
    e.steps(1);
    EXPECT_EQ(e.input("hoist.mode"), static_cast<double>(WinchMode::brake)) << "needs no motor";
    run.clear("instructor", "blackout");
    run.set_input("winch", "hoist.mode", static_cast<double>(WinchMode::tension));
    e.steps(1);
    EXPECT_EQ(e.input("hoist.mode"), static_cast<double>(WinchMode::tension));
    run.set_input("winch", "hoist.brake", 0.8);
    run.trigger("instructor", "worn");
    run.trigger("instructor", "weak_drive");
    e.steps(1);
    EXPECT_DOUBLE_EQ(e.input("hoist.brake"), 0.4);
    EXPECT_EQ(e.input("fault.drive.force_max"), 12.5);
    EXPECT_EQ(e.input("fault.drive.force_min"), -12.5);
    run.clear("instructor", "weak_drive");
    e.steps(1);
    EXPECT_EQ(e.input("fault.drive.force_max"), 50.0);
    run.trigger("instructor", "glazed");
    e.steps(10);
    EXPECT_EQ(e.input("fault.band.torque"), 2.0);
    e.steps(12);
    EXPECT_EQ(e.input("fault.band.torque"), 20.0) << "it lasts 0.4 s";
    EXPECT_FALSE(run.active("glazed"));
}

TEST(ExerciseRun, InputsStickAndComeLate) {
    const Yard yard;
    Running e(yard.load());
    exercise::Run& run = *e.run;
    run.set_input("deck", "push", 10.0);
    e.steps(1);
    run.trigger("instructor", "stuck");
    run.set_input("deck", "push", 20.0);
    e.steps(3);
    EXPECT_EQ(e.input("push"), 10.0);
    EXPECT_EQ(run.asked("push"), 20.0);
    run.clear("instructor", "stuck");
    e.steps(1);
    EXPECT_EQ(e.input("push"), 20.0);
    run.trigger("instructor", "late");
    run.set_input("deck", "push", 30.0);
    e.steps(2);
    run.set_input("deck", "push", 40.0);
    e.steps(3);
    EXPECT_EQ(e.input("push"), 20.0) << "0.1 s are five steps";
    e.steps(1);
    EXPECT_EQ(e.input("push"), 30.0);
    e.steps(1);
    EXPECT_EQ(e.input("push"), 30.0);
    e.steps(1);
    EXPECT_EQ(e.input("push"), 40.0);
}

TEST(ExerciseRun, AFrozenDisplayHidesAnAlarmButNotAGoal) {
    const Yard yard;
    Running e(yard.load());
    exercise::Run& run = *e.run;
    run.set_input("winch", "hoist.speed", -1.0);
    e.steps(5);
    run.trigger("instructor", "frozen");
    const double before = run.shown("load_z");
    e.steps(150);
    EXPECT_EQ(run.shown("load_z"), before);
    const World& w = e.session->world();
    EXPECT_GT(w.output(w.find_output("load_z")), 6.0);
    EXPECT_EQ(run.result().alarms[0].times, 0);
    EXPECT_TRUE(run.result().goals[0].reached);
    EXPECT_THROW((void)run.shown("laod_z"), DefError);
}

/// Return results on which a run and its recording must agree.
std::string perform(const Yard& yard, int threads, const std::string& record) {
    Running e(yard.load(kSmallExercise, threads), {.record = record});
    exercise::Run& run = *e.run;
    run.set_input("winch", "hoist.speed", -0.4);
    e.steps(20);
    run.trigger("instructor", "blackout");
    e.steps(5);
    run.clear("instructor", "blackout");
    run.trigger("instructor", "frozen");
    run.trigger("instructor", "weak_drive");
    e.steps(25);
    run.clear("instructor", "frozen");
    run.set_input("deck", "push", 300.0);
    for (int i = 0; i < 400 && !run.ended(); ++i) EXPECT_EQ(run.step(), Status::ok);
    (void)e.session->finish();
    return exercise::to_json(run.result());
}

TEST(ExerciseRun, ARecordingHasTheSameScoreWithAnyNumberOfThreads) {
    const Yard yard;
    const std::string one = perform(yard, 1, yard.file("1.hwr")),
                      two = perform(yard, 2, yard.file("2.hwr"));
    EXPECT_EQ(one, two);
    EXPECT_NE(one.find("\"parted\",\n   \"times\": 1"), std::string::npos) << one;
    const record::Recording recording = record::Recording::open(yard.file("1.hwr"));
    for (const int threads : {1, 2}) {
        const exercise::Rescored again = exercise::rescore(recording, threads);
        EXPECT_TRUE(again.same) << again.difference;
        EXPECT_EQ(exercise::to_json(again.result), one);
        EXPECT_EQ(again.curves.time.size(), again.curves.values[1].size());
        EXPECT_FALSE(std::isnan(again.curves.values[1].back())) << "of a system, from notes";
    }
    // A score by hand: 10 for the goal, less 3 for the tow, less half a point for each second with
    // < 31 m of wire on the drum. The latter holds for the whole exercise.
    const exercise::Rescored r = exercise::rescore(recording);
    ASSERT_TRUE(r.result.goals[0].reached);
    EXPECT_NEAR(r.result.points, 10.0 - 3.0 - 0.5 * r.result.penalties[1].seconds, 1e-9);
    EXPECT_EQ(r.result.entries[0].name, "slow");
    EXPECT_NEAR(r.result.entries[1].time, 0.4, 1e-9);
    EXPECT_EQ(r.result.entries[1].kind, EntryKind::fault);
    EXPECT_EQ(r.result.entries[1].by, "instructor");
}

TEST(ExerciseRun, GoesBackToAMark) {
    const Yard yard;
    Running e(yard.load());
    exercise::Run& run = *e.run;
    run.set_input("winch", "hoist.speed", -0.4);
    e.steps(30);
    const std::vector<std::byte> state = e.session->world().state().save();
    const int mark = run.mark();
    e.steps(60);  // the tow breaks at 1.5 s
    const std::string first = exercise::to_json(run.result());
    EXPECT_EQ(run.result().penalties[0].times, 1);
    run.set_input("winch", "hoist.speed", 0.7);
    e.session->world().state().restore(state);
    run.back_to(mark);
    EXPECT_EQ(run.result().penalties[0].times, 0);
    EXPECT_EQ(run.asked("hoist.speed"), -0.4);
    EXPECT_EQ(run.result().entries.back().kind, EntryKind::restored);
    e.steps(60);
    EXPECT_EQ(run.result().penalties[0].times, 1) << "it parts again";
    EXPECT_NEAR(e.session->world().output(e.session->world().find_output("load_z")),
                run.shown("load_z"), 0.0);
    EXPECT_THROW(run.back_to(5), DefError);
    EXPECT_NE(first.find("\"points\": -3"), std::string::npos);
}

/// Faults, a broken tow and an end come before the exercise goes back. It goes back twice without a
/// step between, and at last without a later step.
TEST(ExerciseRun, ARecordingThatGoesBackHasTheSameScore) {
    const Yard yard;
    const std::string file = yard.file("back.hwr");
    std::string score;
    {
        Running e(yard.load(), {.record = file});
        exercise::Run& run = *e.run;
        const auto keep = [&] {
            const World& world = e.session->world();
            return std::tuple(run.mark(), world.state().structure(), world.state().save());
        };
        const auto back = [&](const auto& point) {
            e.session->restore(std::get<1>(point), std::get<2>(point));
            run.back_to(std::get<0>(point));
        };
        const auto start = keep();
        run.set_input("winch", "hoist.speed", -0.8);
        e.steps(30);
        run.trigger("instructor", "frozen");
        const auto later = keep();
        e.steps(60);  // the tow breaks at 1.5 s
        EXPECT_EQ(run.result().penalties[0].times, 1);
        back(later);
        run.set_input("winch", "hoist.speed", -0.5);
        e.steps(40);
        back(start);
        back(later);
        run.clear("instructor", "frozen");
        e.steps(100);
        EXPECT_EQ(run.result().penalties[0].times, 1);
        run.end("enough", false);
        e.steps(5);
        back(later);
        EXPECT_FALSE(run.ended());
        run.trigger("instructor", "stuck");
        e.steps(20);
        back(later);
        e.session->finish();
        score = exercise::to_json(run.result());
        EXPECT_EQ(run.result().entries.back().kind, EntryKind::restored);
        EXPECT_NEAR(run.result().entries.back().time, 0.6, 1e-9);
    }
    const record::Recording recording = record::Recording::open(file);
    EXPECT_EQ(recording.takes.size(), 5U);
    for (const int threads : {1, 2}) {
        const exercise::Rescored again = exercise::rescore(recording, threads);
        EXPECT_TRUE(again.same) << again.difference;
        EXPECT_EQ(exercise::to_json(again.result), score);
    }
}

}  // namespace
}  // namespace hawser::test
