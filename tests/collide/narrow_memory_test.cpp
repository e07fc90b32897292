// SPDX-License-Identifier: Apache-2.0
/// The narrow phase allocates nothing. This executable replaces malloc by a function that counts on
/// request; operator new calls it.
#include "collide/collide_function.h"
#include "support/collide/random_pairs.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {
std::atomic<bool> narrow_counts{false};
std::atomic<long> narrow_allocations{0};
}  // namespace

extern "C" {
void* __libc_malloc(std::size_t);
void* malloc(std::size_t n) {
    if (narrow_counts.load(std::memory_order_relaxed)) narrow_allocations.fetch_add(1);
    return __libc_malloc(n);
}
}

namespace hawser {
namespace {

TEST(NarrowMemory, NoPairAllocates) {
    narrow_counts = true;
    delete new std::vector<int>(100);
    narrow_counts = false;
    EXPECT_GT(narrow_allocations.exchange(0), 0) << "the counter does not count";
    auto pairs = test::exact_pairs();
    const auto more = test::vertex_pairs();
    pairs.insert(pairs.end(), more.begin(), more.end());
    test::Random random(test::first_seed(1));
    const int cases = test::by_tier(50, 250, 2500);
    for (const auto& [a, b] : pairs) {
        const collide::Collide function = collide::collide_function(a, b);
        int touching = 0;
        for (int i = 0; i < cases; ++i) {
            const test::RandomShape s = test::random_shape(random, a);
            const test::RandomShape t = test::random_shape(random, b);
            const collide::Placement ps = test::random_placement(random, 0.7);
            const collide::Placement pt = test::random_placement(random, 0.7);
            collide::Manifold m;
            narrow_counts = true;
            function(s.geometry, ps, t.geometry, pt, 0.1, m);
            narrow_counts = false;
            touching += m.count > 0 ? 1 : 0;
        }
        EXPECT_EQ(narrow_allocations.exchange(0), 0)
            << test::kind_name(a) << " " << test::kind_name(b);
        EXPECT_GT(touching, 0);
    }
}

}  // namespace
}  // namespace hawser

#endif
