// SPDX-License-Identifier: Apache-2.0
// Wires with friction on a deck: many contacts and elements that switch together in one step.
#include "contact/convex_phase.h"
#include "nonsmooth/cone.h"
#include "support/random.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <hawser/hawser.h>
#include <hawser/scene.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hawser::test {
namespace {

/// A slack wire along the deck, from a point of it.
struct DeckWire {
    int elements = 100;
    double acceleration = 6.0;  ///< Largest acceleration of the deck [m/s²].
    static constexpr double kMass = 27.6, kLength = 1.2, kRadius = 0.038;

    [[nodiscard]] static BodyDef lump(int i) {
        BodyDef d;
        d.kind = BodyKind::lump;
        d.mass = kMass;
        d.position = {0.995 * kLength * (i + 1), 0.02 * (i % 3), kRadius};
        return d;
    }
    [[nodiscard]] static InteractionDef element(BodyId a, BodyId b, bool first) {
        InteractionDef d{.kind = InteractionKind::Stretch, .body = {a, b}};
        d.set("length", kLength).set("EA", 2.33e8).set("tension_only", 1.0);
        if (first) d.point[0] = {0.0, 0.0, kRadius};
        return d;
    }
    /// Return the inertial force on a node in the deck's frame [N].
    [[nodiscard]] Vec3 force(double t) const {
        return kMass * acceleration * Vec3(std::sin(1.3 * t), 0.7 * std::sin(1.1 * t + 1.0), 0.0);
    }
};

World deck_world(const DeckWire& wire, std::vector<BodyId>& lumps) {
    World w;
    BodyDef ground;
    ground.kind = BodyKind::fixed;
    BodyId last = w.add_body(ground);
    ShapeDef plane;
    plane.kind = ShapeKind::plane;
    plane.body = last;
    w.add_shape(plane);
    for (int i = 0; i < wire.elements; ++i) {
        const BodyId b = w.add_body(DeckWire::lump(i));
        w.add_interaction(DeckWire::element(last, b, i == 0));
        ShapeDef ball;
        ball.radius = DeckWire::kRadius;
        ball.body = b;
        w.add_shape(ball);
        lumps.push_back(b);
        last = b;
    }
    return w;
}

/// The whole wire starts to slide, comes taut and reverses. One such step once took 215
/// factorisations, and another one ended uncertified.
TEST(DeckWire, TakesFewFactorisationsWhereItBeginsToSlide) {
    const DeckWire wire;
    std::vector<BodyId> lumps;
    World w = deck_world(wire, lumps);
    int most = 0;
    for (int i = 0; i < by_tier(400, 600, 3600); ++i) {
        for (const BodyId b : lumps) w.set_force(b, wire.force(w.time()), Vec3::Zero());
        ASSERT_EQ(w.step(), Status::ok) << i;
        const StepStats& s = w.stats();
        most = std::max(most, s.factorisations);
        EXPECT_LE(s.natural_map, w.settings().contact_tolerance) << i;
        EXPECT_EQ(s.flips_left, 0) << i;
        EXPECT_LE(s.momentum_residual, 1e-9) << i;
    }
    // Two per step, and a few in steps in which the wire comes taut; the first step starts from
    // soft tangents.
    EXPECT_LE(most, 10);
}

/// 1,080 contacts without impulses at the start. Each iteration descends by a full step: the first
/// step needs no soft tangents. It took eight factorisations when soft tangents followed five
/// iterations, those of trial steps included.
TEST(DeckWire, AFirstStepThatDescendsTakesFewFactorisations) {
    scene::Scene site = scene::load_file("scenes/anchor_contact.json");
    ASSERT_EQ(site.world.step(), Status::ok);
    const StepStats& s = site.world.stats();
    EXPECT_GT(s.contacts, 1000);
    EXPECT_LE(s.factorisations, 3);
    EXPECT_LE(s.natural_map, site.world.settings().contact_tolerance);
}

/// Return φ* of a contact with a disk of fixed radius: normal plus tangential part.
double held_energy(const nonsmooth::Cone& c, const double u[3], double radius) {
    const double n = std::max(0.0, c.b[0] - u[0]);
    const double t = std::hypot(c.b[1] - u[1], c.b[2] - u[2]);
    const double edge = radius * c.sigma_t;  // Huber's function of t
    return 0.5 * n * n / c.sigma_n +
           (t <= edge ? 0.5 * t * t / c.sigma_t : radius * t - 0.5 * radius * edge);
}

TEST(ConvexPhase, SlopeIsTheDerivativeOfTheEnergy) {
    Random random(first_seed(3));
    for (int trial = 0; trial < by_tier(2000, 10'000, 100'000); ++trial) {
        nonsmooth::Cone c{};
        c.sigma_n = std::pow(10.0, random.uniform(-3, -1));
        c.sigma_t = c.sigma_n;
        c.mobility = std::pow(10.0, random.uniform(-3, 0));
        c.friction = random.uniform(0.1, 1.0);
        double from[6];
        for (int i = 0; i < 3; ++i) {
            c.b[i] = random.uniform(-0.1, 0.1);
            c.u[i] = random.uniform(-0.1, 0.1);
            c.lambda[i] = random.uniform(-1, 1);
            from[i] = random.uniform(-0.1, 0.1);
            from[3 + i] = random.uniform(-1, 1);
        }
        const double radius = nonsmooth::disk_radius(contact::convex_cone(c), from, from + 3);
        const double t = random.uniform(0, 1), step = 1e-6;
        const auto energy = [&](double share) {
            double u[3], work = 0.0;
            for (int i = 0; i < 3; ++i) {
                u[i] = from[i] + share * (c.u[i] - from[i]);
                // ∫ λ·du of an impulse that changes linearly.
                work += (c.u[i] - from[i]) *
                        (share * from[3 + i] + 0.5 * share * share * (c.lambda[i] - from[3 + i]));
            }
            return held_energy(c, u, radius) + work;
        };
        const double slope = (energy(t + step) - energy(t - step)) / (2.0 * step);
        const double size = 1.0 + std::fabs(energy(t)) + std::fabs(slope);
        // Central differences: rounding over the step.
        ASSERT_NEAR(contact::contact_slope(c, from, t), slope, 1e-6 * size) << trial;
    }
}

TEST(ConvexPhase, LineSearchFindsTheZeroOfASlope) {
    Random random(first_seed(4));
    for (int trial = 0; trial < by_tier(500, 5000, 50'000); ++trial) {
        // Piecewise linear, with jumps of its derivative by four orders of magnitude.
        const double kink = random.uniform(0.01, 0.99), low = std::pow(10.0, random.uniform(-2, 2)),
                     high = std::pow(10.0, random.uniform(-2, 2)), zero = random.uniform(0.05, 1.5);
        const auto piecewise = [&](double t) {
            return t <= kink ? low * t : low * kink + high * (t - kink);
        };
        const auto slope = [&](double t) { return piecewise(t) - piecewise(zero); };
        const double t = contact::zero_slope_fraction(slope);
        if (zero >= 1.0)
            ASSERT_EQ(t, 1.0) << trial;
        else
            ASSERT_LE(std::fabs(slope(t)), 0.05 * std::fabs(slope(0.0)) + 1e-12) << trial;
    }
}

}  // namespace
}  // namespace hawser::test
