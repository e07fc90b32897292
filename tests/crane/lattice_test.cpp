// SPDX-License-Identifier: Apache-2.0
/// Lattice cranes: falls, pendants, luffing.
#include "support/cranes_yard.h"

#include <algorithm>

namespace hawser {
namespace {

using test::kG;
using test::lattice_crane;
using test::LatticeYard;

constexpr double kFiveHundred = 500e3;

TEST(LatticeCrane, EachFallCarriesItsShare) {
    LatticeYard y(lattice_crane, kFiveHundred);
    y.run(60.0);
    ASSERT_EQ(y.ids.falls.size(), 12u);
    const double share = (kFiveHundred + 12e3) * kG / 12.0;
    for (const InteractionId fall : y.ids.falls)
        EXPECT_NEAR(y.mean(10.0, [&] { return -y.w.force(fall)[0]; }) / share, 1.0, 0.01);
}

TEST(LatticeCrane, SheavesThatRubTakeTheirShareWhileItHoists) {
    constexpr double eta = 0.98, n = 12.0;
    for (const double speed : {0.05, -0.05}) {
        LatticeYard y(lattice_crane, kFiveHundred,
                      [](LatticeCraneDef& d) { d.hoist.efficiency = eta; });
        y.run(40.0);
        y.order("hoist", speed);
        y.run(30.0);
        const double lead = y.mean(20.0, [&] { return y.tension("hoist/part1"); });
        const double whole = std::pow(eta, n), weight = (kFiveHundred + 12e3) * kG;
        const double expected = speed > 0.0 ? weight * (1.0 - eta) / (eta * (1.0 - whole))
                                            : weight * whole * (1.0 - eta) / (1.0 - whole);
        EXPECT_NEAR(lead / expected, 1.0, 5e-3) << speed;
    }
}

TEST(LatticeCrane, PendantsHoldTheMomentOfTheBoom) {
    LatticeYard y(lattice_crane, kFiveHundred);
    y.run(60.0);
    const LatticeCraneDef d = lattice_crane(y.quay);
    const Vec3 foot = y.w.world_point(y.ids.column, d.boom_foot - d.column.centre);
    const Vec3 gantry = y.w.world_point(y.ids.column, d.gantry - d.column.centre);
    const Vec3 drum = y.w.world_point(y.ids.column, d.hoist.drum - d.column.centre);
    const auto moment = [&](const Vec3& at, const Vec3& force) {
        return -(at - foot).cross(force).y();  // about −y
    };
    double expected = 0.0;
    const double tackle = y.mean(20.0, [&] {
        const Vec3 head = y.w.world_point(y.ids.boom, {30, 0, 0});
        const Vec3 held = y.w.world_point(y.ids.boom, {30, 0, 1.4});
        const double lead = y.tension("hoist/part1"), hangs = (kFiveHundred + 12e3) * kG;
        // Error of the distance to the head's sheave: its radius is 0.5 m of 60 m.
        const double turns = moment(head, {0, 0, -hangs}) +
                             moment(y.w.pose(y.ids.boom).position, {0, 0, -60e3 * kG}) +
                             moment(head, lead * (drum - head).normalized());
        expected += -turns / moment(held, (gantry - held).normalized()) / (20.0 * 60.0);
        return y.tension("luffing/part2");
    });
    EXPECT_NEAR(tackle * 16.0 / expected, 1.0, 0.01);
    const double pendants =
        y.mean(20.0, [&] { return y.tension("pendant1") + y.tension("pendant2"); });
    EXPECT_NEAR(pendants / expected, 1.0, 0.02);  // they spread by 1.6 m to each side
}

TEST(LatticeCrane, LuffingMovesTheBridle) {
    LatticeYard y(lattice_crane, 200e3);
    y.run(10.0);
    const LatticeCraneDef d = lattice_crane(y.quay);
    const Vec3 gantry = y.w.world_point(y.ids.column, d.gantry - d.column.centre);
    const auto way = [&] { return (y.w.pose(y.ids.bridle).position - gantry).norm(); };
    const double radius = y.signal("radius");
    y.order("luff", 0.05);
    y.run(4.0);
    const double from = way();
    y.run(20.0);
    EXPECT_NEAR(from - way(), 1.0, 0.02);  // the line contracts as its tension decreases
    EXPECT_LT(y.signal("radius"), radius - 1.0);
}

TEST(LatticeCrane, BoomMeetsItsStop) {
    LatticeYard y(lattice_crane, 200e3, [](LatticeCraneDef& d) { d.most_angle = 1.34; });
    y.order("luff", 0.1);
    y.run(60.0);
    EXPECT_NEAR(y.w.coordinate(y.part("luff")), 1.34, 1e-3);
    EXPECT_GT(y.count(EventKind::range), 0);
}

}  // namespace
}  // namespace hawser
