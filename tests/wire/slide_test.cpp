// SPDX-License-Identifier: Apache-2.0
/// Wires that slide sideways along a guide. With sufficient friction they stay to the bit; beyond
/// it they lie at Coulomb's angle; without friction they take the shortest path; they leave at an
/// end; energy, bits.
#include <hawser/hawser.h>

#include <gtest/gtest.h>
#include "support/sanitizer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace hawser {
namespace {

/// A weightless wire from a ship over its stern, an edge along y, to a body that is pulled.
struct Stern {
    static constexpr double kDensity = 4.2, kEA = 4.5e7, kHalf = 0.016;  // kg/m, N, m
    static constexpr double kFore = 20.0, kRadius = 0.2;                 // m
    World w;
    BodyId ship{}, towed{};
    WireId wire{};

    explicit Stern(double friction, int threads = 1, double half_length = 7.0, bool slides = true)
        : w(WorldDef{.step = 1.0 / 60.0, .gravity = Vec3::Zero(), .threads = threads}) {
        ship = w.add_body({.name = "ship", .kind = BodyKind::fixed});
        towed = w.add_body({.name = "towed",
                            .position = {60.0, 0, 0.6},
                            .mass = 2e4,
                            .inertia = 2e4 * Mat3::Identity(),
                            .force = {1e5, 0, 0},
                            .linear_damping = Vec3::Constant(1.5e4),
                            .angular_damping = Vec3::Constant(2e6)});
        WireDef def{.name = "wire", .from = ship, .to = towed};
        def.from_point = {-kFore, 0, 0.6};
        def.elements = 26;
        def.length = (60.0 + kFore) / (1.0 + 1e5 / kEA);
        def.EA = kEA;
        def.mass_per_length = kDensity;
        def.drag = 20.0;
        def.consistent_mass = true;
        def.radius = kHalf;
        wire = w.wires().add(def);
        const ShapeId edge =
            w.add_shape({.kind = ShapeKind::cylinder,
                         .body = ship,
                         .orientation = Quat(std::sqrt(0.5), -std::sqrt(0.5), 0, 0),
                         .radius = kRadius,
                         .half_length = half_length,
                         .margin = 1.0});
        w.add(PostDef{.name = "edge", .shape = edge, .friction = friction, .slides = slides});
    }
    [[nodiscard]] double get(const char* signal) const {
        return w.system_signal(std::string("edge.") + signal);
    }
    void pull(const Vec3& force) { w.set_force(towed, force, Vec3::Zero()); }
    void run(double seconds) {
        for (int i = 0; i < std::lround(60.0 * seconds); ++i)
            ASSERT_EQ(w.step(), Status::ok) << w.time();
    }
    /// Lower the end over the edge, straight aft.
    void lower(double down = 6e4) {
        for (int i = 0; i < 600; ++i) {
            pull({1e5, 0, -down * i / 600.0});
            ASSERT_EQ(w.step(), Status::ok) << w.time();
        }
        pull({1e5, 0, -down});
        run(50.0);
        ASSERT_EQ(get("held"), 1.0);
    }
    /// Return the angles between the edge and the wire on both sides.
    [[nodiscard]] std::array<double, 2> angles() const {
        std::array<double, 2> out{};
        std::size_t k = 0;
        for (const InteractionId id : w.wires().elements(wire)) {
            if (!kind_info(w.interaction_def(id).kind).is(kAtGuide)) continue;
            const auto ends = w.wires().ends(id);
            out[k++] = std::acos((ends[1] - ends[0]).normalized().y());
        }
        EXPECT_EQ(k, 2U);
        return out;
    }
    /// Return ln tan(β₂/2) − ln tan(β₁/2).
    [[nodiscard]] double leaning() const {
        const auto b = angles();
        return std::log(std::tan(0.5 * b[1])) - std::log(std::tan(0.5 * b[0]));
    }
    /// Return the force of the wire on the edge over the normal force: across the axis, and across
    /// the wire in the surface.
    [[nodiscard]] double rub() const {
        Vec3 sum = Vec3::Zero(), along = Vec3::Zero();
        double sign = -1.0, pull = 0.0;
        for (const InteractionId id : w.wires().elements(wire)) {
            if (!kind_info(w.interaction_def(id).kind).is(kAtGuide)) continue;
            const auto ends = w.wires().ends(id);
            const Vec3 u = (ends[1] - ends[0]).normalized();
            sum += sign * u;
            along += u;
            pull -= 0.5 * w.force(id)[0];
            sign = 1.0;
        }
        sum *= pull;
        along.normalize();
        const Vec3 flat(sum.x(), 0.0, sum.z());
        const double sine = std::sqrt(1.0 - along.y() * along.y());
        return std::abs(sum.y()) / sine / flat.norm();
    }
};

TEST(Slides, StayToTheBitBelowTheBound) {
    Stern d(0.3);
    d.lower();
    const double bound = 0.3 * d.get("angle"), at = d.get("along"), slid = d.get("slid");
    // Pulled back and forth for 100 s; at rest it would slide, in motion it reaches about 90 % of
    // this.
    const double least = std::acos(std::tanh(1.05 * bound));
    double most = 0.0;
    for (int i = 0; i < 6000; ++i) {
        const double cot = std::sin(i / 600.0) / std::tan(least);
        d.pull({1e5, cot * std::hypot(1e5, 6e4), -6e4});
        ASSERT_EQ(d.w.step(), Status::ok);
        ASSERT_EQ(d.get("along"), at) << i;
        most = std::max(most, std::abs(d.leaning()));
    }
    std::printf("leant by up to %.4f of a bound of %.4f, went by %g m\n", most, bound,
                d.get("along") - at);
    EXPECT_EQ(d.get("slid"), slid);
    EXPECT_GT(most, 0.8 * bound) << "it was near";
}

TEST(Slides, LieAtCoulombsAngle) {
    HAWSER_SKIP_IF_SAMPLED();
    // Around half a radian, where a node's force differs from that of an arc, and around an eighth.
    for (const auto& [down, side] : {std::pair(6e4, 4e4), {6e4, -4e4}, {1.3e4, -2e4}})
        for (const double friction : {0.1, 0.3}) {
            Stern d(friction);
            d.lower(down);
            const Vec3 force(1e5, side, -down);
            d.pull(force);
            d.run(100.0);
            ASSERT_EQ(d.get("held"), 1.0);
            const double arc = d.get("angle"), bound = friction * arc;
            const auto b = d.angles();
            std::printf(
                "mu %.1f, round %.3f rad: at %.4f m, angles %.4f and %.4f rad: %.6f of mu "
                "phi, %.6f of mu by forces\n",
                friction, arc, d.get("along"), b[0], b[1], std::abs(d.leaning()) / bound,
                d.rub() / friction);
            // It came to rest at the φ of the last oscillation, about 1e-5 of it earlier.
            EXPECT_NEAR(std::abs(d.leaning()) / bound, 1.0, 1e-4);
            // The wire after the edge has the direction of the load's pull; the bollard and the
            // position of the body add some centimetres in 60 m.
            const double aft = std::acos(side / force.norm());
            EXPECT_NEAR(b[1], aft, 1e-3);
            const double fore = std::log(std::tan(0.5 * aft)) + (side > 0.0 ? bound : -bound);
            EXPECT_NEAR(b[0], 2.0 * std::atan(std::exp(fore)), 1e-3);
            // A node of an arc φ presses with T 2 sin(φ/2) instead of Tφ, and is held across its
            // mean direction, not by the law of each small piece. Both errors are of second order.
            EXPECT_NEAR(d.rub() / friction, 1.0, arc * arc / 12.0);
        }
}

TEST(Slides, GoTheShortestWayWithoutFriction) {
    HAWSER_SKIP_IF_SAMPLED();
    Stern d(0.0);
    d.lower();
    d.pull({1e5, 2e4, -6e4});
    d.run(120.0);
    const auto b = d.angles();
    std::printf("angles to the edge: %.9f and %.9f rad\n", b[0], b[1]);
    EXPECT_NEAR(b[0], b[1], 1e-6);
    EXPECT_NEAR(d.get("along"), Stern::kFore / std::tan(b[0]), 0.05);
    // This position has the shortest path between the nodes of all along the edge.
    EXPECT_EQ(d.w.verdict().grade, Grade::good);
}

TEST(Slides, OtherwiseKeepTheirPlace) {
    Stern d(0.1, 1, 7.0, false);
    d.lower();
    d.pull({1e5, 4e4, -6e4});
    d.run(60.0);
    EXPECT_GT(std::abs(d.leaning()), 2.0 * 0.1 * d.get("angle"));
    EXPECT_THROW((void)d.get("along"), DefError) << "of posts along which wires slide";
}

TEST(Slides, ComeOffAtTheEnd) {
    Stern d(0.1, 1, 2.0);
    d.lower();
    d.pull({1e5, 4e4, -6e4});
    double last = 0.0;
    for (int i = 0; i < 3600 && d.get("held") > 0.0; ++i) {
        last = d.get("along");
        ASSERT_EQ(d.w.step(), Status::ok) << i;
    }
    EXPECT_EQ(d.get("let_go"), 1.0);
    EXPECT_NEAR(std::abs(last), 2.0, 0.05);
    d.run(60.0);
    EXPECT_EQ(d.get("held"), 0.0);
    EXPECT_EQ(d.w.verdict().grade, Grade::good);
}

/// A body that swings from quarter to quarter: losses of sliding count as friction, and the account
/// is balanced. The row of friction along the wire stores F²ε/2 with 1e-12 m/N while it sticks,
/// which is part of it and returns as the pull decreases.
TEST(Slides, TakeEnergyAndMakeNone) {
    HAWSER_SKIP_IF_SAMPLED();
    for (const double friction : {0.0, 0.15, 0.3}) {
        Stern d(friction);
        d.lower();
        const double length = d.w.wires().length(d.wire);
        const InteractionId row = d.w.find_interaction("edge/1/friction");
        double taken = d.w.energy().friction, most = 0.0, strongest = 0.0;
        for (int i = 0; i < (test::kSanitized ? 900 : 3600); ++i) {
            d.pull({1e5, 6e4 * std::sin(i / 120.0), -6e4});
            const double speed = d.get("slid");
            ASSERT_EQ(d.w.step(), Status::ok) << i;
            const double now = d.w.energy().friction;
            strongest = std::max(strongest, std::abs(d.w.force(row)[0]));
            ASSERT_GE(now, taken - 0.5e-12 * strongest * strongest) << i;
            taken = std::max(taken, now);
            most = std::max(most, 60.0 * (d.get("slid") - speed));
        }
        std::printf("mu %.2f: slid %.1f m, up to %.3f m/s, took %.0f J of friction\n", friction,
                    d.get("slid"), most, taken);
        EXPECT_GT(d.get("slid"), test::kSanitized ? 0.0 : 0.4);
        EXPECT_EQ(d.w.verdict().grade, Grade::good) << friction;
        EXPECT_NEAR(d.w.wires().length(d.wire), length, 1e-9 * length);
    }
}

TEST(Slides, GiveTheSameBitsOnAnyThreadsAfterRestoringAndInTwins) {
    const auto hashes = [](int threads, int restored) {
        Stern d(0.15, threads);
        std::vector<std::uint64_t> out;
        for (int i = 0; i < 1500; ++i) {
            d.pull({1e5, i < 600 ? 0.0 : i < 1000 ? 5e4 : -5e4, -100.0 * std::min(i, 600)});
            EXPECT_EQ(d.w.step(), Status::ok);
            out.push_back(d.w.state().hash());
            if (i != restored) continue;
            const auto bytes = d.w.state().save();
            const Structure made_of = d.w.state().structure();
            Stern other(0.15, threads);
            other.w.state().restore(made_of, bytes);
            EXPECT_EQ(other.w.state().hash(), out.back());
            EXPECT_EQ(d.w.twin().state().hash(), out.back());
            d = std::move(other);
        }
        EXPECT_GT(d.get("slid"), 1.0);
        return out;
    };
    const auto one = hashes(1, -1);
    for (const int threads : {2, 4}) EXPECT_EQ(hashes(threads, -1), one) << threads;
    for (const int at : {650, 700, 900, 1050}) EXPECT_EQ(hashes(1, at), one) << at;
}

TEST(Slides, MoveByTheWorldsOwnFunctionAndRefuse) {
    Stern d(0.3);
    d.lower();
    InteractionId parts[2];
    std::size_t k = 0;
    for (const InteractionId id : d.w.wires().elements(d.wire))
        if (kind_info(d.w.interaction_def(id).kind).is(kAtGuide)) parts[k++] = id;
    ASSERT_EQ(k, 2U);
    EXPECT_THROW((void)d.w.wires().move_along(parts[1], parts[0], 0.1, 0.0), DefError)
        << "in this order";
    EXPECT_THROW((void)d.w.wires().move_along(parts[0], parts[1], 0.1, 1e3), DefError)
        << "so much length";
    EXPECT_THROW((void)d.w.wires().move_along(parts[0], parts[1], std::nan(""), 0.0), DefError);
    EXPECT_THROW((void)d.w.wires().move_along(parts[0], d.w.wires().elements(d.wire)[0], 0.1, 0.0),
                 DefError);
    // The shortest path is here: on both sides it is longer.
    const auto hash = d.w.state().hash();
    const Vec3 at = d.w.interaction_def(parts[0]).point[1];
    EXPECT_FALSE(d.w.wires().move_along(parts[0], parts[1], 0.5, 0.0));
    EXPECT_EQ(d.w.state().hash(), hash);
    EXPECT_EQ(d.w.interaction_def(parts[0]).point[1], at);
}

}  // namespace
}  // namespace hawser
