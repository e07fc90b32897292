// SPDX-License-Identifier: Apache-2.0
// Separate code detects ranges that are violated and bodies that overlap.
#include <hawser/hawser.h>

#include "verify/certificate_state.h"
#include "verify/lasting_faults.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace hawser {
namespace {

std::string first_objection(World& w, int steps) {
    verify::StateVerifier verifier(w);
    for (int i = 0; i < steps; ++i) {
        verifier.before_step(w);
        EXPECT_EQ(w.step(), Status::ok) << i;
        if (std::string wrong = verifier.after_step(w); !wrong.empty()) return wrong;
    }
    return {};
}

/// Make a box on a lock, pushed by the end of a range: 0.5 rad over 1e-10 rad/(N m), 5 GN m.
World locked_box() {
    World w({.step = 1.0 / 60.0, .on_diverged = OnDiverged::warn});
    const BodyId ground = w.add_body({.kind = BodyKind::fixed});
    const BodyId box = w.add_body(
        {.mass = 1000, .inertia = Mat3::Identity() * 167.0, .half_size = {0.5, 0.5, 0.5}});
    w.add_interaction({.kind = InteractionKind::Lock, .body = {ground, box}});
    InteractionDef range{
        .name = "stop", .kind = InteractionKind::HingeRange, .body = {ground, box}};
    range.set("min", 0.5);
    range.set("max", 0.6);
    w.add_interaction(range);
    return w;
}

TEST(LastingFaultsVerified, ARangeThatNeverHolds) {
    World w = locked_box();
    verify::LastingFaults faults;
    std::string wrong;
    int steps = 0;
    for (; steps < 60 && wrong.empty(); ++steps) {
        ASSERT_EQ(w.step(), Status::ok) << steps;
        std::vector<Pose> pose;
        for (const BodyId id : w.bodies()) pose.push_back(w.pose(id));
        wrong = faults.after_step(w, pose);
    }
    EXPECT_EQ(steps, 7) << "what strikes an end may be beyond it for 6 steps";
    EXPECT_NE(wrong.find("'stop' has been beyond its range for 7 steps, now by 0.49"),
              std::string::npos)
        << wrong;
}

/// The same push rotates the lock of 1e-12 rad/(N m) by 5 mrad: 25 MJ of work without motion.
TEST(LastingFaultsVerified, TheWorkOfARangeAgainstALockIsMissedBefore) {
    World w = locked_box();
    const std::string wrong = first_objection(w, 6);
    EXPECT_NE(wrong.find("MJ of mechanical energy that no force took"), std::string::npos) << wrong;
}

TEST(LastingFaultsVerified, ABodyThatIsPressedThroughAnother) {
    World w({.step = 1.0 / 60.0, .on_diverged = OnDiverged::warn});
    const BodyId plate = w.add_body({.name = "plate", .kind = BodyKind::fixed});
    w.add_shape({.kind = ShapeKind::box, .body = plate, .half_size = {5, 5, 0.05}});
    const BodyId ball = w.add_body({.name = "ball",
                                    .position = {0, 0, 1.1},
                                    .mass = 3e7,
                                    .inertia = Mat3::Identity() * 1.2e7});
    w.add_shape({.kind = ShapeKind::sphere, .body = ball, .radius = 1.0});
    const std::string wrong = first_objection(w, 120);
    EXPECT_NE(wrong.find("'plate' and 'ball' have lain in each other"), std::string::npos) << wrong;
}

}  // namespace
}  // namespace hawser
