// SPDX-License-Identifier: Apache-2.0
#include "assembly/strips.h"

#include "base/index.h"
#include "support/recipe.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace hawser::test {
namespace {

using assembly::RowBlocks;

/// Return the row block of every index, −1 if it has none. Fails if an index is in two row blocks.
template <class Ranges>
void mark(const Ranges& ranges, int strip, std::vector<int>& of) {
    for (const auto& r : ranges)
        for (std::int32_t i = r.begin; i < r.end; ++i) {
            EXPECT_EQ(of[at(i)], -1) << i;
            of[at(i)] = strip;
        }
}

/// Check that every item is in exactly one row block, and that no other row block touches its
/// private items.
void check(const context::StepContext& ctx) {
    const model::Interactions& in = ctx.model.interactions;
    const RowBlocks& strips = ctx.model.system.strips;
    std::vector<int> body(at(ctx.model.bodies.count()), -1), own(at(in.count()), -1);
    for (int s = 0; s < strips.count(); ++s) {
        mark(strips.bodies(s), s, body);
        mark(strips.interactions(s), s, own);
    }
    for (int g = 0; g < strips.groups(); ++g) mark(strips.shared(g), strips.count(), body);
    for (const int s : body) EXPECT_GE(s, 0);
    for (std::int32_t i = 0; i < in.count(); ++i) {
        ASSERT_GE(own[at(i)], 0);
        for (int b = 0; b < in.bodies[at(i)]; ++b) {
            const std::int32_t k = in.body[at(kMaxInteractionBodies * i + b)];
            if (ctx.model.bodies.dof(k) == 0) continue;
            EXPECT_TRUE(body[at(k)] == own[at(i)] || body[at(k)] == strips.count()) << k;
        }
    }
    for (int kind = 0; kind < kInteractionKindCount; ++kind) {
        const auto& ids = in.pool[at(kind)].ids;
        std::vector<int> entry(ids.size(), -1);
        for (int s = 0; s < strips.count(); ++s)
            for (const assembly::PoolRange& r : strips.pools(s))
                if (static_cast<int>(r.kind) == kind) mark(std::vector{r}, s, entry);
        for (std::size_t k = 0; k < ids.size(); ++k) EXPECT_EQ(entry[k], own[at(ids[k])]);
    }
}

TEST(RowBlocks, HoldEverythingOnce) {
    for (const std::uint32_t seed : seeds(1, 5, 20, 200))
        for (const int size : {1, 40, 400}) {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", size " + std::to_string(size));
            const auto ctx = mixed(seed, size).context();
            check(*ctx);
        }
}

/// A scene of bodies alone: the largest amount of work.
TEST(RowBlocks, AreLongerInLargeScenes) {
    auto blocks_of = [](std::size_t bodies) {
        RowBlocks strips;
        strips.build(std::vector<std::uint8_t>(bodies, 3), {}, model::Interactions{});
        return strips.count();
    };
    EXPECT_EQ(blocks_of(384), 1);
    EXPECT_EQ(blocks_of(32 * 384), 32);
    EXPECT_EQ(blocks_of(32 * 1000), 32);
    EXPECT_EQ(blocks_of(32 * 1536), 32);
    EXPECT_EQ(blocks_of(64 * 1536), 64);
}

TEST(RowBlocks, AreEmptyWithoutBodies) {
    RowBlocks strips;
    strips.build({}, {}, model::Interactions{});
    EXPECT_EQ(strips.count(), 0);
    EXPECT_EQ(strips.groups(), 0);
}

TEST(RowBlocks, ShareFewBodiesOfAWire) {
    const auto ctx = link_chain(2000).context();
    check(*ctx);
    const RowBlocks& strips = ctx->model.system.strips;
    EXPECT_GE(strips.count(), 8);
    std::int32_t shared = 0;
    for (int g = 0; g < strips.groups(); ++g)
        for (const auto& r : strips.shared(g)) shared += r.end - r.begin;
    // One or two per border.
    EXPECT_LE(shared, 2 * strips.count());
}

}  // namespace
}  // namespace hawser::test
