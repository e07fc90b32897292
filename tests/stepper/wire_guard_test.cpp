// SPDX-License-Identifier: Apache-2.0
/// Wires of nodes at steps that do not resolve their vibration (solve/wires.h, assembly/geo.h).
#include "support/random.h"
#include "support/recipe.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace hawser::test {
namespace {

/// A wire of point masses along x between two fixed ends, or with a free end that a force pulls.
struct WireRecipe {
    int elements = 20;
    double step = 1.0 / 60, length = 1.0, ratio = 8.0, stiffness = 200.0, bend = 0.1;
    double damping_time = 0.0, speed = 0.0;
    bool pulled = true, one_sided = true;
    unsigned seed = 1;
    static constexpr double kPull = 1e5;  ///< [N]
    /// Mass of a node: the ratio is h √(T l/m)/l.
    [[nodiscard]] double mass() const { return kPull * step * step / (ratio * ratio * length); }
    [[nodiscard]] Recipe make() const {
        Recipe r;
        Random random(seed);
        r.world.step = step;
        r.world.gravity = {0, 0, 0};
        r.world.staggered_start = false;  // the energy at the start is that of half a step before
        r.world.on_diverged = OnDiverged::warn;  // elements that rotate by a third of a radian in a
                                                 // step: bounded
        std::vector<BodyId> nodes;
        for (int i = 0; i <= elements; ++i) {
            const bool inner = i > 0 && i < elements;
            Vec3 x(i * length, 0, 0);
            if (inner) x += bend * length * Vec3(0, random.uniform(-1, 1), random.uniform(-1, 1));
            if (!inner && (i > 0 || !pulled)) {
                nodes.push_back(r.add({.kind = BodyKind::fixed, .position = x}));
                continue;
            }
            nodes.push_back(r.lump(x, mass()));
            BodyDef& node = r.bodies.back();
            if (inner)
                node.velocity = speed * Vec3(random.uniform(-1, 1), random.uniform(-1, 1),
                                             random.uniform(-1, 1));
            if (!inner) {
                node.mass = 6.0 * mass();
                node.force = {-kPull, 0, 0};
                const double drag = 0.08 * mass() / step;
                node.linear_damping = {drag, drag, drag};
            }
        }
        for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
            InteractionDef d = between(InteractionKind::Stretch, {nodes[i], nodes[i + 1]});
            d.set("length", length).set("EA", stiffness * kPull);
            d.set("tension_only", one_sided ? 1.0 : 0.0);
            d.damping_time[0] = damping_time;
            r.add(d);
        }
        return r;
    }
};

/// Return the energy created, over the initial and external energy, in a wire that may lose any.
double created(World& w, int steps) {
    w.prepare();
    const double start = w.energy().mechanical();
    double most = 0.0, scale = std::fabs(start) + 1e-300;
    for (int k = 0; k < steps; ++k) {
        if (w.step() != Status::ok) return 1e300;
        const Energy e = w.energy();
        scale = std::max({scale, std::fabs(e.applied), e.dissipated});
        most = std::max(most, e.mechanical() - start - e.applied + e.dissipated);
    }
    return most / scale;
}

/// A node between two elements under T, displaced sideways by 1 um: the recurrence of
/// assembly/geo.h.
TEST(WireGuard, SwingAcrossFollowsItsRecurrence) {
    for (const double ratio : {0.4, 2.0, 20.0}) {
        WireRecipe wire;
        wire.elements = 2;
        wire.ratio = ratio;
        wire.bend = 0.0;
        wire.pulled = false;
        wire.one_sided = false;
        Recipe r = wire.make();
        r.world.staggered_start = true;  // finds the tension, and keeps the velocity
        // Stretched: tension T in both.
        r.interactions[0].set("length", 1.0 / (1.0 + 1.0 / wire.stiffness));
        r.interactions[1].set("length", 1.0 / (1.0 + 1.0 / wire.stiffness));
        const double t =
            wire.stiffness * WireRecipe::kPull * (1.0 / r.interactions[0].get("length") - 1.0);
        r.bodies[1].position.y() = 1e-6;
        World w = r.make();
        const double h = wire.step, s = h * h * t / (wire.length * wire.mass());
        const double p = s > 0.25 ? (s - 0.25) / (s + 0.25) : 0.0;
        const double a = 0.25 + 0.25 * p, d = -0.1 * p;
        double y = 1e-6, v = 0.0, before = 0.0;
        for (int k = 0; k < 40; ++k) {
            ASSERT_EQ(w.step(), Status::ok);
            const double q = 2.0 * s;
            // w+ - w = -2 s y/h - q (a (w+ - w) + d (w+ - 2 w + w-)), s of both elements.
            const double next = ((1.0 + q * (a + 2.0 * d)) * v - q * d * before - 2.0 * s * y / h) /
                                (1.0 + q * (a + d));
            before = v;
            v = next;
            y += h * v;
            // Second order in the angle of 1e-6, times the axial stiffness.
            EXPECT_NEAR(w.pose(BodyId{1}).position.y(), y, 1e-12) << ratio << " step " << k;
        }
    }
}

