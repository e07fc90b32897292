// SPDX-License-Identifier: Apache-2.0
#include "good_scenes.h"
#include "support.h"

#include <cmath>

namespace hawser::scene::test {
namespace {

TEST(Bodies, inertia_of_solids) {
    const Description d = flat(kSite);
    // Box of half sizes 35, 35, 10: m (b² + c²)/3.
    EXPECT_NEAR(body(d, "rig").inertia(0, 0), 2e7 * (35.0 * 35 + 100) / 3, 1.0);
    EXPECT_NEAR(body(d, "rig").inertia(2, 2), 2e7 * 2 * 35.0 * 35 / 3, 1.0);
    EXPECT_NEAR(body(d, "roller").inertia(0, 0), 900 * 1.5 * 1.5 / 2, 1e-9);
    EXPECT_NEAR(body(d, "roller").inertia(1, 1), 900 * (3 * 1.5 * 1.5 + 36) / 12, 1e-9);
    EXPECT_NEAR(body(d, "buoy").inertia(1, 1), 0.4 * 2000 * 1.5 * 1.5, 1e-9);
    EXPECT_EQ(body(d, "ship").inertia(1, 2), 1e6);
    EXPECT_EQ(body(d, "rig").linear_damping, Vec3::Constant(2e5));
    EXPECT_FALSE(body(d, "drum").gravity);
    EXPECT_EQ(body(d, "drum").position.x(), 0.5);
}

TEST(Bodies, euler_angles_turn_about_x_then_y_then_z) {
    const Description d = flat(
        patched(kSite, R"([{"op":"replace","path":"/bodies/1/euler_deg","value":[90,0,90]}])"));
    // Roll 90° rotates y to z, which yaw 90° does not change; x rotates to y.
    const Quat& q = body(d, "ship").orientation;
    EXPECT_TRUE((q * Vec3::UnitY()).isApprox(Vec3::UnitZ(), 1e-12));
    EXPECT_TRUE((q * Vec3::UnitX()).isApprox(Vec3::UnitY(), 1e-12));
}

TEST(Interactions, world_points_and_axes_become_local) {
    const Description d = flat(kSite);
    const InteractionDef& hinge = interaction(d, "bearing");
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_TRUE(
            d.world_point(hinge.body[i], hinge.point[i]).isApprox(Vec3(300, -40, 0), 1e-12));
        const Quat world = d.body(hinge.body[i]).orientation * hinge.frame[i];
        EXPECT_TRUE((world * Vec3::UnitZ()).isApprox(Vec3::UnitX(), 1e-12));
    }
    // Both frames coincide in the world: the angle starts at zero.
    const Quat a = d.body(hinge.body[0]).orientation * hinge.frame[0];
    const Quat b = d.body(hinge.body[1]).orientation * hinge.frame[1];
    EXPECT_LT(a.angularDistance(b), 1e-7);  // acos near 1 halves the digits
    EXPECT_EQ(hinge.compliance[4], 1e-10);
    EXPECT_EQ(hinge.damping_time[4], 0.03);
    EXPECT_EQ(interaction(d, "brake").get("target"), 0.5);
    EXPECT_EQ(interaction(d, "brake").compliance[0], 1e-11);  // from "defaults"
    EXPECT_TRUE(std::isnan(interaction(d, "water").compliance[0]));
    EXPECT_NEAR(interaction(d, "fall").get("length"), 20.0, 1e-12);
}

TEST(Interactions, every_kind_is_read) {
    const Description d = flat(kKinds);
    for (const KindInfo& kind : interaction_kinds()) {
        const InteractionDef& def = interaction(d, kind.name);
        EXPECT_EQ(def.kind, kind.kind);
    }
    EXPECT_EQ(d.interactions.size(), interaction_kinds().size());
    EXPECT_NEAR(interaction(d, "distance").get("length"), 2.0, 1e-15);
    EXPECT_NEAR(interaction(d, "winch_stretch").get("length"), 2.0, 1e-15);
    EXPECT_EQ(interaction(d, "lock").compliance[3], 1e-9);
    const FrictionLoad& load = interaction(d, "hinge_friction").load[0];
    EXPECT_EQ(d.interactions[static_cast<std::size_t>(load.interaction.index)].name, "hinge");
    EXPECT_EQ(load.factor, 0.1);
    const InteractionDef& u = interaction(d, "universal");
    EXPECT_TRUE((u.frame[0] * Vec3::UnitZ()).isApprox(Vec3::UnitY(), 1e-12));
    EXPECT_TRUE((u.frame[1] * Vec3::UnitZ()).isApprox(Vec3::UnitZ(), 1e-12));
}

TEST(Inputs, refer_to_interactions_and_bodies) {
    const Scene scene = load_text(kSite, "site.json");
    const InputId speed = scene.world.find_input("roller.speed");
    ASSERT_TRUE(speed.valid());
    EXPECT_EQ(scene.world.input_def(speed).param, "speed");
    EXPECT_EQ(scene.world.input_def(speed).interaction, scene.world.find_interaction("turn"));
    const InputDef& thrust = scene.world.input_def(scene.world.find_input("thrust"));
    EXPECT_EQ(thrust.component, 1);
    EXPECT_EQ(thrust.max, 5e5);
    EXPECT_TRUE(scene.world.find_input("port/gust").valid());
    EXPECT_TRUE(scene.world.find_input("1:port/gust").valid());
}

}  // namespace
}  // namespace hawser::scene::test
