// SPDX-License-Identifier: Apache-2.0
/// Broken wires (context/wire_alerts.h, docs/theory/parting.md): checks beside the closed form of
/// `hawser validate wire_parting`.
#include <hawser/hawser.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace hawser::test {
namespace {

constexpr double kDense = 23.0, kStiff = 2.33e8, kTaut = 1e6;  // kg/m, N, N

/// Straight wires side by side, at 1 MN between fixed ends.
struct Taut {
    World w;
    std::vector<WireId> wire;
    Taut(int wires, int elements, double element, double damping, double step)
        : w({.step = step, .gravity = Vec3::Zero()}) {
        for (int k = 0; k < wires; ++k) {
            const double separation = elements * element * (1.0 + kTaut / kStiff);
            WireDef def;
            def.name = "wire" + std::to_string(k);
            def.from = w.add_body({.kind = BodyKind::fixed, .position = Vec3(0, 10.0 * k, 0)});
            def.to =
                w.add_body({.kind = BodyKind::fixed, .position = Vec3(separation, 10.0 * k, 0)});
            def.elements = elements;
            def.length = elements * element;
            def.EA = kStiff;
            def.mass_per_length = kDense;
            def.axial_damping = damping;
            wire.push_back(w.wires().add(def));
        }
    }
    [[nodiscard]] double speed(int k, int node) const {
        const BodyId id =
            w.wires().nodes(wire[static_cast<std::size_t>(k)])[static_cast<std::size_t>(node)];
        return w.velocity(id).linear.x();
    }
    void steps(int n) {
        for (int i = 0; i < n; ++i) ASSERT_EQ(w.step(), Status::ok);
    }
};

/// Nothing moves before the break, and no damper acts during the recoil.
TEST(WireRecoil, IsTheSameAtAnyDamping) {
    std::vector<double> reference;
    for (const double damping : {0.0, 0.1, 1.0, 10.0, kDefault}) {
        Taut t(1, 201, 5.0, damping, 1.0 / 60);
        t.steps(4);
        t.w.wires().part(t.w.wires().elements(t.wire[0])[100]);
        std::vector<double> now;
        for (int i = 0; i < 12; ++i) {
            t.steps(1);
            for (const int node : {40, 100, 101, 160}) now.push_back(t.speed(0, node));
        }
        // The wave has not reached the other ends yet.
        const double v = kTaut / std::sqrt(kStiff * kDense);
        EXPECT_NEAR(now[4 * 3 + 1], -v, 1e-3 * v);
        EXPECT_NEAR(now[4 * 3 + 2], v, 1e-3 * v);
        if (reference.empty()) reference = now;
        for (std::size_t i = 0; i < now.size(); ++i)
            EXPECT_NEAR(now[i], reference[i], 1e-6 * v) << damping << " number " << i;
    }
}

/// The wave is spread over some steps, so that the far end releases gradually: the piece as a whole
/// is slower than its end. The difference is the loss of a front of this width, smaller with
/// shorter steps.
TEST(WireRecoil, TheWholePieceIsSlowerThanItsEnd) {
    const double v = kTaut / std::sqrt(kStiff * kDense);
    double mean[2];
    for (const int fine : {0, 1}) {
        Taut t(1, 201, 5.0, 0.1, fine == 0 ? 1.0 / 60 : 1.0 / 240);
        t.steps(2);
        t.w.wires().part(t.w.wires().elements(t.wire[0])[100]);
        t.steps(fine == 0 ? 14 : 56);  // 0.23 s: the wave reached the end after 0.16 s
        double sum = 0.0;
        for (int node = 1; node <= 100; ++node) sum -= t.speed(0, node);
        mean[fine] = sum / 100.0 / v;
        EXPECT_NEAR(t.speed(0, 100), -v, 1e-3 * v);
    }
    EXPECT_NEAR(mean[0], 0.746, 2e-3);
    EXPECT_NEAR(mean[1], 0.875, 2e-3);
    // Half of the difference at a quarter of the step: the width is proportional to its square
    // root.
    EXPECT_NEAR((1.0 - mean[1]) / (1.0 - mean[0]), 0.5, 0.02);
}

/// Elements that break in the first step, or before it, recoil like others.
TEST(WireRecoil, BeginsBeforeTheFirstStepToo) {
    double speed[2];
    for (const int before : {0, 4}) {
        Taut t(1, 201, 5.0, 0.1, 1.0 / 60);
        t.steps(before);
        t.w.wires().part(t.w.wires().elements(t.wire[0])[100]);
        t.steps(6);
        speed[before == 0 ? 0 : 1] = t.speed(0, 100);
    }
    const double v = kTaut / std::sqrt(kStiff * kDense);
    EXPECT_NEAR(speed[1], -v, 1e-3 * v);
    // The start goes back by half a step first.
    EXPECT_NEAR(speed[0], -v, 2e-2 * v);
}

/// An intact wire is stepped as if it were alone, except for rounding of a solution refined for
/// all.
TEST(WireRecoil, LeavesOtherWiresAlone) {
    Taut with(2, 40, 5.0, 0.3, 1.0 / 60), without(2, 40, 5.0, 0.3, 1.0 / 60);
    for (Taut* t : {&with, &without}) {
        t->w.set_velocity(t->w.wires().nodes(t->wire[1])[20], {Vec3(0.5, 0.2, 0.0), Vec3::Zero()});
        t->steps(3);
    }
    with.w.wires().part(with.w.wires().elements(with.wire[0])[20]);
    for (int i = 0; i < 60; ++i) {
        with.steps(1);
        without.steps(1);
        for (int node = 1; node < 40; ++node)
            ASSERT_NEAR(with.speed(1, node), without.speed(1, node), 1e-9) << i << " node " << node;
    }
}

/// Dampers act again after the recoil: vibrations along the remaining wire decay like in a wire
/// that always had this length.
TEST(WireRecoil, EndsAndDampersActAgain) {
    double left[2];
    for (const bool parted : {true, false}) {
        Taut t(1, 41, 20.0, 0.02, 1.0 / 960);
        t.steps(2);
        // The last element breaks: the rest is attached to no body, and is held by hand.
        const auto nodes = t.w.wires().nodes(t.wire[0]);
        if (parted) t.w.wires().part(t.w.wires().elements(t.wire[0])[40]);
        t.steps(960);
        for (std::size_t i = 1; i < 41; ++i) {
            t.w.set_pose(nodes[i],
                         {Vec3(20.0 * static_cast<double>(i) * (1.0 + kTaut / kStiff), 0, 0),
                          Quat::Identity()});
            t.w.set_velocity(nodes[i], {Vec3::Zero(), Vec3::Zero()});
        }
        if (parted) t.w.set_force(nodes[40], Vec3(kTaut, 0, 0), Vec3::Zero());
        t.w.set_velocity(nodes[20], {Vec3(1.0, 0, 0), Vec3::Zero()});
        double sum = 0.0;
        for (int i = 0; i < 480; ++i) {
            t.steps(1);
            for (int node = 15; node < 26; ++node)
                if (i > 60 && i < 140) sum += std::pow(t.speed(0, node), 2);
        }
        left[parted ? 0 : 1] = sum;
    }
    EXPECT_NEAR(left[0] / left[1], 1.0, 0.02);
}

/// Saved at any step of the recoil, and continued in another world.
TEST(WireRecoil, IsSavedAndRestored) {
    const auto world = [] { return Taut(2, 60, 4.0, 0.1, 1.0 / 240); };
    Taut t = world();
    t.steps(5);
    t.w.wires().part(t.w.wires().elements(t.wire[0])[17]);
    std::vector<std::vector<std::byte>> saved;
    std::vector<std::uint64_t> hash;
    for (int i = 0; i < 40; ++i) {
        saved.push_back(t.w.state().save());
        hash.push_back(t.w.state().hash());
        t.steps(1);
    }
    Taut other = world();
    for (std::size_t i = 0; i < saved.size(); i += 3) {
        other.w.state().restore(saved[i]);
        for (std::size_t k = i; k < hash.size(); ++k) {
            ASSERT_EQ(other.w.state().hash(), hash[k]) << "saved at " << i << ", step " << k;
            other.steps(1);
        }
    }
    World copy = t.w.twin();
    EXPECT_EQ(copy.state().hash(), t.w.state().hash());
}

/// Edits beside it, and of the wire itself, do not end the recoil.
TEST(WireRecoil, GoesOnThroughEdits) {
    Taut t(1, 201, 5.0, 0.1, 1.0 / 60);
    t.steps(4);
    t.w.wires().part(t.w.wires().elements(t.wire[0])[100]);
    t.steps(1);
    (void)t.w.add_body({.kind = BodyKind::fixed});
    t.steps(1);
    t.w.wires().part(t.w.wires().elements(t.wire[0])[2]);
    (void)t.w.add_body({.kind = BodyKind::fixed});
    t.steps(4);
    const double v = kTaut / std::sqrt(kStiff * kDense);
    EXPECT_NEAR(t.speed(0, 100), -v, 5e-3 * v);
    EXPECT_NEAR(t.speed(0, 101), v, 5e-3 * v);
    EXPECT_EQ(t.w.verdict().grade, Grade::good);
}

}  // namespace
}  // namespace hawser::test