/// Slack, taut or moved randomly, with any damping: no energy is created.
TEST(WireGuard, RandomWiresGainNoEnergy) {
    for (const std::uint32_t seed : seeds(1, 20, 100, 1000)) {
        Random random(seed + 1'000'000);
        WireRecipe wire;
        wire.seed = seed;
        wire.elements = 3 + static_cast<int>(random.uniform(0, 30));
        wire.ratio = std::exp(random.uniform(std::log(0.3), std::log(50.0)));
        wire.stiffness = std::exp(random.uniform(std::log(50.0), std::log(5000.0)));
        wire.bend = std::exp(random.uniform(std::log(1e-3), std::log(0.5)));
        wire.step = std::exp(random.uniform(std::log(1.0 / 240), std::log(0.5)));
        wire.damping_time = random.uniform(0, 1) < 0.5 ? 0.0 : random.uniform(0, 2.0 * wire.step);
        wire.speed =
            random.uniform(0, 1) < 0.5 ? 0.0 : random.uniform(0, 2.0) * wire.length / wire.step;
        wire.pulled = random.uniform(0, 1) < 0.7;
        wire.one_sided = random.uniform(0, 1) < 0.8;
        World w = wire.make().make();
        // Each step may create a thousandth of the exchanged energy (wires.h); most create none.
        EXPECT_LE(created(w, 100), 1e-2) << "seed " << seed << " ratio " << wire.ratio;
    }
}

WireRecipe lively() {
    WireRecipe wire;
    wire.elements = 150;  // several parts
    wire.bend = 0.3;
    wire.ratio = 2.0;
    wire.stiffness = 5000.0;
    return wire;
}

/// Bits do not depend on threads, and are equal after a restored snapshot while the guard has a
/// memory.
TEST(WireGuard, SameBitsForAnyThreadsAndAfterRestoring) {
    std::vector<std::uint64_t> hashes;
    std::vector<std::byte> snapshot;
    int repeats = 0;
    for (const int threads : {1, 2, 3, 4, 8}) {
        Recipe r = lively().make();
        r.world.threads = threads;
        World w = r.make();
        for (int k = 0; k < 120; ++k) {
            ASSERT_EQ(w.step(), Status::ok);
            repeats += w.stats().wire_repeats;
            if (threads == 1 && k == 30) snapshot = w.state().save();
            if (threads == 1 && k == 30) {
                EXPECT_GT(w.wires().damped_steps(InteractionId{0}), 0) << "nothing to remember";
            }
        }
        hashes.push_back(w.state().hash());
    }
    EXPECT_GT(repeats, 0);
    for (const std::uint64_t hash : hashes) EXPECT_EQ(hash, hashes.front());
    World again = lively().make().make();
    again.state().restore(snapshot);
    for (int k = 31; k < 120; ++k) ASSERT_EQ(again.step(), Status::ok);
    EXPECT_EQ(again.state().hash(), hashes.front());
}

/// Make boxes that slide into each other, which take several iterations per step; next to the wire
/// or alone.
World boxes_and(Recipe r, double budget_work) {
    r.world.gravity = {0, 0, -9.81};
    r.world.budget_work = budget_work;
    const BodyId ground = r.ground();
    std::vector<BodyId> boxes;
    for (int i = 0; i < 6; ++i) {
        boxes.push_back(
            r.rigid({0.1 * i, 20.0, 0.25 + 0.499 * i}, Quat::Identity(), 100.0, {10, 10, 10}));
        r.bodies.back().velocity = {i % 2 == 0 ? 1.5 : -0.5, 0.3 * i, 0.0};
    }
    World w = r.make();
    w.add_shape({.kind = ShapeKind::plane, .body = ground});
    for (const BodyId box : boxes)
        w.add_shape({.kind = ShapeKind::box, .body = box, .half_size = {0.5, 0.5, 0.25}});
    return w;
}
World wire_and_boxes(double budget_work) { return boxes_and(lively().make(), budget_work); }

