// SPDX-License-Identifier: Apache-2.0
// Rods of rigid bodies in the water against closed forms.
#include "floater.h"

#include <algorithm>
#include <string>

namespace hawser::test {
namespace {

constexpr double kSalt = 1025.0, kWeight = 9.81, kStep = 1.0 / 60.0;

double disc(double d) { return 0.25 * kPi * d * d; }

/// A rod about a body's centre of mass, in still water or in a sea.
struct Rod {
    World w{WorldDef{.step = kStep}};
    BodyId body{};

    Rod(const BodyDef& def, const WaterRod& rod, SeaDef sea = {.depth = 1000.0}) {
        body = w.add_body(def);
        WaterRod own = rod;
        own.body = body;
        sea.rods.push_back(own);
        w.add(sea);
    }
    [[nodiscard]] Twist twist() const { return w.velocity(body); }
    [[nodiscard]] double z() const { return w.pose(body).position.z(); }
};

/// Compute the cosine of the phase per step of an oscillation ω in the scheme: tan(ω_h h/2) = ω
/// h/2.
double cosine_of_step(double omega) { return std::cos(2.0 * std::atan(0.5 * omega * kStep)); }

/// A spar of 40 m that floats at a draught of 24 m; its centre of mass is 10 m above the lower end.
struct Spar {
    static constexpr double kLow = -10.0, kDraught = 24.0, kDiameter = 2.0;
    static double mass() { return kSalt * disc(kDiameter) * kDraught; }
    static BodyDef def(double rise) {
        return {.name = "spar",
                .position = {0, 0, -kDraught - kLow + rise},
                .mass = mass(),
                .inertia = Vec3(100 * mass(), 100 * mass(), mass()).asDiagonal()};
    }
    static WaterRod rod(double along) {
        return {.from = {0, 0, kLow},
                .to = {0, 0, kLow + 40.0},
                .water = {.diameter = kDiameter, .cd_normal = 0.0, .ca_tangential = along},
                .segments = 8};
    }
};

TEST(Rods, ASparFloatsAtItsDraught) {
    Rod still(Spar::def(0.0), Spar::rod(0.0));
    go(still.w, 600);
    // Weights of 8e5 N cancel up to rounding, which the stiffness of 3e4 N/m makes 1e-14 m per
    // step.
    EXPECT_NEAR(still.z(), -Spar::kDraught - Spar::kLow, 1e-9);
    double up = 0.0;
    for (const LoadView& l : sea_loads(still.w)) up += l.force[2];
    EXPECT_NEAR(up, Spar::mass() * kWeight, 1e-9 * Spar::mass() * kWeight);
}

TEST(Rods, ASparHeavesWithThePeriodOfTheScheme) {
    // Without axial added mass the heave is linear for any segments, through the boundary of two
    // segments at 25 m. ω² = ρ g A/m = g/draught.
    const double rise = 1.5;
    Rod free(Spar::def(rise), Spar::rod(0.0));
    const double c = cosine_of_step(std::sqrt(kWeight / Spar::kDraught));
    const double rest = -Spar::kDraught - Spar::kLow;
    double before = free.z() - rest, worst = 0.0;
    go(free.w, 1);
    double now = free.z() - rest;
    for (int i = 0; i < 3'000; ++i) {
        go(free.w, 1);
        const double next = free.z() - rest;
        worst = std::max(worst, std::abs(next + before - 2.0 * c * now));
        before = now;
        now = next;
    }
    std::printf("heave is off the scheme's relation by %.2g m\n", worst);
    // A step across a boundary of segments changes the point of the stiffness, not its size.
    EXPECT_LT(worst, 1e-9);
    // Axial added mass is proportional to the wet length, which heave of 1 mm changes by 4e-5 of
    // itself.
    Rod heavy(Spar::def(1e-3), Spar::rod(0.5));
    const double slow = cosine_of_step(std::sqrt(kWeight / Spar::kDraught / 1.5));
    before = 1e-3;
    go(heavy.w, 1);
    now = heavy.z() - rest;
    worst = 0.0;
    for (int i = 0; i < 1'000; ++i) {
        go(heavy.w, 1);
        const double next = heavy.z() - rest;
        worst = std::max(worst, std::abs(next + before - 2.0 * slow * now));
        before = now;
        now = next;
    }
    // The second difference of a step is h² ω² of the amplitude: 7.6e-8 m. The change of added mass
    // is 4e-5 of it.
    std::printf("with added mass by %.2g m\n", worst);
    EXPECT_LT(worst, 1e-4 * 7.6e-8);
}

TEST(Rods, SinkAtTheirTerminalSpeeds) {
    const double d = 0.5, length = 12.0, volume = disc(d) * length, mass = 2.0 * kSalt * volume;
    const double weight = (mass - kSalt * volume) * kWeight;
    const BodyDef def{.name = "pipe",
                      .position = {0, 0, -50},
                      .mass = mass,
                      .inertia = Vec3(mass, mass, mass).asDiagonal()};
    const LineWater water{.diameter = d, .cd_normal = 0.9, .cd_tangential = 0.05};
    Rod level(def, {.from = {-6, 0, 0}, .to = {6, 0, 0}, .water = water});
    go(level.w, 1'200);
    // Within 1e-4; the rest of the approach is e^(−2 g' t/v) of the speed, far less.
    const double across = std::sqrt(2.0 * weight / (kSalt * 0.9 * d * length));
    EXPECT_NEAR(-level.twist().linear.z() / across, 1.0, 1e-4);
    Rod upright(def, {.from = {0, 0, -6}, .to = {0, 0, 6}, .water = water});
    go(upright.w, 3'600);
    const double along = std::sqrt(2.0 * weight / (kSalt * 0.05 * kPi * d * length));
    std::printf("sinks at %.6f of %.6f, %.6f of %.6f m/s\n", -level.twist().linear.z(), across,
                -upright.twist().linear.z(), along);
    EXPECT_NEAR(-upright.twist().linear.z() / along, 1.0, 1e-4);
}

TEST(Rods, ASpinDecaysByTheQuadraticMoment) {
    // I ω̇ = −k ω², k = ½ρ C_d d L⁴/32 by the integral. An even number n of segments has (1 − 2/n²)
    // of it. ω = ω₀/(1 + k ω₀ t/I).
    const double d = 0.4, length = 10.0, cd = 1.1, inertia = 2e6, spin = 1.5;
    for (const int n : {2, 8, 40}) {
        Rod rod({.name = "boom",
                 .position = {0, 0, -100},
                 .angular_velocity = {0, 0, spin},
                 .mass = 3e5,
                 .inertia = Vec3(1e3, inertia, inertia).asDiagonal(),
                 .gravity = false},
                {.from = {-5, 0, 0},
                 .to = {5, 0, 0},
                 .water = {.diameter = d, .volume = 0.0, .cd_normal = cd},
                 .segments = n});
        const double whole = 0.5 * kSalt * cd * d * std::pow(length, 4) / 32.0;
        const double k = whole * (1.0 - 2.0 / (n * n));
        // Compare two states, so that the time of the first one does not matter.
        go(rod.w, 1);
        const double first = rod.twist().angular.z();
        go(rod.w, 600);
        const double expected = first / (1.0 + k * first * 600 * kStep / inertia);
        // Error of second order in the step: k ω h/I is 9e-4 at the start, its square 8e-7. The
        // drag of all motions together determines its time in the step and adds no more.
        EXPECT_NEAR(rod.twist().angular.z() / expected, 1.0, 1e-6) << n;
        EXPECT_LT(rod.twist().linear.norm(), 1e-12);
    }
}

TEST(Rods, AddedMassIsInTheFirstAcceleration) {
    const double d = 0.5, length = 12.0, mass = 3.0 * kSalt * disc(d) * length, ca = 0.8;
    const double own = kSalt * disc(d) * length, inertia = 4e4;
    const BodyDef def{.name = "pipe",
                      .position = {0, 0, -500},
                      .mass = mass,
                      .inertia = Vec3(1e3, inertia, inertia).asDiagonal()};
    WaterRod rod{.from = {-6, 0, 0},
                 .to = {6, 0, 0},
                 .water = {.diameter = d, .cd_normal = 0.0, .ca_normal = ca, .ca_tangential = 0.2},
                 .segments = 5};
    Rod sinks(def, rod);
    go(sinks.w, 1);
    const double first = sinks.twist().linear.z();
    go(sinks.w, 1);
    // The secant of buoyancy at 500 m adds h² ρ g V/2000 to the mass, which is 1e-6 of it.
    EXPECT_NEAR((sinks.twist().linear.z() - first) / kStep,
                -(mass - own) * kWeight / (mass + ca * own), 3e-6 * kWeight);
    for (const int n : {1, 5, 24}) {
        rod.segments = n;
        Rod turns(def, rod);
        const double torque = 1e3;
        turns.w.set_force(turns.body, {2e3, 0, 0}, {0, 0, torque});
        go(turns.w, 1);
        const Twist before = turns.twist();
        go(turns.w, 1);
        const double added = ca * own * length * length / 12.0 * (1.0 - 1.0 / (n * n));
        // Rotations of 1e-5 rad do not change it; along the rod C_at acts.
        EXPECT_NEAR((turns.twist().angular.z() - before.angular.z()) / kStep,
                    torque / (inertia + added), 1e-8 * torque / inertia)
            << n;
        EXPECT_NEAR((turns.twist().linear.x() - before.linear.x()) / kStep,
                    2e3 / (mass + 0.2 * own), 1e-6 * 2e3 / mass)
            << n;
    }
}

TEST(Rods, AWavePressesAFixedRodByTheIntegralOverItsDepth) {
    // a = 1 cm, T = 8 s: force (1 + C_a) ρ A a ω² (1 − e^(−kT))/k and its moment about the surface.
    const double period = 8.0, omega = 2.0 * kPi / period, deep = 30.0, d = 3.0, ca = 0.9;
    const double k = wave_number(omega, 1000.0, kWeight), amplitude = 0.01;
    SeaDef sea{.depth = 1000.0};
    sea.waves.push_back({.height = 2.0 * amplitude, .period = period});
    World w(WorldDef{.step = period / 200.0});
    const BodyId pile = w.add_body({.name = "pile", .kind = BodyKind::fixed});
    // A body without loads, which can move.
    w.add_body({.name = "lump", .kind = BodyKind::lump, .mass = 1.0, .gravity = false});
    sea.rods.push_back({.body = pile,
                        .from = {0, 0, -deep},
                        .to = {0, 0, 0},
                        .water = {.diameter = d, .cd_normal = 0.0, .ca_normal = ca},
                        .segments = 60});
    w.add(sea);
    Complex force = 0.0, moment = 0.0;
    for (int i = 0; i < 200; ++i) {
        const Complex turn = std::polar(0.01, omega * w.time());
        go(w, 1);
        for (const LoadView& load : sea_loads(w))
            if (load.body == pile) {
                force += load.force[0] * turn;
                moment += load.force[4] * turn;
            }
    }
    const double fade = std::exp(-k * deep);
    const double per_length = (1.0 + ca) * kSalt * disc(d) * amplitude * omega * omega;
    const double expected = per_length * (1.0 - fade) / k;
    const double lever = per_length * (1.0 - fade * (1.0 + k * deep)) / (k * k);
    std::printf("force %.6g of %.6g N, moment %.6g of %.6g N m\n", std::abs(force), expected,
                std::abs(moment), lever);
    // Segments of 0.5 m: (kl)²/24 = 4e-5; the wave wets 1 cm of the top.
    EXPECT_NEAR(std::abs(force) / expected, 1.0, 5e-3);
    EXPECT_NEAR(std::abs(moment) / lever, 1.0, 5e-3);
}

}  // namespace
}  // namespace hawser::test
