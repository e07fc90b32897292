// SPDX-License-Identifier: Apache-2.0
/// The number of threads changes the distribution of the work, but no result.
#include "stepper/scenes.h"
#include "support/sanitizer.h"

#include <gtest/gtest.h>

#include <vector>

namespace hawser {
namespace {

std::uint64_t hash_after(const char* name, int threads, int steps) {
    scene::Options options;
    options.threads = threads;
    scene::Scene s = scene::load_file(std::string("scenes/") + name, options);
    for (int i = 0; i < steps; ++i)
        if (s.world.step() != Status::ok) return 0;
    return s.world.state().hash();
}

TEST(Threads, StateHashDoesNotDependOnThreads) {
    const int steps = test::kSanitized ? 6 : 60;
    const std::vector<int> counts = test::kSanitized ? std::vector{2, 3} : std::vector{2, 3, 4, 8};
    for (const char* name : {"anchor_lines.json", "mooring.json"}) {
        const std::uint64_t serial = hash_after(name, 1, steps);
        ASSERT_NE(serial, 0U);
        for (const int threads : counts)
            EXPECT_EQ(hash_after(name, threads, steps), serial) << name << " on " << threads;
    }
}

/// Collider, contacts and their iterations: two or more chunks of contacts.
TEST(Threads, StateHashDoesNotDependOnThreadsWithContacts) {
    const int steps = test::kSanitized ? 3 : 20;
    for (const char* name : {"wall_648.json", "chain_pile.json"}) {
        const std::uint64_t serial = hash_after(name, 1, steps);
        ASSERT_NE(serial, 0U);
        for (const int threads : {2, 4})
            EXPECT_EQ(hash_after(name, threads, steps), serial) << name << " on " << threads;
    }
}

}  // namespace
}  // namespace hawser