/// A step that is solved again starts from the rejected solution. The wire does not touch the
/// balls, so that the first solve takes as many iterations for them as without a wire, and a repeat
/// fewer.
TEST(WireGuard, RepeatsStartFromTheRejectedSolution) {
    const auto heap = [](Recipe r) {
        r.world.gravity = {0, 0, -9.81};
        Random random(5);
        const BodyId ground = r.ground();
        std::vector<BodyId> balls;
        for (int i = 0; i < 60; ++i) {
            balls.push_back(
                r.rigid({0.19 * (i % 4), 20.0 + 0.19 * (i / 4 % 4), 0.1 + 0.19 * (i / 16)},
                        Quat::Identity(), random.uniform(1, 10), {0.04, 0.04, 0.04}));
            r.bodies.back().velocity = random.vector(2.0);
            r.bodies.back().angular_velocity = random.vector(10.0);
        }
        World w = r.make();
        w.add_shape({.kind = ShapeKind::plane, .body = ground});
        for (const BodyId ball : balls)
            w.add_shape({.kind = ShapeKind::sphere, .body = ball, .radius = 0.1});
        return w;
    };
    Recipe none;
    none.world = lively().make().world;
    World w = heap(lively().make()), alone = heap(none);
    int steps = 0, repeats = 0, first = 0, added = 0;
    for (int k = 0; k < 40; ++k) {
        ASSERT_EQ(w.step(), Status::ok);
        ASSERT_EQ(alone.step(), Status::ok);
        if (w.stats().wire_repeats == 0) continue;
        ++steps;
        repeats += w.stats().wire_repeats;
        first += alone.stats().newton_iterations;
        added += w.stats().newton_iterations - alone.stats().newton_iterations;
    }
    ASSERT_GT(steps, 10);
    EXPECT_GT(first, 5 * steps) << "first solves take too few iterations to compare";
    // Two, as the solution is known to the tolerance: the first has the laws about it.
    EXPECT_LE(added, 3 * repeats);
}

/// A budget may end any of the solutions of a step that is repeated for wires; the stored
/// degradation contains all of them.
TEST(WireGuard, StepsThatABudgetCutsAreRepeatedWithoutIt) {
    int cut = 0, later = 0;
    for (const double share : {1.5, 2.5, 3.5, 5.0, 7.0, 10.0}) {
        World whole = wire_and_boxes(0.0);
        ASSERT_EQ(whole.step(), Status::ok);
        World w = wire_and_boxes(share * static_cast<double>(whole.stats().factor_flops));
        World again = wire_and_boxes(0.0);
        for (int k = 0; k < 60; ++k) {
            ASSERT_EQ(w.step(), Status::ok);
            const StepStats& s = w.stats();
            cut += s.cut && s.wire_repeats > 0 ? 1 : 0;
            later += s.cut && s.wire_repeats > 0 && s.degradation.iterations > 3 ? 1 : 0;
            if (s.degradation.any()) again.solver().degrade_next_step(s.degradation);
            ASSERT_EQ(again.step(), Status::ok);
            ASSERT_EQ(again.state().hash(), w.state().hash()) << share << " step " << k;
        }
    }
    EXPECT_GT(cut, 10);
    EXPECT_GT(later, 0) << "none was cut in a repeat";
}

/// Resolved vibrations are not checked, and cost one factorisation.
TEST(WireGuard, ResolvedWiresAreLeftAlone) {
    WireRecipe wire;
    wire.ratio = 0.3;
    wire.bend = 0.01;
    World w = wire.make().make();
    for (int k = 0; k < 200; ++k) {
        ASSERT_EQ(w.step(), Status::ok);
        EXPECT_EQ(w.stats().wire_repeats, 0);
    }
}

}  // namespace
}  // namespace hawser::test
