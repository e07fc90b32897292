// SPDX-License-Identifier: Apache-2.0
/// Free ends that reach a guide run off it. Cuts leave no element at an end that is too short.
#include <hawser/guide.h>
#include <hawser/hawser.h>

#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace hawser::test {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kStep = 1.0 / 120.0, kRadius = 0.8, kDensity = 10.0, kElement = 2.0;
constexpr double kHanging = 2000.0;

/// A wire of 30 m attached to a deck runs 18 m to a roller and down to a weight.
struct OverEdge {
    World w{{.step = kStep}};
    BodyId deck{}, weight{};
    WireId wire{};
    Guide roller{};

    explicit OverEdge(double friction = 0.1, int threads = 1)
        : w({.step = kStep, .threads = threads}) {
        deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
        // Equal to the length of the path over the roller, so that it starts with almost no
        // tension.
        constexpr double kOver = 0.3, kDown = kElement - kOver - 0.5 * kPi * kRadius;
        WireDef def{.name = "wire", .from = deck};
        std::vector<Vec3> path;
        for (int k = 9; k >= 0; --k) path.push_back({-kOver - kElement * k, 0, kRadius});
        for (int k = 0; k < 6; ++k) path.push_back({kRadius, 0, -kDown - kElement * k});
        weight = w.add_body(
            {.name = "weight", .kind = BodyKind::lump, .position = path.back(), .mass = kHanging});
        def.to = weight;
        def.from_point = path.front();
        def.elements = static_cast<int>(path.size()) - 1;
        def.length = kElement * def.elements;
        def.EA = 5e7;
        def.mass_per_length = kDensity;
        def.axial_damping = 1.0;
        def.consistent_mass = true;
        def.path.assign(path.begin() + 1, path.end() - 1);
        wire = w.wires().add(def);
        GuideDef guide{.radius = kRadius, .friction = friction};
        guide.name = "roller";
        guide.wire = wire;
        guide.body = deck;
        roller = w.add(guide);
    }
};

TEST(FreeEnds, RunOffARollerAndFallWithWhatTheyHoldUp) {
    OverEdge r;
    for (int i = 0; i < 120; ++i) ASSERT_EQ(r.w.step(), Status::ok);
    const WireId piece = r.w.wires().cut(r.wire, 8.0);
    (void)r.w.events().take();
    int reported = 0, left = 0;
    for (int i = 0; i < 480; ++i) {
        ASSERT_EQ(r.w.step(), Status::ok)
            << i << ": " << to_string(r.w.verdict().judge) << " "
            << r.w.verdict().of(r.w.verdict().judge).value << " "
            << r.w.system_signal("roller.wire_before") << " angle "
            << r.w.system_signal("roller.angle") << " speed " << r.w.system_signal("roller.speed")
            << " v " << r.w.velocity(r.weight).linear.z();
        for (const Event& e : r.w.events().take())
            if (e.kind == EventKind::detach && e.body == r.deck) {
                ++reported;
                left = i;
            }
    }
    EXPECT_EQ(reported, 1);
    EXPECT_GT(left, 60) << "12 m have to run over it first";
    EXPECT_EQ(r.w.verdict().grade, Grade::good);
    // The roller is empty, and no material is lost.
    for (const InteractionId id : r.w.wires().elements(piece))
        EXPECT_EQ(r.w.interaction_def(id).kind, InteractionKind::Stretch);
    EXPECT_EQ(r.w.system_signal("roller.speed"), 0.0);
    EXPECT_NEAR(r.w.wires().length(piece), 22.0, 0.2) << "what lay round the roller";
    // From then on, all of it falls freely.
    const double fell = r.w.velocity(r.weight).linear.z();
    for (int i = 0; i < 60; ++i) ASSERT_EQ(r.w.step(), Status::ok);
    double momentum = 0.0, mass = 0.0;
    for (const BodyId id : r.w.wires().nodes(piece)) {
        mass += r.w.body_def(id).mass;
        momentum += r.w.body_def(id).mass * r.w.velocity(id).linear.z();
    }
    EXPECT_NEAR(mass, kHanging + 22.0 * kDensity, 0.01 * mass);
    EXPECT_LT(momentum / mass, fell - 0.9 * 60.0 * kStep * 9.81);
}

