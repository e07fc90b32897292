// SPDX-License-Identifier: Apache-2.0
/// Partial refactorisation if fronts become unsymmetric and symmetric again, and if pivots have the
/// wrong sign.
#include "factor/friction.h"
#include "factor/partial.h"
#include "runtime/tasks.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace hawser::test {
namespace {

using factor::DirtyParts;
using factor::Symbolic;
using factor::Unsymmetric;

/// Contacts that are added, removed and changed between factorisations of one structure.
class Sequence {
  public:
    Sequence(const BlockMatrix& m, base::Executor& executor) : base_(m), now_(m), at_(executor) {
        s_ = factor::analyse(m.pattern, factor::plan_elimination(m.pattern));
        factor::separate_updates(s_);
        part_.reserve(s_, executor.threads(), true);
        full_.reserve(s_, executor.threads(), true);
        set_.reserve(s_);
        dirty_.reserve(s_);
        fill_both(now_, s_, set_, part_, at_);
        EXPECT_EQ(part_.factor(s_, at_, &set_), 0);
    }

    /// Draw other contacts: old and new unsymmetric blocks are stale.
    void step(Random& random) {
        std::vector<std::int32_t> columns = columns_of(pairs_);
        now_ = base_;
        pairs_ = add_frictions(now_, random, random.integer(0, 4));
        set_.find(s_, columns_of(pairs_));
        for (const std::int32_t v : columns_of(pairs_)) columns.push_back(v);
        dirty_.find(s_, columns, &set_);
        EXPECT_LE(dirty_.flops, set_.flops);
        share_ = static_cast<double>(dirty_.flops) / static_cast<double>(set_.flops);
        part_.clear(s_, dirty_, at_);
        auto stale = [&](int v) { return dirty_.refill(s_, v); };
        fill_columns(now_, s_, part_.values(), stale);
        part_.copy_to_upper(s_, dirty_, set_, at_);
        fill_upper(now_, s_, part_.upper(), [&](int v) { return stale(v) && in_set(s_, set_, v); });
        EXPECT_EQ(part_.refactor(s_, dirty_, at_, &set_), 0);
        fill_both(now_, s_, set_, full_, at_);
        EXPECT_EQ(full_.factor(s_, at_, &set_), 0);
        EXPECT_TRUE(
            same_bits(entries_below(s_, part_.values()), entries_below(s_, full_.values())));
        EXPECT_TRUE(same_bits(solve_bits(s_, part_, at_, 5), solve_bits(s_, full_, at_, 5)));
    }

    [[nodiscard]] double share() const { return share_; }

  private:
    const BlockMatrix base_;
    BlockMatrix now_;
    base::Executor& at_;
    Symbolic s_;
    factor::Numeric part_, full_;
    Unsymmetric set_;
    DirtyParts dirty_;
    std::vector<std::pair<int, int>> pairs_;
    double share_ = 0.0;
};

TEST(Unsymmetric, PartialHasTheBitsOfAFullFactorisation) {
    base::SerialExecutor serial;
    runtime::Pool pool(3);
    pool.resume();
    double share = 0.0;
    constexpr int kSteps = 5;
    const auto all = seeds(1, kSanitized ? 10 : 18, kSanitized ? 10 : 60, 600);
    for (const std::uint32_t seed : all) {
        SCOPED_TRACE(seed);
        Random random(seed);
        base::Executor& executor = seed % 3 == 0 ? static_cast<base::Executor&>(pool) : serial;
        Sequence sequence(seed % 2 == 0 ? wires(random, 10, 40)
                                        : random_quasi_definite(random, random.integer(2, 80),
                                                                random.uniform(0.01, 0.1)),
                          executor);
        for (int step = 0; step < kSteps; ++step) {
            sequence.step(random);
            share += sequence.share() / (static_cast<double>(all.size()) * kSteps);
        }
        if (HasFailure()) return;
    }
    if (all.size() == 1) return;
    // A few of many contacts leave some of these small trees clean.
    EXPECT_LT(share, 0.95);
    EXPECT_GT(share, 0.01);
}

/// Set a node to two scalars whose second pivot is 1 − 2·2.
void break_pivot(BlockMatrix& m, int node) {
    m.block(node, node)(0, 1) = 2.0 * m.block(node, node)(0, 0);
    m.block(node, node)(1, 0) = 2.0 * m.block(node, node)(1, 1);
}

/// The node of a wrong pivot is reported, in fronts and in chains, and no longer after the next
/// factorisation.
TEST(Unsymmetric, NamesTheNodesOfWrongPivots) {
    base::SerialExecutor serial;
    int named = 0, in_chains = 0;
    const auto all = seeds(1, kSanitized ? 8 : 40, kSanitized ? 8 : 200, 2000);
    for (const std::uint32_t seed : all) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const BlockMatrix good = seed % 2 == 0
                                     ? wires(random, 6, 30)
                                     : random_quasi_definite(random, random.integer(2, 40), 0.1);
        const int node = random.integer(0, good.pattern.nodes() - 1);
        const auto v = static_cast<std::size_t>(node);
        if (good.pattern.size[v] < 2 || good.pattern.sign[v] < 0) continue;
        BlockMatrix bad = good;
        break_pivot(bad, node);
        const Symbolic s = factor::analyse(good.pattern, factor::plan_elimination(good.pattern));
        Unsymmetric set;
        set.reserve(s);
        const std::int32_t columns[] = {node};
        set.find(s, columns);
        factor::Numeric numeric;
        numeric.reserve(s, 1, true);
        fill_both(bad, s, set, numeric, serial);
        const int wrong = numeric.factor(s, serial, &set);
        const auto nodes = numeric.nodes_with_wrong_pivots();
        EXPECT_EQ(wrong > 0, !nodes.empty());
        EXPECT_LE(nodes.size(), static_cast<std::size_t>(std::max(wrong, 0)));
        // Nodes eliminated before it have valid pivots. The node may repair its own pivot; then a
        // later one is wrong.
        if (!nodes.empty()) {
            EXPECT_GE(s.position[static_cast<std::size_t>(nodes.front())], s.position[v]);
        }
        if (!nodes.empty() && nodes.front() == node) {
            ++named;
            in_chains += s.fronts[static_cast<std::size_t>(s.node_front[v])].batch >= 0;
        }
        fill_both(good, s, set, numeric, serial);
        EXPECT_EQ(numeric.factor(s, serial, &set), 0);
        EXPECT_TRUE(numeric.nodes_with_wrong_pivots().empty());
    }
    const int cases = static_cast<int>(all.size());
    if (cases < 40) return;
    EXPECT_GT(named, cases / 8);
    EXPECT_GT(in_chains, cases / 50);
}

TEST(Unsymmetric, NotANumberIsAWrongPivot) {
    base::SerialExecutor serial;
    Random random(5);
    BlockMatrix m = random_quasi_definite(random, 30, 0.1);
    m.block(7, 7)(0, 0) = std::numeric_limits<double>::quiet_NaN();
    const Symbolic s = factor::analyse(m.pattern, factor::plan_elimination(m.pattern));
    Unsymmetric set;
    set.reserve(s);
    const std::int32_t columns[] = {7};
    set.find(s, columns);
    factor::Numeric numeric;
    numeric.reserve(s, 1, true);
    fill_both(m, s, set, numeric, serial);
    EXPECT_GT(numeric.factor(s, serial, &set), 0);
    ASSERT_FALSE(numeric.nodes_with_wrong_pivots().empty());
    EXPECT_EQ(numeric.nodes_with_wrong_pivots().front(), 7);
}

}  // namespace
}  // namespace hawser::test
