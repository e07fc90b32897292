// SPDX-License-Identifier: Apache-2.0
// Every contact method with a block on a slope: it rests, or slides as in the closed form.
#include <hawser/hawser.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace hawser {
namespace {

struct Slope {
    World world;
    BodyId block;
    Vec3 down;  ///< Unit vector down the slope.
};

constexpr double kFriction = 0.5;

Slope make_slope(Nonsmooth method, double slope) {
    WorldDef def;
    def.nonsmooth = method;
    def.staggered_start = false;
    Slope s{World(def), {}, {}};
    const Quat tilt(Eigen::AngleAxisd(std::atan(slope), Vec3::UnitY()));
    s.down = tilt * Vec3::UnitX();
    const BodyId ground =
        s.world.add_body({.name = "ground", .kind = BodyKind::fixed, .orientation = tilt});
    MaterialDef steel{.name = "steel"};
    steel.friction = kFriction;
    steel.stiffness = 1e7;
    const MaterialId material = s.world.add_material(steel);
    BodyDef block{.name = "block"};
    // Four points of 1e7 N/m carry 9 kN: 0.2 mm deep.
    block.position = tilt * Vec3(0.0, 0.0, 0.2498);
    block.orientation = tilt;
    block.mass = 1000.0;
    block.inertia = Vec3(104.0, 104.0, 167.0).asDiagonal();
    s.block = s.world.add_body(block);
    s.world.add_shape({.kind = ShapeKind::plane, .body = ground, .material = material});
    s.world.add_shape({.kind = ShapeKind::box,
                       .body = s.block,
                       .half_size = {0.5, 0.5, 0.25},
                       .material = material});
    return s;
}

class Methods : public ::testing::TestWithParam<Nonsmooth> {};

TEST_P(Methods, HoldABlockBelowTheLimit) {
    Slope s = make_slope(GetParam(), 0.8 * kFriction);
    Vec3 at = Vec3::Zero();
    for (int i = 0; i < 300; ++i) {
        ASSERT_EQ(s.world.step(), Status::ok);
        if (i == 99) at = s.world.pose(s.block).position;
    }
    // Friction is a spring in every method; only its settling is left.
    EXPECT_LE((s.world.pose(s.block).position - at).norm(), 1e-8);
}

TEST_P(Methods, LetABlockSlideBeyondIt) {
    constexpr double kSlope = 0.75;
    Slope s = make_slope(GetParam(), kSlope);
    double from = 0.0;
    for (int i = 0; i < 120; ++i) {
        ASSERT_EQ(s.world.step(), Status::ok);
        if (i == 29) from = s.world.velocity(s.block).linear.dot(s.down);
    }
    const double angle = std::atan(kSlope);
    const double exact = 9.81 * (std::sin(angle) - kFriction * std::cos(angle));
    const double found = (s.world.velocity(s.block).linear.dot(s.down) - from) / (90.0 / 60.0);
    // Sweeps have an error of a per cent in the normal force; the others solve it.
    EXPECT_NEAR(found / exact, 1.0, GetParam() == Nonsmooth::pgs ? 0.02 : 2e-3);
}

TEST_P(Methods, BalanceMomentum) {
    Slope s = make_slope(GetParam(), 0.75);
    for (int i = 0; i < 60; ++i) {
        ASSERT_EQ(s.world.step(), Status::ok);
        // For any impulses, velocities follow from them.
        ASSERT_LE(s.world.stats().momentum_residual, 1e-10) << i;
    }
}

std::string name_of(const ::testing::TestParamInfo<Nonsmooth>& info) {
    const char* names[] = {"newton", "pivoting", "split", "pgs", "convex"};
    return names[static_cast<std::size_t>(info.param)];
}

INSTANTIATE_TEST_SUITE_P(All, Methods,
                         ::testing::Values(Nonsmooth::newton, Nonsmooth::pivoting, Nonsmooth::split,
                                           Nonsmooth::pgs, Nonsmooth::convex),
                         name_of);

}  // namespace
}  // namespace hawser
