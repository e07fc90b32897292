// SPDX-License-Identifier: Apache-2.0
/// Wires are detected, cut into chains that do not touch each other, and assigned to lanes.
#include "factor/body_graph.h"
#include "factor/edited_graph.h"
#include "factor/matrices.h"
#include "factor/repair.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>

namespace hawser::test {
namespace {

/// Make `wire_count` wires of `length` bodies with ball joints; both ends are on a hub if `hubs`.
BlockMatrix ladder(int wire_count, int length, bool hubs) {
    std::vector<std::int8_t> size, sign;
    std::vector<std::pair<int, int>> edges;
    auto node = [&](int scalars, int s) {
        size.push_back(static_cast<std::int8_t>(scalars));
        sign.push_back(static_cast<std::int8_t>(s));
        return static_cast<int>(size.size()) - 1;
    };
    const int left = node(6, 1), right = node(6, 1);
    auto join = [&](int a, int b) {
        const int row = node(3, -1);
        edges.emplace_back(row, a);
        edges.emplace_back(row, b);
    };
    for (int w = 0; w < wire_count; ++w) {
        int before = hubs ? left : -1;
        for (int i = 0; i < length; ++i) {
            const int body = node(6, 1);
            if (before >= 0) join(before, body);
            before = body;
        }
        join(before, right);
    }
    BlockMatrix m = make_blocks(size, sign, edges);
    Random random(1);
    for (int i = 0; i < m.pattern.nodes(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        m.block(i, i) = definite(random, size[k], sign[k] > 0 ? 1.0 : 1e-9, sign[k]);
        for (std::int32_t j : m.pattern.neighbours(i))
            if (j > i)
                set_symmetric(m, i, j,
                              random_matrix(random, size[k], size[static_cast<std::size_t>(j)]));
    }
    return m;
}

int bodies_in_chains(const BlockMatrix& m, const factor::Chains& chains) {
    int n = 0;
    for (std::int32_t v : chains.nodes) n += m.pattern.sign[static_cast<std::size_t>(v)] > 0;
    return n;
}

TEST(Chains, FillEightLanesOfOneLongWire) {
    const BlockMatrix m = ladder(1, 203, true);
    const factor::Chains chains = factor::find_chains(m.pattern);
    EXPECT_EQ(chains.count(), 8);
    // Hubs with one neighbour are ends of wires: 205 bodies, seven separators.
    EXPECT_EQ(bodies_in_chains(m, chains), 198);
    for (int c = 0; c < chains.count(); ++c) {
        EXPECT_GE(chains.units(c), 24);
        EXPECT_LE(chains.units(c), 25);
    }
}

TEST(Chains, LeaveWiresWholeThatFillTheLanesAlready) {
    const BlockMatrix m = ladder(16, 60, false);
    const factor::Chains chains = factor::find_chains(m.pattern);
    EXPECT_EQ(chains.count(), 16);
    EXPECT_EQ(bodies_in_chains(m, chains), 16 * 60);
    // Start at the free end: no update is carried along.
    const factor::Symbolic s = factor::analyse(m.pattern, factor::plan_elimination(m.pattern));
    ASSERT_EQ(s.batches.size(), 2U);
    for (const factor::Batch& b : s.batches)
        EXPECT_EQ(s.batch_steps[static_cast<std::size_t>(b.step_begin)].q, 6);
}

/// A spine with a body beside every link: chains would carry all of them to their ends.
TEST(Chains, AreNotMadeWhereTheyWouldCarryMuch) {
    constexpr int kLinks = 800;
    std::vector<std::int8_t> size, sign;
    std::vector<std::int32_t> from, to;
    for (int i = 0; i < kLinks; ++i) {
        size.insert(size.end(), {6, 1});
        sign.insert(sign.end(), {1, 1});
        from.push_back(2 * i);
        to.push_back(2 * i + 1);
        if (i == 0) continue;
        from.push_back(2 * i - 2);
        to.push_back(2 * i);
    }
    const factor::Pattern pattern = factor::make_pattern(size, sign, from, to);
    const factor::Symbolic s = factor::analyse(pattern, factor::plan_elimination(pattern));
    for (const factor::Batch& b : s.batches) EXPECT_LE(b.max_q, 48);
    // Without chains: 800 fronts of 7 over 6. Lanes do up to eight times the flops in that time.
    EXPECT_LE(s.flops, factor::kLaneCount * kLinks * factor::front_flops(7, 6));
}

TEST(Chains, AreNotMadeOfSmallThings) {
    EXPECT_EQ(factor::find_chains(ladder(1, 5, true).pattern).count(), 0);
    EXPECT_EQ(factor::find_chains(factor::Pattern{{}, {}, {0}, {}}).count(), 0);
}

/// Check the preconditions of batches.h.
void check_chains(const BlockMatrix& m, const factor::Chains& chains) {
    const factor::Pattern& p = m.pattern;
    std::vector<int> chain_of(p.size.size(), -1), unit_of(p.size.size(), -1);
    for (int c = 0; c < chains.count(); ++c)
        for (std::int32_t u = chains.begin[static_cast<std::size_t>(c)];
             u < chains.begin[static_cast<std::size_t>(c) + 1]; ++u)
            for (std::int32_t v : chains.unit(u)) {
                ASSERT_EQ(chain_of[static_cast<std::size_t>(v)], -1) << "node twice";
                chain_of[static_cast<std::size_t>(v)] = c;
                unit_of[static_cast<std::size_t>(v)] = u;
            }
    for (int c = 0; c < chains.count(); ++c)
        for (std::int32_t u = chains.begin[static_cast<std::size_t>(c)];
             u < chains.begin[static_cast<std::size_t>(c) + 1]; ++u) {
            const auto unit = chains.unit(u);
            ASSERT_EQ(p.sign[static_cast<std::size_t>(unit[0])], 1);
            ASSERT_EQ(p.size[static_cast<std::size_t>(unit[0])],
                      chains.body_size[static_cast<std::size_t>(c)]);
            for (std::size_t i = 1; i < unit.size(); ++i)
                ASSERT_EQ(p.sign[static_cast<std::size_t>(unit[i])], -1);
            for (std::int32_t v : unit)
                for (std::int32_t w : p.neighbours(v)) {
                    const int other = chain_of[static_cast<std::size_t>(w)];
                    if (other < 0) {
                        // Rows with all bodies outside chains stay outside, and only those.
                        ASSERT_EQ(p.sign[static_cast<std::size_t>(w)], 1);
                        continue;
                    }
                    ASSERT_EQ(other, c) << "two chains touch";
                    const int far = std::abs(unit_of[static_cast<std::size_t>(w)] - u);
                    ASSERT_LE(far, chains.reach[static_cast<std::size_t>(c)]);
                }
        }
}

TEST(Chains, OfRandomWiresAreApartAndSolve) {
    int with_chains = 0, batches = 0;
    const auto all = seeds(1, kSanitized ? 10 : 20, kSanitized ? 10 : 120, 1000);
    for (const std::uint32_t seed : all) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const BlockMatrix m = wires(random, 14, 40);
        const factor::Elimination plan = factor::plan_elimination(m.pattern);
        check_chains(m, plan.chains);
        const factor::Symbolic s = factor::analyse(m.pattern, plan);
        with_chains += plan.chains.count() > 0;
        batches += static_cast<int>(s.batches.size());
        const Vector b = random_matrix(random, m.scalars(), 1);
        base::SerialExecutor serial;
        const Solved got = solve(m, s, b, serial);
        EXPECT_EQ(got.wrong, 0);
        EXPECT_LE(backward_error(m, got.x, b), 1e-12);  // growth below 1e4 times 2⁻⁵³
    }
    const int most = static_cast<int>(all.size());
    if (most == 1) return;
    EXPECT_GT(with_chains, most / 5);
    EXPECT_GT(batches, most * 2 / 5);
}

TEST(Chains, EveryEntryOfTheMatrixHasItsOwnPlace) {
    for (const std::uint32_t seed : seeds(1, 10, 40, 400)) {
        Random random(seed);
        const BlockMatrix m = wires(random, 14, 40);
        const factor::Symbolic s = factor::analyse(m.pattern, factor::plan_elimination(m.pattern));
        std::set<std::int64_t> taken;
        for (int row = 0; row < m.pattern.nodes(); ++row) {
            auto columns = std::vector<std::int32_t>(m.pattern.neighbours(row).begin(),
                                                     m.pattern.neighbours(row).end());
            columns.push_back(row);
            for (std::int32_t column : columns) {
                const auto r = static_cast<std::size_t>(row), c = static_cast<std::size_t>(column);
                if (s.position[c] > s.position[r]) continue;
                const factor::BlockTarget t = s.target(row, column);
                for (int i = 0; i < m.pattern.size[r]; ++i)
                    for (int j = 0; j < m.pattern.size[c]; ++j) {
                        const std::int64_t at = t.address + static_cast<std::int64_t>(i) * t.step +
                                                static_cast<std::int64_t>(j) * t.ld;
                        ASSERT_GE(at, 0);
                        ASSERT_LT(at, s.panel_size);
                        ASSERT_TRUE(taken.insert(at).second) << "seed " << seed;
                    }
            }
        }
    }
}

TEST(Chains, StraightAndPinnedStaysSolvable) {
    // Both ends are fixed and the compliance is 1e-9 of the mobility: so is the worst pivot.
    const BlockMatrix m = ladder(3, 80, true);
    Random random(2);
    const Vector b = random_matrix(random, m.scalars(), 1);
    const Solved got = solve(m, b);
    EXPECT_EQ(got.wrong, 0);
    EXPECT_LE(backward_error(m, got.x, b), 1e-6);  // before refinement: 1e-16 / 1e-9
}

/// A wire of ten bodies, and a chain of all of them that is eliminated in their order.
struct OneChain {
    factor::Pattern pattern;
    factor::Chains chains;
    std::vector<std::int32_t> position;
};

/// Make a chain in which bodies 5 and 6 share one row with body 4 and have no other coupling.
/// @param with_row  False: the row couples to body 4 only.
OneChain chain_with_three_body_row(bool with_row) {
    constexpr std::int32_t kBodies = 10, kRow = kBodies;
    std::vector<std::int8_t> size(kBodies, 6), sign(kBodies, 1);
    std::vector<std::int32_t> from, to;
    for (std::int32_t b = 1; b < kBodies; ++b) {
        if (b == 6) continue;
        from.push_back(b - 1);
        to.push_back(b);
    }
    size.push_back(3);
    sign.push_back(-1);
    for (std::int32_t b = 4; b <= (with_row ? 6 : 4); ++b) {
        from.push_back(kRow);
        to.push_back(b);
    }
    OneChain out;
    out.pattern = factor::make_pattern(size, sign, from, to);
    out.position.resize(kBodies + 1);
    for (std::int32_t b = 0; b < kBodies; ++b) {
        out.chains.nodes.push_back(b);
        if (b == 4) out.chains.nodes.push_back(kRow);  // its first body has the row
        out.chains.unit_begin.push_back(static_cast<std::int32_t>(out.chains.nodes.size()));
    }
    for (std::size_t k = 0; k < out.chains.nodes.size(); ++k)
        out.position[static_cast<std::size_t>(out.chains.nodes[k])] = static_cast<std::int32_t>(k);
    out.chains.begin.push_back(kBodies);
    out.chains.body_size.push_back(6);
    out.chains.reach.push_back(2);
    return out;
}

/// ChainFinder makes such chains. A saved state of them was refused.
TEST(Chains, FitIfARowOfThreeBodiesJoinsTwoUnits) {
    const OneChain one = chain_with_three_body_row(true);
    EXPECT_TRUE(factor::chains_fit(one.pattern, one.chains, one.position));
    const OneChain two = chain_with_three_body_row(false);
    EXPECT_FALSE(factor::chains_fit(two.pattern, two.chains, two.position));
}

/// The state of a plan is accepted after any edits.
TEST(Chains, OfEditedWiresFit) {
    int chains = 0;
    for (const std::uint32_t seed : seeds(1, 20, 400, 4000)) {
        Random random(seed);
        EditedGraph graph(wires(random, 10, 30).pattern);
        std::vector<std::int32_t> old_of_new;
        for (int i = 0; i < 12; ++i) {
            edit(graph, random, false);
            const factor::Pattern p = graph.pattern(old_of_new);
            factor::Analysis planned, resumed;
            planned.plan(p);
            chains += planned.elimination().chains.count();
            ASSERT_TRUE(resumed.resume(p, planned.state())) << seed << ", " << i;
            ASSERT_TRUE(resumed.symbolic() == planned.symbolic()) << seed << ", " << i;
        }
    }
    EXPECT_GT(chains, 0);
}

}  // namespace
}  // namespace hawser::test
