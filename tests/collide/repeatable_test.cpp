// SPDX-License-Identifier: Apache-2.0
/// Stage collide gives the same bits for any number of threads, order of the last step, and boxes.
#include "base/hash.h"
#include "collide/site.h"
#include "collide/touch.h"
#include "support/random.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

namespace hawser::test {
namespace {

using collide::Contact;

bool in_order(const std::vector<Contact>& c) {
    for (std::size_t i = 1; i < c.size(); ++i)
        if (!(std::tie(c[i - 1].shape[0], c[i - 1].shape[1], c[i - 1].feature) <
              std::tie(c[i].shape[0], c[i].shape[1], c[i].feature)))
            return false;
    return true;
}

std::vector<Vec3> row(int count, const Vec3& from, const Vec3& step) {
    std::vector<Vec3> nodes;
    for (int i = 0; i < count; ++i) nodes.push_back(from + i * step);
    return nodes;
}

/// Scatter wires over a plane and over each other, with balls between.
void strew(Site& site, int wires, int nodes, std::uint32_t seed = 7) {
    Random random(seed);
    site.shape(ShapeKind::plane, site.body(BodyKind::fixed, Vec3::Zero()));
    for (int w = 0; w < wires; ++w) {
        const Vec3 from(random.uniform(0, 20), random.uniform(0, 20), random.uniform(0.02, 0.1));
        const double turn = random.uniform(0, 6.28);
        site.wire(row(nodes, from, 0.5 * Vec3(std::cos(turn), std::sin(turn), 0.0)), 0.05,
                  Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
    }
    for (int i = 0; i < 40; ++i)
        site.shape(ShapeKind::sphere,
                   site.body(BodyKind::rigid, {random.uniform(0, 20), random.uniform(0, 20), 0.3}),
                   0.3);
    site.prepare();
}

void drift(Site& site, double t) {
    for (const std::int32_t b : site.bodies.moving) {
        const auto v = static_cast<std::size_t>(site.bodies.dof_begin[static_cast<std::size_t>(b)]);
        site.move(b, t * Vec3(site.bodies.v[v], site.bodies.v[v + 1], site.bodies.v[v + 2]));
    }
}

std::uint64_t hash(const std::vector<Contact>& contacts) {
    std::uint64_t h = base::kFnvStart;
    for (const Contact& c : contacts) {
        for (const auto i : c.shape) h = base::fnv1a(&i, sizeof i, h);
        h = base::fnv1a(&c.feature, sizeof c.feature, h);
        h = base::fnv1a(&c.previous, sizeof c.previous, h);
        h = base::fnv1a(c.body, sizeof c.body, h);
        h = base::fnv1a(c.weight, sizeof c.weight, h);
        h = base::fnv1a(c.normal, sizeof c.normal, h);
        h = base::fnv1a(c.on, sizeof c.on, h);
        h = base::fnv1a(&c.gap, sizeof c.gap, h);
    }
    return h;
}

TEST(Collider, ThreadsChangeNoBit) {
    for (const std::uint32_t seed : seeds(7, 1, 4, 40)) {
        SCOPED_TRACE(seed);
        std::vector<std::uint64_t> first;
        for (const int threads : {1, 2, 4}) {
            Site site(threads);
            strew(site, 40, 20, seed);
            for (std::size_t step = 0; step < 30; ++step) {
                ASSERT_TRUE(site.collide());
                EXPECT_TRUE(in_order(site.set.contacts));
                EXPECT_GT(site.set.contacts.size(), 100U);
                const std::uint64_t now = hash(site.set.contacts);
                if (threads == 1)
                    first.push_back(now);
                else
                    ASSERT_EQ(now, first[step]) << threads << " threads, step " << step;
                site.collider.keep();
                drift(site, site.h);
            }
        }
    }
}

TEST(Collider, TheOrderOfTheLastStepChangesNoBit) {
    Site warm;
    strew(warm, 40, 20);
    for (int step = 0; step < 20; ++step) {
        ASSERT_TRUE(warm.collide());
        warm.collider.keep();
        drift(warm, warm.h);
    }
    Site cold;
    strew(cold, 40, 20);
    cold.bodies.x = warm.bodies.x;
    cold.prepare();
    cold.collider.last_contacts() = warm.collider.last_contacts();
    ASSERT_TRUE(warm.collide());
    ASSERT_TRUE(cold.collide());
    EXPECT_EQ(hash(cold.set.contacts), hash(warm.set.contacts));
    EXPECT_GT(cold.set.contacts.size(), 100U);
}

void expect_all_pairs(std::uint32_t seed) {
    Site site;
    strew(site, 20, 10, seed);
    ASSERT_TRUE(site.collide());
    collide::Filter filter;
    filter.build(site.collider.shapes(), site.bodies.count(), site.interactions);
    // Test every pair, without boxes.
    std::vector<Contact> all;
    std::vector<Contact> some(collide::kMaxManifold);
    const auto& shapes = site.collider.shapes();
    const auto& placed = site.collider.placed();
    for (std::size_t a = 0; a < shapes.size(); ++a)
        for (std::size_t b = a + 1; b < shapes.size(); ++b) {
            if (!filter.may_touch(static_cast<int>(a), static_cast<int>(b))) continue;
            const int n = collide::touch(
                shapes[a], placed[a], shapes[b], placed[b], site.h, site.collider.margin,
                filter.share_host(static_cast<int>(a), static_cast<int>(b)), some.data());
            for (int k = 0; k < n; ++k) {
                some[static_cast<std::size_t>(k)].shape[0] = static_cast<int>(a);
                some[static_cast<std::size_t>(k)].shape[1] = static_cast<int>(b);
                all.push_back(some[static_cast<std::size_t>(k)]);
            }
        }
    std::vector<Contact> expected;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (!collide::is_duplicate(all, i, shapes)) expected.push_back(all[i]);
    EXPECT_LT(expected.size(), all.size());
    EXPECT_EQ(hash(site.set.contacts), hash(expected));
}

TEST(Collider, FindsWhatAllPairsGive) {
    for (const std::uint32_t seed : seeds(7, 2, 10, 100)) {
        SCOPED_TRACE(seed);
        expect_all_pairs(seed);
    }
}

TEST(Collider, AWarmStepDoesNotGrow) {
    Site site(2);
    strew(site, 40, 20);
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(site.collide());
        site.collider.keep();
    }
    const auto before = site.collider.growth_count();
    EXPECT_GT(before, 0);
    for (int i = 0; i < 10; ++i) {
        ASSERT_TRUE(site.collide());
        site.collider.keep();
    }
    EXPECT_EQ(site.collider.growth_count(), before);
}

}  // namespace
}  // namespace hawser::test
