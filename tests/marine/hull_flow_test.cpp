// SPDX-License-Identifier: Apache-2.0
// Hulls with constant added mass in waves, drag areas by draught, and cells of hulls.
#include <gtest/gtest.h>
#include <hawser/hawser.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace hawser::test {
namespace {

constexpr double kFlowPi = std::numbers::pi, kFlowRho = 1025.0, kFlowG = 9.81;

double volume_of(const std::vector<HullCell>& cells) {
    double sum = 0.0;
    for (const HullCell& c : cells) sum += c.volume();
    return sum;
}

TEST(HullCells, FillAMesh) {
    for (const Vec3& half : {Vec3(30, 10, 2.5), Vec3(5, 5, 5), Vec3(2, 2, 50), Vec3(80, 1, 1)}) {
        const auto cells = hull_cells(box_hull(half, 5, 4, 3));
        EXPECT_NEAR(volume_of(cells), 8.0 * half.prod(), 1e-9 * half.prod());
        EXPECT_GE(cells.size(), 50U);
        EXPECT_LE(cells.size(), 1000U);
    }
    // A ball of 5 m in slices: cells of 1.3 m miss its rim.
    HullMesh ball = box_hull({1, 1, 1}, 12, 12, 12);
    for (Vec3& v : ball.vertices) v = 5.0 * v.normalized();
    EXPECT_NEAR(volume_of(hull_cells(ball)), 4.0 / 3.0 * kFlowPi * 125.0,
                0.05 * 4.0 / 3.0 * kFlowPi * 125.0);
}

/// Loads of the sea on a fixed body over one period: harmonics of force and moment.
struct Harmonics {
    std::complex<double> heave = 0.0, pitch = 0.0;
};
Harmonics on_held_box(const WaterHull& of, double lambda, double amplitude) {
    const double period = std::sqrt(2.0 * kFlowPi * lambda / kFlowG),
                 omega = 2.0 * kFlowPi / period;
    World w(WorldDef{.step = period / 100.0, .gravity = {0, 0, -kFlowG}});
    WaterHull hull = of;
    hull.body = w.add_body({.name = "box", .kind = BodyKind::fixed});
    w.add_body({.name = "lump", .kind = BodyKind::lump, .mass = 1.0, .gravity = false});
    SeaDef sea{.depth = 2000.0};
    sea.waves.push_back({.height = 2.0 * amplitude, .period = period});
    sea.hulls.push_back(hull);
    w.add(sea);
    Harmonics out;
    for (int i = 0; i < 100; ++i) {
        const auto turn = std::polar(0.02, omega * w.time());
        if (w.step() != Status::ok) break;
        for (const LoadView& load : sea_loads(w))
            if (load.body == hull.body) {
                out.heave += load.force[2] * turn;
                out.pitch += load.force[4] * turn;
            }
    }
    return out;
}

/// Box of length L and draught T: the mean of a cos(kx) over the wet volume is sin(kL/2)/(kL/2) (1
/// - e^-kT)/kT. The mean of the slope over the length is 3 (sin q - q cos q)/q^3, q = kL/2.
TEST(HullFlow, MeansOverTheWetVolume) {
    constexpr double kLong = 60.0, kDraught = 3.0, kWave = 0.01, kMass = 1e6, kInertia = 1e9;
    WaterHull with{.mesh = box_hull({30, 10, 3}, 40, 6, 6),
                   .added_mass = {0, 0, kMass, 0, kInertia, 0}};
    WaterHull without = with;
    without.added_mass = {};
    for (const double lambda : {39.0, 90.0, 180.0, 1000.0}) {
        const double k = 2.0 * kFlowPi / lambda, q = 0.5 * k * kLong, omega2 = kFlowG * k;
        const Harmonics a = on_held_box(with, lambda, kWave),
                        b = on_held_box(without, lambda, kWave);
        const double deep = (1.0 - std::exp(-k * kDraught)) / (k * kDraught);
        const double heave = kMass * omega2 * kWave * deep * std::sin(q) / q;
        // About 20 cells along the hull, 0.6 % of a wave of 0.65 lengths; two layers in depth.
        EXPECT_NEAR(std::abs(a.heave - b.heave), std::abs(heave), 0.02 * kMass * omega2 * kWave)
            << lambda;
        const double slope = k * 3.0 * (std::sin(q) - q * std::cos(q)) / (q * q * q);
        const double pitch = kInertia * omega2 * kWave * slope * deep;
        EXPECT_NEAR(std::abs(a.pitch - b.pitch), std::abs(pitch),
                    0.03 * kInertia * omega2 * kWave * k)
            << lambda;
    }
}

/// Compute the drag of a current along x and y on a fixed body.
Vec3 drag_of(const HullMesh& mesh, const Pose& pose, double design, const Vec3& areas) {
    World w(WorldDef{.gravity = {0, 0, -kFlowG}});
    const BodyId body = w.add_body({.name = "box",
                                    .kind = BodyKind::fixed,
                                    .position = pose.position,
                                    .orientation = pose.orientation});
    w.add_body({.name = "lump", .kind = BodyKind::lump, .mass = 1.0, .gravity = false});
    SeaDef sea{.depth = 100.0};
    sea.current.push_back({0.0, 2.0, 0.0});
    sea.hulls.push_back({.body = body, .mesh = mesh, .drag_area = areas, .design_draught = design});
    w.add(sea);
    (void)w.step();
    Vec3 out = Vec3::Zero();
    for (const LoadView& load : sea_loads(w))
        if (load.body == body) out = Vec3(load.force[0], load.force[1], load.force[2]);
    out.z() = 0.0;
    return out / (0.5 * kFlowRho * 4.0);
}

TEST(HullFlow, DragFollowsTheDraught) {
    const HullMesh mesh = box_hull({10, 5, 4}, 3, 3, 3);
    for (const double draught : {1.0, 2.0, 3.0, 5.0, 8.0, 20.0}) {
        const Pose pose{{0, 0, 4.0 - draught}, Quat::Identity()};
        const double expected = 40.0 * std::min(draught, 8.0) / 3.0;
        EXPECT_NEAR(drag_of(mesh, pose, 3.0, {40, 0, 0}).x(), expected, 1e-9 * expected) << draught;
    }
}

TEST(HullFlow, DesignDraughtIsWhereTheMassFloats) {
    const HullMesh mesh = box_hull({10, 5, 4}, 3, 3, 3);
    for (const double draught : {1.3, 4.7, 7.9}) {
        World w(WorldDef{.gravity = {0, 0, -kFlowG}});
        const double mass = kFlowRho * 200.0 * draught;
        const auto part = [&](const char* name, double of, const Vec3& at) {
            return w.add_body({.name = name,
                               .position = at,
                               .mass = of,
                               .inertia = Vec3::Constant(of * 20.0).asDiagonal()});
        };
        // A crane on the hull, of a tenth of the mass.
        const BodyId hull = part("hull", 0.9 * mass, {0, 0, 4.0 - draught});
        const BodyId crane = part("crane", 0.1 * mass, {0, 0, 10});
        InteractionDef weld{.kind = InteractionKind::Lock, .body = {hull, crane}};
        weld.point = {Vec3(0, 0, 6.0 + draught), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
        w.add_interaction(weld);
        SeaDef sea{.depth = 100.0};
        sea.hulls.push_back({.body = hull, .mesh = mesh, .drag_area = {40, 80, 0}});
        w.add(sea);
        EXPECT_NEAR(find_sea(w)->hulls[0].design_draught, draught, 1e-9);
    }
}

WaveCoefficients some_damping() {
    WaveCoefficients c;
    for (int i = 1; i <= 20; ++i) {
        c.frequency.push_back(0.1 * i);
        c.added_mass.push_back(1e6 * Matrix6::Identity());
        const double w = 0.1 * i;
        c.damping.push_back(1e5 * w * w * w * std::exp(-3.0 * w) * Matrix6::Identity());
    }
    c.infinite = 1e6 * Matrix6::Identity();
    c.has_infinite = true;
    return c;
}

TEST(NegativeDamping, IsRepairedOnRequest) {
    const WaveCoefficients good = some_damping();
    ASSERT_EQ(coefficients_fault(good), "");
    WaveCoefficients bad = good;
    for (std::size_t i = 15; i < 20; ++i) bad.damping[i](2, 2) = -2e3;
    EXPECT_NE(coefficients_fault(bad).find("negative_damping"), std::string::npos);
    const WaveCoefficients cut = repaired_damping(bad, NegativeDamping::truncate);
    EXPECT_EQ(coefficients_fault(cut), "");
    EXPECT_EQ(cut.damping[14], good.damping[14]);
    EXPECT_NEAR(cut.damping[19](2, 2), good.damping[14](2, 2) * std::pow(1.5 / 2.0, 3), 1e-9);
    const WaveCoefficients fitted = repaired_damping(bad, NegativeDamping::fit);
    EXPECT_EQ(coefficients_fault(fitted), "");
    EXPECT_NEAR(fitted.damping[17](2, 2), 0.0, 1e-6);
    EXPECT_NEAR(fitted.damping[17](3, 3), good.damping[17](3, 3), 1e-9);
    EXPECT_EQ(fitted.damping[3], good.damping[3]);
    WaveCoefficients first = good;
    first.damping[0](2, 2) = -1e4;
    EXPECT_THROW(repaired_damping(first, NegativeDamping::truncate), DefError);
    EXPECT_EQ(coefficients_fault(repaired_damping(first, NegativeDamping::fit)), "");
}

TEST(MemoryEnds, AreMeasured) {
    const WaveCoefficients c = some_damping();
    EXPECT_GT(memory_end(c, 3.0).ratio, 0.01);
    const double enough = memory_end(c, 3.0).enough;
    EXPECT_GT(enough, 3.0);
    EXPECT_LE(memory_end(c, enough).ratio, 0.0105);
    EXPECT_EQ(memory_end(c, enough + 5.0).enough, enough + 5.0);
}

}  // namespace
}  // namespace hawser::test
