// SPDX-License-Identifier: Apache-2.0
// Verification of elements whose ends move apart while slack: their damper pulls in step after step
// before they are taut, which violates no law.
#include "verify/certificate.h"

#include <hawser/hawser.h>

#include <gtest/gtest.h>

namespace hawser {
namespace {

/// Two point masses of 2 kg, 185 mm apart, on an element of 293 mm, move apart at 1.46 m/s.
struct Apart {
    World w{WorldDef{.gravity = Vec3::Zero()}};
    InteractionId line{};
    Apart() {
        BodyId lump[2];
        for (int k = 0; k < 2; ++k)
            lump[k] = w.add_body({.kind = BodyKind::lump,
                                  .position = {0.185 * k, 0, 0},
                                  .velocity = {1.46 * (k - 0.5), 0, 0},
                                  .mass = 2.0});
        InteractionDef d{.kind = InteractionKind::Stretch};
        d.body[0] = lump[0];
        d.body[1] = lump[1];
        d.set("length", 0.293).set("EA", 1.74e8);
        line = w.add_interaction(d);
    }
    [[nodiscard]] double length() const {
        const InteractionDef& d = w.interaction_def(line);
        return (w.pose(d.body[1]).position - w.pose(d.body[0]).position).norm();
    }
};

TEST(SlackElements, ThatComeApartAreNotOffTheirLaw) {
    Apart a;
    verify::Verifier verifier(a.w);
    int pulled = 0;
    for (int i = 0; i < 30; ++i) {
        verifier.before_step(a.w);
        const bool slack = a.length() < 0.8 * 0.293;
        ASSERT_EQ(a.w.step(), Status::ok);
        ASSERT_EQ(verifier.after_step(a.w), "") << "step " << i;
        pulled += slack && a.w.force(a.line)[0] < 0.0 ? 1 : 0;
    }
    // Long enough to be taken for an element that rings: three steps in sequence.
    EXPECT_GE(pulled, 3);
}

}  // namespace
}  // namespace hawser
