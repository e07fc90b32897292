// SPDX-License-Identifier: Apache-2.0
/// The verifier computes the bounds of anchors separately, and detects a wrong one.
#include "verify/anchor_soil.h"
#include "verify/certificate.h"

#include <hawser/anchor.h>
#include <hawser/hawser.h>

#include <gtest/gtest.h>

#include <string>

namespace hawser::verify {
namespace {

/// Make an anchor that a buoy drags through clay by a line, obliquely.
World dragged_anchor(AnchorLaw law) {
    World w(WorldDef{.step = 1.0 / 60.0});
    const BodyId hook =
        w.add_body({.name = "hook", .mass = 1e4, .inertia = 4e4 * Mat3::Identity()});
    const Vec3 along = Vec3(3.0, 4.0, 0.4).normalized();
    const BodyId buoy = w.add_body({.name = "buoy",
                                    .kind = BodyKind::lump,
                                    .position = 100.0 * along,
                                    .mass = 1e4,
                                    .force = 8e5 * along,
                                    .linear_damping = Vec3::Constant(4e5),
                                    .gravity = false});
    AnchorDef def{.name = "anchor", .body = hook, .soil = AnchorSoil::soft_clay, .uhc = 3e6};
    def.wire = w.wires().add({.name = "line",
                              .from = hook,
                              .to = buoy,
                              .elements = 2,
                              .length = 99.9,
                              .EA = 1e9,
                              .mass_per_length = 30.0});
    def.law = law;
    def.drag_length = 30.0;
    def.full_depth = 10.0;
    def.set = true;
    def.clay = {.strength = 1.5e3,
                .gradient = 1.75e3,
                .fluke_area = 6.0,
                .chain_width = 0.073,
                .chain_friction = 0.3};
    w.add(def);
    return w;
}

TEST(VerifyAnchor, DraggingAgreesWithItsText) {
    for (const AnchorLaw law : {AnchorLaw::exponential, AnchorLaw::trajectory}) {
        World w = dragged_anchor(law);
        w.prepare();
        Verifier verifier(w);
        for (int i = 0; i < 900; ++i) {
            verifier.before_step(w);
            ASSERT_EQ(w.step(), Status::ok);
            ASSERT_EQ(verifier.after_step(w), "") << w.time();
        }
        EXPECT_GT(w.system_signal("anchor.drag"), 1.0);
    }
}

TEST(VerifyAnchor, ABoundThatIsOffIsNamed) {
    World w = dragged_anchor(AnchorLaw::exponential);
    for (int i = 0; i < 10; ++i) ASSERT_EQ(w.step(), Status::ok);
    EXPECT_EQ(anchor_fault(w), "");
    const InputId bound = w.find_input("anchor/x/force");
    w.set_input(bound, 1.01 * w.interaction_def(w.find_interaction("anchor/x")).get("force"));
    EXPECT_NE(anchor_fault(w).find("the soil's row x"), std::string::npos);
}

}  // namespace
}  // namespace hawser::verify
