// SPDX-License-Identifier: Apache-2.0
/// Kernels of every instruction set that this processor has, compared with each other.
#include "factor/friction.h"
#include "factor/instruction_sets.h"
#include "factor/matrices.h"
#include "factor/minimum_degree.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace hawser::test {
namespace {

/// Factor and solve all fronts in order with one set of kernels.
Solved solve_with(const factor::Kernels& kernels, const BlockMatrix& m, const factor::Symbolic& s,
                  const Vector& b, const factor::Unsymmetric* set = nullptr) {
    const auto n = static_cast<std::size_t>(s.scalars);
    base::Array<double> panel(static_cast<std::size_t>(s.panel_size)), pivot(n + 8),
        // NaN: must never reach a result.
        work(static_cast<std::size_t>(s.work_size), std::numeric_limits<double>::quiet_NaN()),
        carry(s.rows.size() + 8),
        scratch(
            static_cast<std::size_t>(std::max(factor::scratch_size(s.max_front), s.batch_scratch)),
            std::numeric_limits<double>::quiet_NaN()),
        x(n + 8), slot_pivot(8 * s.slot_sign.size()), slot_y(8 * s.slot_sign.size());
    fill(m, s, panel.data());
    factor::FactorView view{s.fronts.data(),    s.children.data(),   s.rows.data(),
                            s.runs.data(),      s.sign.data(),       panel.data(),
                            pivot.data(),       work.data(),         work.data(),
                            s.stack_begin,      carry.data(),        s.batch_steps.data(),
                            s.slot_sign.data(), s.slot_index.data(), s.tail_slot.data(),
                            slot_pivot.data(),  slot_y.data(),       true};
    base::Array<double> upper, upper_work;
    std::vector<std::int8_t> wrong(n, 0);
    if (set != nullptr) {
        upper.assign(panel.begin(), panel.end());
        upper_work = work;
        scratch.resize(2 * scratch.size(), std::nan(""));
        fill_upper(m, s, upper.data(), [&](int v) { return in_set(s, *set, v); });
        view.unsymmetric = set->marks().data();
        view.upper = upper.data();
        view.upper_work = view.upper_stack = upper_work.data();
        view.wrong = wrong.data();
    }
    Solved out;
    const auto count = static_cast<std::int32_t>(s.fronts.size());
    for (const factor::Batch& batch : s.batches)
        out.wrong +=
            kernels.factor_batch(view, batch, batch.step_begin, batch.step_end, scratch.data());
    for (const factor::TaskRange& t : s.tasks)
        out.wrong += kernels.factor(view, t.begin, t.end, scratch.data());
    for (const std::int32_t f : s.top) out.wrong += kernels.factor(view, f, f + 1, scratch.data());
    const Vector y = permuted(m, s, b, false);
    std::copy(y.data(), y.data() + y.size(), x.begin());
    for (const factor::Batch& batch : s.batches)
        kernels.forward_batch(view, batch, batch.step_begin, batch.step_end, x.data(),
                              scratch.data());
    kernels.forward(view, 0, count, x.data(), scratch.data());
    kernels.backward(view, 0, count, x.data(), scratch.data());
    for (const factor::Batch& batch : s.batches)
        kernels.backward_batch(view, batch, x.data(), scratch.data());
    const Vector z = Eigen::Map<const Vector>(x.data(), s.scalars);
    out.x = permuted(m, s, z, true);
    return out;
}

TEST(InstructionSets, MoveLanes) {
    for (const Set& set : sets()) {
        if (!set.available) continue;
        const char* wrong = set.wrong_lanes();
        EXPECT_EQ(wrong, nullptr) << set.name << ": " << wrong;
    }
}

/// Rows of bits: each word by itself. Nodes of one to six weights, each with its row of bits.
TEST(InstructionSets, UniteRowsOfBits) {
    Random random(first_seed(3));
    const int rounds = by_tier(1, 4, 40);
    for (int round = 0; round < rounds; ++round)
        for (int words = 8; words <= factor::MinimumDegree::kMaximum / 64; words += 8)
            for (const Set& set : sets()) {
                if (!set.available) continue;
                constexpr std::size_t kRows = 6;
                const auto n = static_cast<std::size_t>(words);
                auto draw = [&](std::size_t size, double full) {
                    base::Array<std::uint64_t> row(size);
                    for (std::uint64_t& word : row)
                        for (int i = 0; i < 64; ++i)
                            word |= static_cast<std::uint64_t>(random.chance(full)) << i;
                    return row;
                };
                for (const double full : {0.0, 0.01, 0.5, 1.0}) {
                    base::Array<std::uint64_t> rows = draw(kRows * n, full);
                    const auto with = draw(n, full), among = draw(n, std::max(full, 0.9));
                    base::Array<std::uint64_t> expected = rows;
                    const std::int32_t nodes[] = {4, 0, 2};
                    factor::NodeWeights weights;
                    weights.least = random.integer(1, 6);
                    weights.count = random.integer(0, factor::NodeWeights::kMaximum);
                    base::Array<std::uint64_t> heavy(static_cast<std::size_t>(weights.count) * n);
                    std::vector<std::int32_t> weight_of(64 * n, weights.least);
                    for (std::int32_t c = 0; c < weights.count; ++c)
                        weights.more[c] = random.integer(1, 6);
                    for (std::size_t v = 0; v < weight_of.size(); ++v) {
                        const int c = random.integer(-1, weights.count - 1);
                        if (c < 0) continue;
                        heavy[static_cast<std::size_t>(c) * n + v / 64] |= std::uint64_t{1}
                                                                           << (v % 64);
                        weight_of[v] += weights.more[c];
                    }
                    weights.rows = heavy.data();
                    std::int32_t sizes[3], sums[3] = {};
                    std::uint64_t folds[3], words_of[3] = {};
                    for (int k = 0; k < 3; ++k)
                        for (std::size_t w = 0; w < n; ++w) {
                            std::uint64_t& word =
                                expected[static_cast<std::size_t>(nodes[k]) * n + w];
                            word = (word | with[w]) & among[w];
                            for (std::size_t i = 0; i < 64; ++i)
                                if ((word >> i & 1) != 0) sums[k] += weight_of[64 * w + i];
                            words_of[k] ^= word;
                        }
                    set.kernels->unite_rows(rows.data(), words, nodes, 3, with.data(), among.data(),
                                            weights, sizes, folds);
                    EXPECT_EQ(rows, expected) << set.name << " " << words;
                    for (int k = 0; k < 3; ++k) {
                        EXPECT_EQ(sizes[k], sums[k]) << set.name << " " << words;
                        EXPECT_EQ(folds[k], words_of[k]) << set.name << " " << words;
                    }
                }
            }
}

TEST(InstructionSets, AgreeWithTheReferenceAndEachOther) {
    for (const std::uint32_t seed : seeds(1, 10, 50, 500)) {
        Random random(seed);
        const BlockMatrix m =
            random_quasi_definite(random, random.integer(1, 45), random.uniform(0.02, 0.6));
        const factor::Symbolic s = factor::analyse(m.pattern, factor::order_nodes(m.pattern));
        const Vector b = random_matrix(random, m.scalars(), 1);
        const Vector want = reference(m, b);
        for (const Set& set : sets()) {
            if (!set.available) continue;
            const Solved got = solve_with(*set.kernels, m, s, b);
            EXPECT_EQ(got.wrong, 0) << set.name << " seed " << seed;
            // Condition about 1e3 and growth below 6e4, times 2⁻⁵³.
            EXPECT_LE((got.x - want).norm(), 1e-9 * want.norm()) << set.name << " seed " << seed;
        }
    }
}

/// Every width of pivots and of updates, which covers all remainders of vectors.
TEST(InstructionSets, EveryFrontShape) {
    for (const std::uint32_t seed : seeds(1, 1, 3, 30))
        for (int p = 1; p <= 20; ++p)
            for (int q = 0; q <= 18; q += 1 + q / 6) {
                SCOPED_TRACE(seed);
                Random random(seed + static_cast<std::uint64_t>(100 * p + q));
                std::vector<std::int8_t> size, sign;
                std::vector<std::pair<int, int>> edges;
                const int nodes = p + q;  // of one scalar, all coupled: any split into fronts is
                                          // valid
                for (int i = 0; i < nodes; ++i) {
                    size.push_back(1);
                    sign.push_back(random.chance(0.5) ? 1 : -1);
                    for (int j = 0; j < i; ++j)
                        if (i < p || j >= p || (i + j) % 3 != 0) edges.emplace_back(i, j);
                }
                BlockMatrix m = make_blocks(size, sign, edges);
                for (int i = 0; i < nodes; ++i)
                    m.dense(i, i) = 40.0 * sign[static_cast<std::size_t>(i)];
                for (const auto& [i, j] : edges)
                    m.dense(i, j) = m.dense(j, i) = random.uniform(-1, 1);
                std::vector<std::int32_t> order(static_cast<std::size_t>(nodes));
                for (int i = 0; i < nodes; ++i) order[static_cast<std::size_t>(i)] = i;
                const factor::Symbolic s = factor::analyse(m.pattern, order);
                const Vector b = random_matrix(random, m.scalars(), 1);
                factor::Unsymmetric all;
                all.reserve(s);
                all.find(s, order);
                for (const bool symmetric : {true, false}) {
                    if (!symmetric)
                        for (const auto& [i, j] : edges) m.dense(i, j) = random.uniform(-1, 1);
                    const Vector want = reference(m, b);
                    for (const Set& set : sets()) {
                        if (!set.available) continue;
                        const Solved got =
                            solve_with(*set.kernels, m, s, b, symmetric ? nullptr : &all);
                        EXPECT_EQ(got.wrong, 0) << set.name << " p " << p << " q " << q;
                        // Diagonally dominant: a few units in the last place.
                        EXPECT_LE((got.x - want).norm(), 1e-13 * want.norm())
                            << set.name << " p " << p << " q " << q;
                    }
                }
            }
}

/// Rows of a child that meet its parent in runs of every length, at every offset: pivots of the
/// parent, its update rows, and runs with both.
TEST(InstructionSets, EveryRunOfAChild) {
    constexpr int kChildren = 3, kClique = 48, kPivots = 30;
    for (const std::uint64_t seed : seeds(1, 1, 3, 30))
        for (int length = 1; length <= 19; ++length) {
            Random random(seed + static_cast<std::uint64_t>(length));
            const int nodes = kChildren + kClique + 1;
            std::vector<std::pair<int, int>> edges;
            for (int child = 0; child < kChildren; ++child)
                for (int i = 0; i < kClique; ++i)
                    if ((i + child) % (length + 1) != 0) edges.emplace_back(kChildren + i, child);
            for (int i = 0; i < kClique; ++i) {
                for (int j = 0; j < i; ++j) edges.emplace_back(kChildren + i, kChildren + j);
                // The last rows also have a neighbour of their own: update rows of the clique.
                if (i >= kPivots) edges.emplace_back(nodes - 1, kChildren + i);
            }
            const auto count = static_cast<std::size_t>(nodes);
            BlockMatrix m = make_blocks(std::vector<std::int8_t>(count, 1),
                                        std::vector<std::int8_t>(count, 1), edges);
            for (int i = 0; i < nodes; ++i) m.dense(i, i) = 100.0;
            for (const auto& [i, j] : edges) m.dense(i, j) = m.dense(j, i) = random.uniform(-1, 1);
            std::vector<std::int32_t> order(count);
            std::iota(order.begin(), order.end(), 0);
            const factor::Symbolic s = factor::analyse(m.pattern, order);
            const Vector b = random_matrix(random, m.scalars(), 1);
            factor::Unsymmetric all;
            all.reserve(s);
            all.find(s, order);
            for (const bool symmetric : {true, false}) {
                if (!symmetric)
                    for (const auto& [i, j] : edges) m.dense(i, j) = random.uniform(-1, 1);
                const Vector want = reference(m, b);
                for (const Set& set : sets()) {
                    if (!set.available) continue;
                    const Solved got =
                        solve_with(*set.kernels, m, s, b, symmetric ? nullptr : &all);
                    EXPECT_EQ(got.wrong, 0) << set.name << " length " << length;
                    // Diagonally dominant: a few units in the last place.
                    EXPECT_LE((got.x - want).norm(), 1e-13 * want.norm())
                        << set.name << " length " << length << " seed " << seed;
                }
            }
        }
}

/// Wires with every number of lanes in use: batches of one to eight chains, and more.
TEST(InstructionSets, Batches) {
    for (const std::uint32_t seed : seeds(1, 3, kSanitized ? 5 : 40, 200)) {
        Random random(seed);
        const BlockMatrix m = wires(random, 9, 12);
        const factor::Symbolic s = factor::analyse(m.pattern, factor::plan_elimination(m.pattern));
        const Vector b = random_matrix(random, m.scalars(), 1), want = reference(m, b);
        for (const Set& set : sets()) {
            if (!set.available) continue;
            const Solved got = solve_with(*set.kernels, m, s, b);
            EXPECT_EQ(got.wrong, 0) << set.name << " seed " << seed;
            EXPECT_LE((got.x - want).norm(), 1e-9 * want.norm()) << set.name << " seed " << seed;
        }
    }
}

/// Both families with unsymmetric blocks; every shape of front.
TEST(InstructionSets, Unsymmetric) {
    for (const std::uint32_t seed : seeds(1, kSanitized ? 8 : 20, kSanitized ? 8 : 80, 800)) {
        Random random(seed);
        BlockMatrix m = seed % 2 == 0 ? wires(random, 9, 12)
                                      : random_quasi_definite(random, random.integer(2, 45),
                                                              random.uniform(0.02, 0.6));
        const auto pairs = add_frictions(m, random, random.integer(1, 8));
        const factor::Symbolic s = factor::analyse(m.pattern, factor::plan_elimination(m.pattern));
        factor::Unsymmetric unsymmetric;
        unsymmetric.reserve(s);
        unsymmetric.find(s, columns_of(pairs));
        const Vector b = random_matrix(random, m.scalars(), 1);
        for (const Set& set : sets()) {
            if (!set.available) continue;
            const Solved got = solve_with(*set.kernels, m, s, b, &unsymmetric);
            EXPECT_EQ(got.wrong, 0) << set.name << " seed " << seed;
            // Growth below 1e4 times 2⁻⁵³.
            EXPECT_LE(backward_error(m, got.x, b), 1e-12) << set.name << " seed " << seed;
        }
    }
}

TEST(InstructionSets, AllCountWrongPivots) {
    Random random(3);
    BlockMatrix m = random_quasi_definite(random, 20, 0.2);
    for (double bad : {std::nan(""), HUGE_VAL, 0.0}) {
        BlockMatrix broken = m;
        broken.dense.row(4).setZero();
        broken.dense.col(4).setZero();
        broken.dense(4, 4) = bad;
        const factor::Symbolic s =
            factor::analyse(broken.pattern, factor::order_nodes(broken.pattern));
        for (const Set& set : sets()) {
            if (!set.available) continue;
            const Vector ones = Vector::Ones(m.scalars());
            EXPECT_GT(solve_with(*set.kernels, broken, s, ones).wrong, 0) << set.name << " " << bad;
        }
    }
}

}  // namespace
}  // namespace hawser::test
