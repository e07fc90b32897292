// SPDX-License-Identifier: Apache-2.0
/// A slender rod hits a floor with one end. Newton's law of restitution with friction can create
/// energy (T. R. Kane, 1984), and the impact stage must not apply such a bounce.
#include <gtest/gtest.h>

#include <hawser/hawser.h>

#include <cmath>
#include <ostream>

namespace hawser::test {
namespace {

constexpr double kHalfLength = 0.5, kRodRadius = 0.01, kInertia = kHalfLength * kHalfLength / 3.0;

struct Strike {
    double angle;  ///< Angle between the rod and the vertical [rad].
    double along;  ///< Speed along the floor [m/s]; it falls at 1 m/s.
    double friction, restitution;
};

std::ostream& operator<<(std::ostream& out, const Strike& s) {
    return out << "angle " << s.angle << ", along " << s.along << ", friction " << s.friction
               << ", restitution " << s.restitution;
}

/// Return the energy of (v_x, v_z, ω_y) of a rod of 1 kg.
double rod_energy(const Vec3& v) {
    return 0.5 * (v[0] * v[0] + v[1] * v[1] + kInertia * v[2] * v[2]);
}

/// Compute velocities after the impact by hand: two rows, normal and tangent, that stick or slide.
Vec3 struck(const Strike& s, double restitution) {
    const Vec3 before(s.along, -1.0, 0.0);
    const double x = -kHalfLength * std::sin(s.angle);
    const double z = -kHalfLength * std::cos(s.angle) - kRodRadius;
    Eigen::Matrix<double, 2, 3> j;
    j << 0.0, 1.0, -x, 1.0, 0.0, z;
    const Eigen::Matrix<double, 3, 2> jt =
        Vec3(1.0, 1.0, 1.0 / kInertia).asDiagonal() * j.transpose();
    const Eigen::Matrix2d w = j * jt;
    const Eigen::Vector2d u = j * before;
    Eigen::Vector2d impulse = w.inverse() * Eigen::Vector2d(-(1.0 + restitution) * u[0], -u[1]);
    if (std::abs(impulse[1]) > s.friction * impulse[0]) {
        const double mu = std::copysign(s.friction, impulse[1]);
        impulse[0] = -(1.0 + restitution) * u[0] / (w(0, 0) + mu * w(0, 1));
        impulse[1] = mu * impulse[0];
    }
    return before + jt * impulse;
}

/// Make a rod whose end is a nanometre inside the floor, or `gap` above it.
World make_rod(const Strike& s, double gap, BodyId& rod) {
    WorldDef def;
    def.gravity.setZero();
    def.staggered_start = false;
    def.step = 1e-3;
    World w(def);
    MaterialDef material;
    material.name = "steel";
    material.friction = s.friction;
    material.restitution = s.restitution;
    ShapeDef shape;
    shape.kind = ShapeKind::plane;
    shape.material = w.add_material(material);
    BodyDef floor;
    floor.kind = BodyKind::fixed;
    shape.body = w.add_body(floor);
    w.add_shape(shape);
    BodyDef d;
    d.mass = 1.0;
    d.inertia = Vec3(kInertia, kInertia, 1e-4).asDiagonal();
    d.orientation = Quat(Eigen::AngleAxisd(s.angle, Vec3::UnitY()));
    d.position = {0.0, 0.0, kHalfLength * std::cos(s.angle) + kRodRadius + gap};
    d.velocity = {s.along, 0.0, -1.0};
    shape.body = rod = w.add_body(d);
    shape.kind = ShapeKind::capsule;
    shape.radius = kRodRadius;
    shape.half_length = kHalfLength;
    w.add_shape(shape);
    return w;
}

Vec3 plane_motion(const World& w, BodyId rod) {
    const Twist t = w.velocity(rod);
    return {t.linear.x(), t.linear.z(), t.angular.y()};
}

TEST(ImpactEnergy, ABounceThatWouldGainEnergyIsDoneAgainWithoutRestitution) {
    int gaining = 0, losing = 0;
    for (const double angle : {0.4, 0.8, -0.6})
        for (const double along : {-0.5, 0.5, 1.5})
            for (const double friction : {0.3, 1.0})
                for (const double restitution : {0.5, 1.0}) {
                    const Strike s{angle, along, friction, restitution};
                    SCOPED_TRACE(s);
                    const double before = rod_energy({along, -1.0, 0.0});
                    const Vec3 bounced = struck(s, restitution);
                    const bool gains = rod_energy(bounced) > before;
                    ++(gains ? gaining : losing);
                    BodyId rod;
                    World w = make_rod(s, -1e-9, rod);
                    ASSERT_EQ(w.step(), Status::ok);
                    EXPECT_EQ(w.stats().impacts, 1);
                    EXPECT_EQ(w.stats().impact_retries, gains ? 1 : 0);
                    const Vec3 after = plane_motion(w, rod);
                    EXPECT_LE(rod_energy(after), before);
                    // The rows of the stage have a relative compliance of a millionth.
                    EXPECT_LT((after - (gains ? struck(s, 0.0) : bounced)).norm(), 1e-5);
                }
    EXPECT_GE(gaining, 3);
    EXPECT_GE(losing, 20);
}

TEST(ImpactEnergy, NothingGainsInTheStepsRoundAStrikeFromAbove) {
    BodyId rod;
    World w = make_rod({0.4, 0.5, 1.0, 1.0}, 2.5e-3, rod);  // would touch in the third step
    double energy = rod_energy(plane_motion(w, rod));
    for (int i = 0; i < 20; ++i) {
        ASSERT_EQ(w.step(), Status::ok);
        const double now = rod_energy(plane_motion(w, rod));
        EXPECT_LE(now, energy * (1.0 + 1e-12)) << i;  // free flight: rounding
        energy = now;
    }
    // Stopped slightly above the floor, it may collide once more.
    EXPECT_GE(w.stats().impacts, 1);
    EXPECT_EQ(w.stats().impact_retries, w.stats().impacts);
    EXPECT_LT(energy, 0.9 * rod_energy({0.5, -1.0, 0.0}));
}

}  // namespace
}  // namespace hawser::test
