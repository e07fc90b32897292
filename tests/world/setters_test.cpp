// SPDX-License-Identifier: Apache-2.0
/// Setters reject the values that definitions reject.
#include <gtest/gtest.h>

#include <hawser/hawser.h>

#include <cmath>
#include <functional>
#include <initializer_list>
#include <limits>
#include <string>

namespace hawser::test {
namespace {

const double kNoNumber = std::nan("");

/// Return the message of the DefError of f; "" if it throws nothing.
std::string error_message(const std::function<void()>& f) {
    try {
        f();
    } catch (const DefError& e) {
        return e.what();
    }
    return "";
}

BodyDef setter_block() {
    BodyDef d;
    d.name = "block";
    d.mass = 2.0;
    d.inertia = Vec3(1.0, 1.5, 2.0).asDiagonal();
    return d;
}

/// Values set later have the ranges of definitions: the message names body and field.
TEST(Setters, HaveTheRangesOfDefinitions) {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    World w;
    BodyDef d = setter_block();
    const BodyId body = w.add_body(d);
    d.name = "quay";
    d.kind = BodyKind::fixed;
    const BodyId quay = w.add_body(d);
    InputDef thrust{.name = "thrust", .interaction = {}, .param = "", .body = body};
    thrust.min = -5.0;
    thrust.max = 5.0;
    const InputId input = w.add_input(thrust);
    const Vec3 zero = Vec3::Zero();
    const Quat upright = Quat::Identity();
    ASSERT_EQ(w.step(), Status::ok);
    const std::uint64_t before = w.state().hash();
    const auto expect_refused = [&](std::initializer_list<const char*> words,
                                    const std::function<void()>& f) {
        const std::string message = error_message(f);
        for (const char* word : words)
            EXPECT_NE(message.find(word), std::string::npos) << word << ": " << message;
        EXPECT_EQ(w.state().hash(), before) << message;
    };
    for (const double bad : {kNoNumber, kInfinite, -kInfinite}) {
        expect_refused({"block", "force"}, [&] { w.set_force(body, {0, bad, 0}, zero); });
        expect_refused({"block", "torque"}, [&] { w.set_force(body, zero, {0, 0, bad}); });
        expect_refused({"block", "position"}, [&] { w.set_pose(body, {{bad, 0, 0}, upright}); });
        expect_refused({"block", "velocity"}, [&] { w.set_velocity(body, {{bad, 0, 0}, zero}); });
        expect_refused({"block", "angular_velocity"},
                       [&] { w.set_velocity(body, {zero, {0, bad, 0}}); });
        expect_refused({"thrust", "value"}, [&] { w.set_input(input, bad); });
        expect_refused({"block", "orientation"},
                       [&] { w.set_pose(body, {zero, Quat(bad, 0, 0, 0)}); });
    }
    expect_refused({"position = 100000000", "10000000"},
                   [&] { w.set_pose(body, {{0, 0, 1e8}, upright}); });
    expect_refused({"orientation"}, [&] { w.set_pose(body, {zero, Quat(3, 0, 0, 0)}); });
    expect_refused({"orientation"}, [&] { w.set_pose(body, {zero, Quat(0, 0, 0, 0)}); });
    expect_refused({"velocity = 200000", "100000"},
                   [&] { w.set_velocity(body, {{2e5, 0, 0}, zero}); });
    expect_refused({"angular_velocity"}, [&] { w.set_velocity(body, {zero, {2e5, 0, 0}}); });
    expect_refused({"quay", "velocity"}, [&] { w.set_velocity(quay, {{1, 0, 0}, zero}); });
    expect_refused({"parts", "4096", "5000"}, [&] { w.splits().follow_groups(5000); });
    expect_refused({"regroup_every", "-1"}, [&] { w.splits().follow_groups(2, -1); });
    expect_refused({"parts = 0"}, [&] { w.splits().set_groups(0); });
    expect_refused({"spans"}, [&] { w.solver().start_trace(std::size_t{1} << 40); });
    expect_refused({"no body"}, [&] { w.splits().set_group(BodyId{9}, "x"); });
    expect_refused({"no interaction"},
                   [&] { w.splits().set_coupling(InteractionId{0}, Coupling::compliant); });
    // Clamped, with an event.
    w.set_input(input, 7.0);
    EXPECT_EQ(w.input(input), 5.0);
    // Only a number of iterations above 0 limits a step.
    w.solver().degrade_next_step({.iterations = -3, .hasty = true, .cuts = 0});
    EXPECT_EQ(w.step(), Status::ok);
    EXPECT_FALSE(w.stats().cut);
}

}  // namespace
}  // namespace hawser::test
