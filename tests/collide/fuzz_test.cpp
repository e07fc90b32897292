// SPDX-License-Identifier: Apache-2.0
/// For arbitrary shapes and poses, stage collide returns contacts that a solver can use, or none.
#include "collide/site.h"
#include "support/random.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

namespace hawser::test {
namespace {

using collide::Contact;

ShapeDef any_shape(Random& random, bool moves) {
    ShapeDef d;
    const int last = moves ? 6 : 7;
    d.kind = static_cast<ShapeKind>(random.integer(0, last));
    if (moves && (d.kind == ShapeKind::plane || d.kind == ShapeKind::heightfield))
        d.kind = ShapeKind::hull;
    d.orientation = random.chance(0.5) ? Quat::Identity() : random.rotation();
    d.position = random.chance(0.5) ? Vec3::Zero().eval() : random.vector(0.5);
    d.radius = random.chance(0.1) ? 1e-6 : random.uniform(0.05, 0.6);
    d.half_length = random.uniform(0.05, 1.0);
    d.half_size = {random.uniform(0.05, 1.0), random.uniform(0.05, 1.0), random.uniform(0.05, 1.0)};
    if (d.kind == ShapeKind::hull)
        for (int i = 0; i < 8; ++i)
            d.vertices.push_back({i & 1 ? 0.5 : -0.5, i & 2 ? 0.4 : -0.4, i & 4 ? 0.3 : -0.3});
    if (d.kind == ShapeKind::mesh) {
        d.vertices = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}};
        d.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    }
    if (d.kind == ShapeKind::heightfield) {
        d.rows = d.columns = 4;
        d.cell = {0.7, 0.6};
        for (int i = 0; i < 16; ++i) d.heights.push_back(random.uniform(-0.2, 0.2));
    }
    return d;
}

/// Return a position from a small set, so that bodies coincide, lines cross, and faces are
/// coplanar.
Vec3 any_position(Random& random) {
    return {0.5 * random.integer(-2, 2), 0.5 * random.integer(-2, 2), 0.5 * random.integer(-2, 2)};
}

void fill(Site& site, Random& random) {
    for (int i = 0; i < 12; ++i) {
        const bool moves = random.chance(0.7);
        const auto b = site.body(moves ? BodyKind::rigid : BodyKind::fixed, any_position(random),
                                 random.vector(3.0), random.vector(3.0));
        for (int k = random.integer(1, 2); k > 0; --k) {
            ShapeDef d = any_shape(random, moves);
            d.body = BodyId{b};
            site.collider.add(d, site.bodies);
        }
    }
    std::vector<Vec3> nodes;
    for (int i = 0; i < 6; ++i) nodes.push_back(any_position(random));
    site.wire(nodes, 0.05, random.vector(50.0));
    site.prepare();
}

void expect_sound(const Site& site) {
    const Contact* before = nullptr;
    for (const Contact& c : site.set.contacts) {
        ASSERT_LT(c.shape[0], c.shape[1]);
        if (before != nullptr) {
            ASSERT_LT(std::tie(before->shape[0], before->shape[1], before->feature),
                      std::tie(c.shape[0], c.shape[1], c.feature))
                << "kinds "
                << static_cast<int>(
                       site.collider.shapes()[static_cast<std::size_t>(c.shape[0])].geometry.kind)
                << " "
                << static_cast<int>(
                       site.collider.shapes()[static_cast<std::size_t>(c.shape[1])].geometry.kind);
        }
        before = &c;
        ASSERT_TRUE(c.side_0 >= 1 && c.side_0 < c.slots && c.slots <= 4);
        double sum[2] = {0.0, 0.0};
        for (int s = 0; s < c.slots; ++s) {
            ASSERT_GE(c.body[s], 0);
            ASSERT_GE(c.weight[s], 1e-12);
            sum[s < c.side_0 ? 0 : 1] += c.weight[s];
        }
        // 1 − t and t add up to 1 within a rounding.
        ASSERT_NEAR(sum[0], 1.0, 1e-15);
        ASSERT_NEAR(sum[1], 1.0, 1e-15);
        const Eigen::Map<const Vec3> n(c.normal), a(c.on[0]), b(c.on[1]);
        ASSERT_NEAR(n.norm(), 1.0, 1e-9);
        ASSERT_TRUE(a.allFinite() && b.allFinite());
        ASSERT_NEAR((b - a).dot(n), c.gap, 1e-9);
        // Bodies are within 3 m of the centre, and 50 m/s is 0.8 m per step.
        ASSERT_LT(std::abs(c.gap), 10.0);
        ASSERT_LT(a.norm(), 10.0);
    }
}

TEST(Collider, AnythingAnywhereGivesSoundContacts) {
    const auto all = seeds(1, kSanitized ? 40 : 200, kSanitized ? 40 : 1000, 10'000);
    std::size_t contacts = 0;
    for (const std::uint32_t seed : all) {
        SCOPED_TRACE(seed);
        Random random(seed);
        Site site;
        fill(site, random);
        for (int step = 0; step < 3; ++step) {
            ASSERT_TRUE(site.collide());
            expect_sound(site);
            if (HasFatalFailure()) return;
            contacts += site.set.contacts.size();
            site.collider.keep();
            // Move bodies at once to other positions.
            for (const std::int32_t b : site.bodies.moving)
                if (random.chance(0.5)) {
                    const Vec3 to = any_position(random);
                    for (int k = 0; k < 3; ++k)
                        site.bodies.x[static_cast<std::size_t>(3 * b + k)] = to[k];
                }
        }
    }
    if (all.size() > 1) {
        EXPECT_GT(contacts, all.size() * 20);
    }
}

}  // namespace
}  // namespace hawser::test
