// SPDX-License-Identifier: Apache-2.0
/// A partial refactorisation gives the bits of a full one, and does no more work than it reports.
#include "factor/partial.h"
#include "factor/friction.h"
#include "factor/matrices.h"
#include "runtime/tasks.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace hawser::test {
namespace {

using factor::DirtyParts;
using factor::Symbolic;

/// Fill only the blocks of columns that need new values.
void refill(const BlockMatrix& m, const Symbolic& s, const DirtyParts& dirty, double* values) {
    fill_columns(m, s, values, [&](int column) { return dirty.refill(s, column); });
}

/// Set new values for a random set of blocks. @return their columns.
std::vector<std::int32_t> change(BlockMatrix& m, const Symbolic& s, Random& random, int count) {
    std::vector<std::int32_t> columns;
    for (int k = 0; k < count; ++k) {
        const int a = random.integer(0, m.pattern.nodes() - 1);
        const auto near = m.pattern.neighbours(a);
        if (near.empty() || random.chance(0.4)) {
            m.block(a, a) *= random.uniform(1.0, 1.1);
            columns.push_back(a);
        } else {
            const std::int32_t b = near[static_cast<std::size_t>(
                random.integer(0, static_cast<int>(near.size()) - 1))];
            const Matrix value = random.uniform(0.9, 1.0) * m.block(a, b);
            set_symmetric(m, a, b, value);
            columns.push_back(DirtyParts::column(s, a, b));
        }
    }
    return columns;
}

/// Compare L bit for bit, and D through a solution.
void expect_same_bits(const BlockMatrix& m, const Symbolic& s, factor::Numeric& part,
                      factor::Numeric& full, base::Executor& executor, Random& random) {
    const std::vector<double> l = entries_below(s, part.values());
    const std::vector<double> want = entries_below(s, full.values());
    EXPECT_EQ(std::memcmp(l.data(), want.data(), sizeof(double) * l.size()), 0);
    Vector x = random_matrix(random, m.scalars() + 8, 1);
    Vector y = x;
    part.solve(s, x.data(), executor);
    full.solve(s, y.data(), executor);
    EXPECT_EQ(
        std::memcmp(x.data(), y.data(), sizeof(double) * static_cast<std::size_t>(m.scalars())), 0);
}

/// Factor a sequence of changes partially and fully. @return fraction of the flops.
double compare_sequence(BlockMatrix m, Random& random, base::Executor& executor, int steps) {
    Symbolic s = factor::analyse(m.pattern, factor::plan_elimination(m.pattern));
    factor::separate_updates(s);
    factor::Numeric part, full;
    part.reserve(s, executor.threads());
    full.reserve(s, executor.threads());
    part.clear(s, executor);
    fill(m, s, part.values());
    EXPECT_EQ(part.factor(s, executor), 0);
    DirtyParts dirty;
    dirty.reserve(s);
    double flops = 0.0;
    for (int step = 0; step < steps; ++step) {
        const std::vector<std::int32_t> columns =
            change(m, s, random, step == 0 ? 0 : random.integer(1, 1 + m.pattern.nodes() / 10));
        dirty.find(s, columns);
        EXPECT_LE(dirty.flops, s.flops);
        if (columns.empty()) {
            EXPECT_EQ(dirty.flops, 0);
        }
        flops += static_cast<double>(dirty.flops);
        part.clear(s, dirty, executor);
        refill(m, s, dirty, part.values());
        EXPECT_EQ(part.refactor(s, dirty, executor), 0);
        full.clear(s, executor);
        fill(m, s, full.values());
        EXPECT_EQ(full.factor(s, executor), 0);
        expect_same_bits(m, s, part, full, executor, random);
    }
    return s.flops > 0 ? flops / (static_cast<double>(s.flops) * steps) : 0.0;
}

TEST(Partial, HasTheBitsOfAFullFactorisation) {
    base::SerialExecutor serial;
    runtime::Pool pool(3);
    pool.resume();
    double share = 0.0;
    const auto all = seeds(1, kSanitized ? 12 : 24, kSanitized ? 12 : 80, 800);
    for (const std::uint32_t seed : all) {
        SCOPED_TRACE(seed);
        Random random(seed);
        base::Executor& executor = seed % 3 == 0 ? static_cast<base::Executor&>(pool) : serial;
        const BlockMatrix m = seed % 2 == 0 ? wires(random, 10, 40)
                                            : random_quasi_definite(random, random.integer(1, 80),
                                                                    random.uniform(0.01, 0.1));
        share += compare_sequence(m, random, executor, 5) / static_cast<double>(all.size());
        if (HasFailure()) return;
    }
    if (all.size() == 1) return;
    // One in ten blocks changed at random leaves some of these small trees clean.
    EXPECT_LT(share, 0.95);
    EXPECT_GT(share, 0.01);
}

/// On a long wire in ordinary fronts, a change near the root costs a few fronts.
TEST(Partial, DoesOnlyThePathToTheRoot) {
    constexpr int kNodes = 400;
    std::vector<std::int8_t> size(kNodes, 6), sign(kNodes, 1);
    std::vector<std::int32_t> from, to, order(kNodes);
    for (int i = 1; i < kNodes; ++i) {
        from.push_back(i - 1);
        to.push_back(i);
    }
    std::iota(order.begin(), order.end(), 0);
    const factor::Pattern pattern = factor::make_pattern(size, sign, from, to);
    Symbolic s = factor::analyse(pattern, order);
    factor::separate_updates(s);
    DirtyParts dirty;
    dirty.reserve(s);
    const std::int32_t last[] = {kNodes - 1, kNodes - 1}, first[] = {0};
    dirty.find(s, last);
    EXPECT_EQ(dirty.fronts,
              std::vector<std::int32_t>{static_cast<std::int32_t>(s.fronts.size()) - 1});
    EXPECT_LT(dirty.flops * 20, s.flops);
    dirty.find(s, first);
    EXPECT_EQ(dirty.fronts.size(), s.fronts.size());
    EXPECT_EQ(dirty.flops, s.flops);
    ASSERT_EQ(dirty.panels.size(), 1U);
    EXPECT_EQ(dirty.panels[0].begin, 0);
    EXPECT_EQ(dirty.panels[0].end, s.panel_size - 64);
}

/// A batch is one unit of work, but the parents of its clean chains stay clean.
TEST(Partial, DoesABatchWhole) {
    Random random(3);
    std::vector<std::int8_t> size, sign;
    std::vector<std::pair<int, int>> edges;
    std::vector<int> first;
    for (int wire = 0; wire < 8; ++wire) {
        // Each wire is on its own hub: eight trees.
        const int hub = static_cast<int>(size.size());
        first.push_back(hub + 1);
        for (int i = 0; i < 61; ++i) {
            size.push_back(6);
            sign.push_back(1);
            if (i > 0) edges.emplace_back(i == 1 ? hub : hub + i - 1, hub + i);
        }
        // Hubs have many neighbours: add them.
        for (int i = 0; i < 12; ++i) {
            size.push_back(2);
            sign.push_back(1);
            edges.emplace_back(hub, static_cast<int>(size.size()) - 1);
        }
    }
    const BlockMatrix m = make_blocks(size, sign, edges);
    Symbolic s = factor::analyse(m.pattern, factor::plan_elimination(m.pattern));
    ASSERT_EQ(s.batches.size(), 1U);
    factor::separate_updates(s);
    DirtyParts dirty;
    dirty.reserve(s);
    const std::int32_t columns[] = {first[2] + 20};
    dirty.find(s, columns);
    EXPECT_EQ(dirty.batches, std::vector<std::int32_t>{0});
    const std::int32_t batch_front = s.node_front[static_cast<std::size_t>(columns[0])];
    EXPECT_FALSE(dirty.fronts.empty());
    for (const std::int32_t f : dirty.fronts) {
        std::int32_t up = batch_front;
        while (up >= 0 && up != f) up = s.fronts[static_cast<std::size_t>(up)].parent;
        EXPECT_EQ(up, f) << "not an ancestor of the changed chain";
    }
}

/// A pivot that becomes wrong is reported by the part that computes it.
TEST(Partial, ReportsWrongPivots) {
    Random random(5);
    base::SerialExecutor serial;
    BlockMatrix m = random_quasi_definite(random, 30, 0.1);
    Symbolic s = factor::analyse(m.pattern, factor::plan_elimination(m.pattern));
    factor::separate_updates(s);
    factor::Numeric numeric;
    numeric.reserve(s, 1);
    numeric.clear(s, serial);
    fill(m, s, numeric.values());
    ASSERT_EQ(numeric.factor(s, serial), 0);
    m.block(7, 7)(0, 0) = std::numeric_limits<double>::quiet_NaN();
    DirtyParts dirty;
    dirty.reserve(s);
    const std::int32_t columns[] = {7};
    dirty.find(s, columns);
    numeric.clear(s, dirty, serial);
    refill(m, s, dirty, numeric.values());
    EXPECT_GT(numeric.refactor(s, dirty, serial), 0);
}

}  // namespace
}  // namespace hawser::test