TEST(FreeEnds, GiveTheSameBitsOnAnyThreadsAndAfterRestoring) {
    OverEdge one(0.2, 1), two(0.2, 2);
    for (OverEdge* r : {&one, &two}) {
        for (int i = 0; i < 60; ++i) ASSERT_EQ(r->w.step(), Status::ok);
        (void)r->w.wires().cut(r->wire, 8.0);
        for (int i = 0; i < 60; ++i) ASSERT_EQ(r->w.step(), Status::ok);
    }
    std::vector<std::byte> saved;
    std::size_t parts = 0;
    int after = 0;
    for (int i = 0; i < 300; ++i) {
        ASSERT_EQ(one.w.step(), Status::ok);
        ASSERT_EQ(two.w.step(), Status::ok);
        ASSERT_EQ(one.w.state().hash(), two.w.state().hash()) << i;
        ++after;
        if (const std::size_t now = one.w.bodies().size() + one.w.interactions().size();
            now != parts) {
            parts = now;
            saved = one.w.state().save();
            after = 0;
        }
    }
    ASSERT_GT(after, 10);
    // A state belongs to a world of equal parts: start after the end has run off.
    two.w.state().restore(saved);
    for (int i = 0; i < after; ++i) ASSERT_EQ(two.w.step(), Status::ok);
    EXPECT_EQ(one.w.state().hash(), two.w.state().hash());
}

TEST(FreeEnds, CutsAnywhereLeaveNoShortElements) {
    std::mt19937 random(test::first_seed(5));
    const int cuts = test::by_tier(30, 100, 1000);
    std::uniform_real_distribution<double> anywhere(0.01, 1.0);
    for (int k = 0; k < cuts; ++k) {
        World w({.step = kStep});
        const BodyId post = w.add_body({.name = "post", .kind = BodyKind::fixed});
        const BodyId ball = w.add_body(
            {.name = "ball", .kind = BodyKind::lump, .position = {16, 0, -4}, .mass = 300.0});
        WireDef def{.name = "wire", .from = post, .to = ball, .elements = 10, .length = 20.0};
        def.EA = 2e7;
        def.mass_per_length = kDensity;
        def.axial_damping = 1.0;
        def.consistent_mass = true;
        const WireId wire = w.wires().add(def);
        for (int i = 0; i < 30; ++i) ASSERT_EQ(w.step(), Status::ok);
        const auto mass = [&] {
            double sum = 0.0;
            for (const BodyId id : w.bodies())
                if (w.body_def(id).kind == BodyKind::lump) sum += w.body_def(id).mass;
            return sum;
        };
        const double had = mass(), whole = w.wires().length(wire),
                     s = anywhere(random) * (whole - 0.02);
        const WireId piece = w.wires().cut(wire, s);
        // Within a thousandth of an element, a cut is at the node. Removing a node keeps tensions:
        // lengths change by the difference of strains.
        EXPECT_NEAR(w.wires().length(wire), s, 1.1e-3 * kElement) << k;
        EXPECT_NEAR(w.wires().length(wire) + w.wires().length(piece), whole, 2e-4) << k;
        // The bollard carries half of the element beside it, which becomes longer if a node is
        // removed.
        if (s > 1.3 * kElement) {
            EXPECT_NEAR(mass(), had, 1e-9 * had) << k;
        }
        for (const WireId id : {wire, piece}) {
            const auto elements = w.wires().elements(id);
            // Beside a body, a node is removed only if energy does not increase.
            if (elements.size() < 3) continue;
            for (const InteractionId e : elements)
                EXPECT_GE(w.interaction_def(e).get("length"), 0.2 * kElement) << k << " s " << s;
        }
        for (int i = 0; i < 120; ++i) ASSERT_EQ(w.step(), Status::ok) << k << " s " << s;
    }
}

}  // namespace
}  // namespace hawser::test
