// SPDX-License-Identifier: Apache-2.0
// Energy::water: work of the sea on bodies, also on bodies that other systems load.
#include "floater.h"
#include "systems/acting.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <vector>

namespace hawser::test {
namespace {

/// Add a ball of 2 t that displaces 4 m³, released below the surface of a current, in waves.
BodyId add_ball(World& w) {
    const BodyId ball = w.add_body({.name = "ball",
                                    .position = {0, 0, -6.0},
                                    .velocity = {0.3, 0.0, 0.5},
                                    .mass = 2'000.0,
                                    .inertia = Vec3(800, 800, 800).asDiagonal()});
    return ball;
}

void add_sea(World& w, BodyId ball) {
    SeaDef sea{.depth = 60.0};
    sea.waves.push_back({.kind = WaveKind::regular, .height = 2.0, .period = 8.0});
    sea.current = {{0.0, 1.0, 0.4}};
    sea.bodies.push_back(
        {.body = ball, .drag_area = {3.0, 3.0, 3.0}, .volume = 4.0, .added_mass = {0.5, 0.5, 0.5}});
    w.add(sea);
}

/// Add a system with an oscillating force and a damper on the same body; it is not part of the
/// water.
Acting& add_pull(World& w, BodyId ball, const char* name) {
    return act(w, name, [ball](Acting&, Prestep& now, Loads& loads) {
        loads.add_force(ball, {900.0 * std::cos(now.time), 400.0, 0.0}, {0, 0, 0});
        loads.add_mass(ball, Mat3(Mat3::Identity() * 150.0));
        loads.add_damping(ball, Mat3(Mat3::Identity() * 40.0));
    });
}

/// Return the change of energies of bodies that neither water nor gravity explains.
double left_by_water(const Energy& from, const Energy& to) {
    return (to.kinetic + to.gravity - to.water) - (from.kinetic + from.gravity - from.water);
}

TEST(WaterEnergy, IsAllThatABodyInTheSeaGainsAndLoses) {
    World w;
    const BodyId ball = add_ball(w);
    add_sea(w, ball);
    go(w, 1);
    const Energy start = w.energy();
    double worst = 0.0, most = 0.0;
    for (int i = 0; i < 1'200; ++i) {
        go(w, 1);
        worst = std::max(worst, std::abs(left_by_water(start, w.energy())));
        most = std::max(most, std::abs(w.energy().water - start.water));
    }
    const Energy e = w.energy();
    std::printf("water did %.4g J, at most %.4g J; %.2g J not explained\n", e.water - start.water,
                most, worst);
    EXPECT_GT(most, 1e4);
    // 1,200 sums of about 1e5 J, each with a relative rounding error of 1e-16.
    EXPECT_LT(worst, 1e-10 * most);
    // The same value from the accounts that do not separate systems.
    EXPECT_NEAR(
        e.water - start.water,
        (e.system - start.system) - (e.dissipated - start.dissipated) - (e.added - start.added),
        1e-10 * most);
}

/// Systems before and after the sea load the same body. Their work equals that in a world in which
/// only they have names: kinetic + gravity − water.
TEST(WaterEnergy, LeavesOutWhatOtherSystemsDo) {
    for (const int order : {0, 1, 2}) {  // other systems before the sea, after it, both
        World w;
        const BodyId ball = add_ball(w);
        if (order != 1) add_pull(w, ball, "tug");
        add_sea(w, ball);
        if (order != 0) add_pull(w, ball, "line");
        go(w, 1);
        const Energy start = w.energy();
        const int pulls = order == 2 ? 2 : 1;
        double theirs = 0.0, most = 0.0;
        for (int i = 0; i < 600; ++i) {
            const Vec3 before = w.velocity(ball).linear;
            const double t = w.time(), h = w.settings().step;
            go(w, 1);
            const Vec3 after = w.velocity(ball).linear, mean = 0.5 * (before + after);
            // Impulse of a pull from its own definition, with θ of the damper from the world.
            const double late = w.loads().front().late;
            const Vec3 impulse = h * Vec3(900.0 * std::cos(t), 400.0, 0.0) -
                                 150.0 * (after - before) -
                                 h * 40.0 * (late * after + (1.0 - late) * before);
            theirs += pulls * impulse.dot(mean);
            most = std::max(most, std::abs(theirs));
        }
        std::printf("order %d: others did %.4g J, water %.4g J, %.2g J not explained\n", order,
                    theirs, w.energy().water - start.water,
                    left_by_water(start, w.energy()) - theirs);
        EXPECT_GT(most, 100.0);
        EXPECT_NEAR(left_by_water(start, w.energy()), theirs, 1e-8 * most);
    }
}

TEST(WaterEnergy, IsSavedCopiedAndTakenBack) {
    World w;
    const BodyId ball = add_ball(w);
    add_sea(w, ball);
    go(w, 100);
    const std::vector<std::byte> saved = w.state().save();
    const double water = w.energy().water;
    ASSERT_NE(water, 0.0);
    World other = w.twin();
    EXPECT_EQ(other.energy().water, water);
    go(w, 50);
    const double later = w.energy().water;
    EXPECT_NE(later, water);
    w.state().restore(saved);
    EXPECT_EQ(w.energy().water, water);
    go(w, 50);
    EXPECT_EQ(w.energy().water, later);
    go(other, 50);
    EXPECT_EQ(other.energy().water, later);
    // A failed step does not change it.
    act(w, "broken", [ball](Acting&, Prestep&, Loads& loads) {
        loads.add_force(ball, Vec3::Constant(std::numeric_limits<double>::quiet_NaN()),
                        Vec3::Zero());
    });
    EXPECT_EQ(w.step(), Status::bad_load);
    EXPECT_EQ(w.energy().water, later);
}

/// Loads other than water are not counted.
TEST(WaterEnergy, IsNothingWithoutASea) {
    World w({.gravity = Vec3::Zero()});
    const BodyId ball = add_ball(w);
    add_pull(w, ball, "tug");
    go(w, 60);
    EXPECT_NE(w.energy().system, 0.0);
    EXPECT_EQ(w.energy().water, 0.0);
}

}  // namespace
}  // namespace hawser::test
