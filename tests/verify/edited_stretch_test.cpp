// SPDX-License-Identifier: Apache-2.0
/// Compare the account of stretch that edits add with ½ EA ε² l of a straight wire.
#include "verify/edited_stretch.h"

#include <hawser/hawser.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace hawser::test {
namespace {

constexpr double kWireEA = 2e6, kPostSeparation = 10.0;  // [N], [m]

/// A straight wire between two posts, without gravity, longer than its rest length by a strain.
struct StraightWire {
    World w;
    BodyId first, last;
    WireId wire;
    StraightWire() : w({.step = 0.01, .gravity = Vec3::Zero()}) {
        first = w.add_body({.name = "first", .kind = BodyKind::fixed});
        last = w.add_body(
            {.name = "last", .kind = BodyKind::fixed, .position = {kPostSeparation, 0.0, 0.0}});
        add(0.01);
    }
    void add(double strain) {
        wire = w.wires().add({.name = "wire",
                              .from = first,
                              .to = last,
                              .elements = 8,
                              .length = kPostSeparation / (1.0 + strain),
                              .EA = kWireEA,
                              .mass_per_length = 3.0,
                              .consistent_mass = true});
    }
    [[nodiscard]] std::vector<Pose> poses() const {
        std::vector<Pose> out(static_cast<std::size_t>(w.body_count()));
        for (const BodyId id : w.bodies()) out[static_cast<std::size_t>(id.index)] = w.pose(id);
        return out;
    }
};

double held_by_strain(double strain) {
    return 0.5 * kWireEA * strain * strain * kPostSeparation / (1.0 + strain);
}

// A wire of another rest length in its place: its stretch comes from nowhere.
TEST(EditedStretch, OfAShorterWireIsFound) {
    for (const double strain : {0.0, 0.005, 0.02, 0.03}) {
        StraightWire s;
        ASSERT_EQ(s.w.step(), Status::ok);
        verify::EditedStretch account;
        account.before_step(s.w);
        (void)s.w.wires().remove(s.wire);
        s.add(strain);
        // Rounding of positions in the strain, 1e-16 / 1e-2, of an energy of some kJ.
        EXPECT_NEAR(account.elastic_change(s.w, s.poses()),
                    held_by_strain(strain) - held_by_strain(0.01), 1e-9 * held_by_strain(0.01));
    }
}

// A node that comes or goes keeps tension and rest length of a straight wire.
TEST(EditedStretch, OfANodeIsNothing) {
    StraightWire s;
    ASSERT_EQ(s.w.step(), Status::ok);
    verify::EditedStretch account;
    account.before_step(s.w);
    const BodyId node = s.w.wires().insert_node(s.w.wires().elements(s.wire)[3], 0.3);
    ASSERT_TRUE(node.valid());
    EXPECT_NEAR(account.elastic_change(s.w, s.poses()), 0.0, 1e-9 * held_by_strain(0.01));
    account.before_step(s.w);
    ASSERT_TRUE(s.w.wires().remove_node(node));
    EXPECT_NEAR(account.elastic_change(s.w, s.poses()), 0.0, 1e-9 * held_by_strain(0.01));
}

// Elements are measured where they were before the step: motion is no edit.
TEST(EditedStretch, LeavesOutTheMotionOfTheStep) {
    StraightWire s;
    for (const BodyId id : s.w.wires().nodes(s.wire))
        if (s.w.body_def(id).kind == BodyKind::lump)
            s.w.set_velocity(id, {{0.0, 3.0 * std::sin(s.w.pose(id).position.x()), 0.0}, {}});
    for (int i = 0; i < 5; ++i) {
        const std::vector<Pose> before = s.poses();
        verify::EditedStretch account;
        account.before_step(s.w);
        ASSERT_EQ(s.w.step(), Status::ok);
        // Positions are advanced by h v in one rounding each.
        EXPECT_NEAR(account.elastic_change(s.w, before), 0.0, 1e-9 * held_by_strain(0.01)) << i;
    }
}

}  // namespace
}  // namespace hawser::test
