// SPDX-License-Identifier: Apache-2.0
/// Worlds edited at random while they run: equal bits for any number of threads and after a
/// restore; ids of removed objects are rejected.
#include <hawser/hawser.h>

#include "support/editor.h"
#include "support/sanitizer.h"
#include "support/tier.h"
#include "support/yard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace hawser::test {
namespace {

/// Return the number of steps of a world, each after five edits.
int edited_steps() { return kSanitized ? by_tier(60, 150, 2000) : by_tier(400, 2000, 2000); }

/// Worlds that differ only in threads.
struct Fleet {
    explicit Fleet(const std::vector<int>& threads) {
        for (const int n : threads) {
            WorldDef def{.threads = n, .on_diverged = OnDiverged::warn};
            def.sleep_after = 0.3;
            worlds.emplace_back(def);
        }
    }
    std::vector<World*> all() {
        std::vector<World*> out;
        for (World& w : worlds) out.push_back(&w);
        return out;
    }
    /// Step each world. @return status of the first; the others must agree with it in all bits.
    Status step() {
        const Status status = worlds[0].step();
        for (std::size_t k = 1; k < worlds.size(); ++k)
            EXPECT_EQ(worlds[k].step(), status) << worlds[k].settings().threads << " threads";
        compare();
        return status;
    }
    void compare() const {
        for (const World& w : worlds)
            EXPECT_EQ(w.state().hash(), worlds[0].state().hash())
                << w.settings().threads << " threads";
    }
    std::vector<World> worlds;
};

/// Let one world continue, restore it, and replace it by a twin restored from the same state.
void restore_one(Fleet& fleet, Editor& editor, std::size_t which) {
    World& w = fleet.worlds[which];
    const auto saved = w.state().save();
    for (int k = 0; k < 3; ++k) (void)w.step();
    const std::uint64_t later = w.state().hash();
    w.state().restore(saved);
    ASSERT_EQ(w.state().hash(), fleet.worlds[0].state().hash()) << "after restore()";
    for (int k = 0; k < 3; ++k) (void)w.step();
    ASSERT_EQ(w.state().hash(), later) << "the same steps again";
    w.state().restore(saved);
    World twin = w.twin();
    ASSERT_EQ(twin.state().hash(), fleet.worlds[0].state().hash()) << "of a twin";
    twin.state().restore(saved);
    ASSERT_EQ(twin.state().hash(), fleet.worlds[0].state().hash()) << "of a twin after restore()";
    w = std::move(twin);
    editor.replace(which, w);
}

void edit_at_random(std::uint32_t seed) {
    constexpr int kEdits = 5, kRestores = 20;
    const int steps = edited_steps();
    Fleet fleet({1, 2, 4, 8});
    Editor editor(seed, fleet.all());
    Random random(1000ULL + seed);
    std::vector<int> restores;
    for (int i = 0; i < kRestores; ++i) restores.push_back(random.integer(0, steps - 1));
    int failed = 0, contacts = 0, restored = 0;
    std::int64_t asleep = 0;
    for (int step = 0; step < steps; ++step) {
        SCOPED_TRACE("step " + std::to_string(step));
        for (int k = 0; k < kEdits; ++k) editor.edit();
        failed += fleet.step() == Status::ok ? 0 : 1;
        contacts += fleet.worlds[0].stats().contacts;
        asleep += fleet.worlds[0].stats().asleep;
        for (auto n = std::count(restores.begin(), restores.end(), step); n > 0; --n) {
            restore_one(fleet, editor, static_cast<std::size_t>(restored++) % fleet.worlds.size());
            if (testing::Test::HasFatalFailure()) return;
        }
        if (testing::Test::HasFailure()) break;
    }
    std::printf(
        "    seed %u: %d edits (%s) in %d steps, %d failed; %d restores; %d contacts and "
        "%lld sleepers looked at; hash %016llx on %zu numbers of threads\n",
        seed, editor.edits(), editor.summary().c_str(), steps, failed, restored, contacts,
        static_cast<long long>(asleep),
        static_cast<unsigned long long>(fleet.worlds[0].state().hash()), fleet.worlds.size());
    for (World& w : fleet.worlds)
        EXPECT_EQ(editor.accepted_removed_count(w), 0U) << "ids of what is gone";
    std::printf("    %zu ids of what was removed, all refused\n", editor.removed_count());
    EXPECT_EQ(restored, kRestores);
    EXPECT_GT(editor.removed_bodies().size(), static_cast<std::size_t>(steps) / 4);
    EXPECT_EQ(failed, 0);
    EXPECT_EQ(not_finite(fleet.worlds[0]), "");
}

TEST(RandomEdits, GiveTheSameBits) {
    const std::uint32_t first = first_seed(1);
    const std::uint32_t end = first + static_cast<std::uint32_t>(seed_count(1, 2, 5));
    for (std::uint32_t seed = first; seed < end && !HasFailure(); ++seed) edit_at_random(seed);
}

}  // namespace
}  // namespace hawser::test
