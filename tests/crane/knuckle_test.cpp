// SPDX-License-Identifier: Apache-2.0
/// Knuckle-boom cranes against closed forms of their triangle, their falls and their limits.
#include "support/cranes_yard.h"

namespace hawser {
namespace {

using test::kG;
using test::knuckle_crane;
using test::KnuckleYard;

constexpr double kTwenty = 20e3;

/// Compute the line length of the crane of knuckle_crane() from its geometry [m].
double line_length(const KnuckleCraneDef& d) {
    const double r = d.hoist.sheave_radius, x = d.boom.length - d.hoist.drum.x();
    const double z = d.hoist.drum.z(), first = std::sqrt(x * x + z * z - r * r);
    // The line arrives at the knuckle's sheave at this angle and leaves along the jib.
    const double comes = -(std::atan2(z, x) - std::asin(r / std::hypot(x, z)));
    const double knuckle = comes - d.jib_angle;
    const double tip = 0.5 * std::numbers::pi + d.boom_angle + d.jib_angle;
    return first + d.jib.length + 2.0 * d.hook.hang + r * (knuckle + tip + 2.0);
}

TEST(KnuckleCrane, FallsStretchAsTheLineOfBothDoes) {
    // Elastic booms change the length of line over their sheaves.
    KnuckleYard y(knuckle_crane, kTwenty, [](KnuckleCraneDef& d) {
        d.boom_cylinder.stiffness = d.jib_cylinder.stiffness = 1e13;
    });
    y.run(20.0);
    const KnuckleCraneDef d = knuckle_crane(y.quay);
    const double n = d.hoist.falls, k = n * n * d.hoist.EA / line_length(d);
    const double hang = y.mean(20.0, [&] { return y.signal("hang"); });
    const double stretch = kTwenty * kG / k;  // of the load: the line starts stretched by its hook
    EXPECT_NEAR((hang - d.hook.hang) / stretch, 1.0, 0.01);
    // Both falls carry the same tension, in sum the hanging weight.
    for (const InteractionId fall : y.ids.falls) {
        const double t = y.mean(10.0, [&] { return -y.w.force(fall)[0]; });
        EXPECT_NEAR(t / (0.5 * (kTwenty + d.hook.mass) * kG), 1.0, 1e-3);
    }
}

TEST(KnuckleCrane, LoadBouncesAtTheFrequencyOfItsFalls) {
    KnuckleYard y(knuckle_crane, kTwenty, [](KnuckleCraneDef& d) {
        d.boom_cylinder.stiffness = d.jib_cylinder.stiffness =
            1e13;  // leaves only the falls elastic
        d.hoist.damping_time = 0.0;
    });
    const KnuckleCraneDef d = knuckle_crane(y.quay);
    const double n = d.hoist.falls, k = n * n * d.hoist.EA / line_length(d);
    const double m = kTwenty + d.hook.mass;
    const double rest = d.hook.hang + kTwenty * kG / k;
    double first = 0.0, last = 0.0, before = 0.0;
    int periods = -1;
    for (int i = 0; i < 1200; ++i) {
        ASSERT_EQ(y.w.step(), Status::ok);
        const double now = y.signal("hang") - rest, t = i * test::kYardStep;
        if (before < 0.0 && now >= 0.0) {
            last = t - test::kYardStep * now / (now - before);
            if (periods++ < 0) first = last;
        }
        before = now;
    }
    ASSERT_GT(periods, 20);
    const double expected = std::sqrt(k / m) / (2.0 * std::numbers::pi);
    // Second order in the step, 1/24 (ω h)²: 4e-3 here.
    EXPECT_NEAR(periods / (last - first) / expected, 1.0, 0.01);
}

/// Compute the force of a cylinder against a moment, from the triangle of its pins.
double push_of(const CraneCylinder& c, const Vec3& pin, double angle, double moment) {
    const Vec3 head(c.head.x() * std::cos(angle) - c.head.z() * std::sin(angle), 0,
                    c.head.x() * std::sin(angle) + c.head.z() * std::cos(angle));
    const Vec3 way = pin + head - c.foot;
    const double lever = (way.z() * head.x() - way.x() * head.z()) / way.norm();
    return moment / lever;
}

TEST(KnuckleCrane, CylindersCarryTheMomentOfAllThatHangs) {
    KnuckleYard y(knuckle_crane, kTwenty);
    y.run(20.0);
    const KnuckleCraneDef d = knuckle_crane(y.quay);
    const double boom = y.w.coordinate(y.part("luff"));
    const double jib = y.w.coordinate(y.part("knuckle")), all = boom + jib;
    const double hangs = kTwenty + d.hook.mass;
    const double on_jib = kG * std::cos(all) * (5.5 * d.jib.mass + 11.0 * hangs);
    const double on_boom = kG * (7.5 * std::cos(boom) * d.boom.mass +
                                 (15.0 * std::cos(boom) + 5.5 * std::cos(all)) * d.jib.mass +
                                 (15.0 * std::cos(boom) + 11.0 * std::cos(all)) * hangs);
    const double boom_push = y.mean(20.0, [&] { return y.w.motor_force(y.part("luff/motor")); });
    const double jib_push = y.mean(20.0, [&] { return y.w.motor_force(y.part("knuckle/motor")); });
    EXPECT_NEAR(boom_push / push_of(d.boom_cylinder, d.boom_foot, boom, on_boom), 1.0, 2e-3);
    // The line along the jib, one sheave radius above the pin, adds the moment T r: 1.7 % here.
    const double helps = 0.5 * hangs * kG * d.hoist.sheave_radius;
    const Vec3 pin{d.boom.length, 0, 0};
    EXPECT_NEAR(jib_push / push_of(d.jib_cylinder, pin, jib, on_jib - helps), 1.0, 5e-3);
}

TEST(KnuckleCrane, CylinderStallsAtItsForceAndGivesWayBeyond) {
    // The boom needs 2.09 MN for 20 t.
    KnuckleYard y(knuckle_crane, kTwenty, [](KnuckleCraneDef& d) { d.boom_cylinder.push = 1.9e6; });
    const double start = y.w.coordinate(y.part("luff"));
    y.order("luff", 0.1);
    double most = 0.0;
    for (int i = 0; i < 120; ++i) {
        ASSERT_EQ(y.w.step(), Status::ok);
        most = std::max(most, y.w.motor_force(y.part("luff/motor")));
    }
    EXPECT_NEAR(most, 1.9e6, 1e-3);
    EXPECT_LT(y.w.coordinate(y.part("luff")), start - 0.005);
    EXPECT_GT(y.count(EventKind::saturation), 0);

    KnuckleYard strong(knuckle_crane, kTwenty);
    strong.order("luff", 0.1);
    strong.run(6.0);
    EXPECT_GT(strong.w.coordinate(strong.part("luff")), start + 0.1);
    // The motion ends when the rod is fully extended.
    strong.run(30.0);
    const double rod = strong.w.pose(strong.w.find_body("crane/luff/stroke")).position.x();
    const double length = strong.w.interaction_def(strong.part("luff/cylinder")).get("length");
    EXPECT_NEAR(length + rod, 8.9, 0.01);
}

TEST(KnuckleCrane, AlarmsComeAtTheirShareOfTheRatedLoad) {
    // The rated load at 17.2 m is 23.4 t.
    for (const auto& [mass, step] : {std::pair(20e3, 0), std::pair(22e3, 1), std::pair(25e3, 2)}) {
        KnuckleYard y(knuckle_crane, mass);
        y.run(20.0);
        const double radius = y.signal("radius");
        EXPECT_NEAR(y.signal("rated"), 25e3 - 500.0 * (radius - 14.0), 1e-6);
        EXPECT_NEAR(y.signal("load") / mass, 1.0, 1e-3);
        EXPECT_NEAR(y.signal("utilisation"), mass / y.signal("rated"), 2e-3);
        EXPECT_NEAR(y.signal("moment") / (mass * kG * radius), 1.0, 2e-3);
        EXPECT_EQ(y.signal("alarm"), step) << mass;
        EXPECT_EQ(y.count(EventKind::alarm) > 0, step > 0);
        y.order("take", 0.0);
        y.run(5.0);
        EXPECT_EQ(y.signal("alarm"), 0.0);
        EXPECT_EQ(y.count(EventKind::alarm_end) > 0, step > 0);
    }
}

TEST(KnuckleCrane, OverloadCutsOutWhatRaisesTheMoment) {
    KnuckleYard y(knuckle_crane, 25e3, [](KnuckleCraneDef& d) {
        d.rating.cut_out = true;
        d.ramp = 0.5;
    });
    y.run(10.0);
    ASSERT_EQ(y.signal("alarm"), 2.0);
    const double stroke = y.w.pose(y.w.find_body("crane/luff/stroke")).position.x();
    const double drum = y.w.pose(y.w.find_body("crane/hoist/drum")).position.x();
    y.order("hoist", 0.3);
    y.order("luff", -0.05);
    y.run(3.0);
    EXPECT_EQ(y.signal("cut"), 1.0);
    EXPECT_NEAR(y.w.pose(y.w.find_body("crane/hoist/drum")).position.x(), drum, 1e-6);
    EXPECT_NEAR(y.w.pose(y.w.find_body("crane/luff/stroke")).position.x(), stroke, 1e-4);
    y.order("hoist", -0.3);
    y.order("luff", 0.05);
    y.run(3.0);
    EXPECT_EQ(y.signal("cut"), 0.0);
    EXPECT_GT(y.w.pose(y.w.find_body("crane/hoist/drum")).position.x(), drum + 1.0);
    EXPECT_GT(y.w.pose(y.w.find_body("crane/luff/stroke")).position.x(), stroke + 0.05);
}

TEST(KnuckleCrane, SlewBrakeHoldsUpToItsTorque) {
    KnuckleYard y(knuckle_crane, kTwenty);
    y.order("take", 0.0);
    y.run(2.0);
    const BodyId jib = y.ids.jib;
    const Vec3 at = y.w.pose(jib).position;
    const double force = 6e5 / at.x();  // at its bound
    y.w.set_force(jib, {0, 0.99 * force, 0}, Vec3::Zero());
    y.run(5.0);
    const double held = y.w.coordinate(y.part("slew"));
    y.run(10.0);
    EXPECT_NEAR(y.w.coordinate(y.part("slew")), held, 1e-6);
    y.w.set_force(jib, {0, 1.02 * force, 0}, Vec3::Zero());
    y.run(5.0);
    EXPECT_GT(y.w.coordinate(y.part("slew")), held + 0.01);
}

TEST(KnuckleCrane, SlewsAtItsSpeedAfterTheRamp) {
    KnuckleYard y(knuckle_crane, kTwenty);
    y.order("slew", 0.05);
    y.run(2.0);
    const double from = y.w.coordinate(y.part("slew"));
    y.run(10.0);
    EXPECT_NEAR(y.w.coordinate(y.part("slew")) - from, 0.5, 1e-3);
    y.order("slew", 0.0);
    y.run(3.0);
    const double stands = y.w.coordinate(y.part("slew"));
    y.run(5.0);
    EXPECT_NEAR(y.w.coordinate(y.part("slew")), stands, 1e-6);
}

}  // namespace
}  // namespace hawser
