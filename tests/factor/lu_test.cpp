// SPDX-License-Identifier: Apache-2.0
/// K = L D U on the fronts of LDLᵀ: solutions, mixed sets, wrong pivots.
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

using factor::Symbolic;
using factor::Unsymmetric;

/// Matrices of both families, with friction on some pairs.
struct FrictionCase {
    BlockMatrix m;
    std::vector<std::pair<int, int>> pairs;

    FrictionCase(Random& random, std::uint32_t seed, int most)
        : m(seed % 2 == 0
                ? wires(random, 10, 40)
                : random_quasi_definite(random, random.integer(2, 60), random.uniform(0.02, 0.2))),
          pairs(add_frictions(m, random, random.integer(0, most))) {}
};

Unsymmetric find_set(const Symbolic& s, const std::vector<std::int32_t>& columns) {
    Unsymmetric set;
    set.reserve(s);
    set.find(s, columns);
    return set;
}

TEST(Unsymmetric, SolvesWhatADenseFactorisationSolves) {
    base::SerialExecutor serial;
    int mixed = 0, batches = 0, contacts = 0, compared = 0;
    const auto all = seeds(1, kSanitized ? 16 : 24, kSanitized ? 16 : 100, 1000);
    for (const std::uint32_t seed : all) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const FrictionCase c(random, seed, 12);
        const Symbolic s = factor::analyse(c.m.pattern, factor::plan_elimination(c.m.pattern));
        const Unsymmetric set = find_set(s, columns_of(c.pairs));
        factor::Numeric numeric;
        numeric.reserve(s, 1, true);
        fill_both(c.m, s, set, numeric, serial);
        ASSERT_EQ(numeric.factor(s, serial, &set), 0);
        EXPECT_TRUE(numeric.nodes_with_wrong_pivots().empty());
        const Vector b = random_matrix(random, c.m.scalars(), 1);
        Vector y = Vector::Zero(b.size() + 8);
        y.head(b.size()) = permuted(c.m, s, b, false);
        numeric.solve(s, y.data(), serial);
        const Vector x = permuted(c.m, s, y.head(b.size()), true);
        EXPECT_LE(backward_error(c.m, x, b), 1e-12);  // growth below 1e4 times 2⁻⁵³
        if (c.m.scalars() < 300) {                    // dense in long double is slow
            const Vector want = reference(c.m, b);
            EXPECT_LE((x - want).norm(), 1e-9 * want.norm());  // condition about 1e3 in addition
            ++compared;
        }
        const std::size_t marked = set.fronts.size();
        mixed += marked > 0 && marked < s.fronts.size();
        batches += static_cast<int>(set.batches.size());
        contacts += static_cast<int>(c.pairs.size());
    }
    const int cases = static_cast<int>(all.size());
    if (cases == 1) return;
    EXPECT_GT(mixed, cases / 4);
    EXPECT_GT(batches, cases / 8);
    EXPECT_GT(contacts, cases);
    EXPECT_GT(compared, cases / 4);
}

/// For symmetric values the second half equals the first bit by bit, and the first equals LDLᵀ.
/// Partial refactorisation needs this if some lanes of a batch are symmetric.
TEST(Unsymmetric, OfSymmetricValuesHasTheBitsOfTheSymmetric) {
    base::SerialExecutor serial;
    for (const std::uint32_t seed : seeds(1, kSanitized ? 6 : 12, kSanitized ? 6 : 40, 400)) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const FrictionCase c(random, seed, 0);
        const Symbolic s = factor::analyse(c.m.pattern, factor::plan_elimination(c.m.pattern));
        std::vector<std::int32_t> all;
        for (int v = 0; v < c.m.pattern.nodes(); ++v) all.push_back(v);
        factor::Numeric symmetric, none, both;
        symmetric.reserve(s, 1);
        EXPECT_EQ(symmetric.upper(), nullptr);
        symmetric.clear(s, serial);
        fill(c.m, s, symmetric.values());
        ASSERT_EQ(symmetric.factor(s, serial), 0);
        const std::vector<double> x = solve_bits(s, symmetric, serial, 7);
        const std::vector<double> l = entries_below(s, symmetric.values());
        for (const bool every : {false, true}) {
            const Unsymmetric set = find_set(s, every ? all : std::vector<std::int32_t>{});
            EXPECT_EQ(set.empty(), !every);
            factor::Numeric& numeric = every ? both : none;
            numeric.reserve(s, 1, true);
            fill_both(c.m, s, set, numeric, serial);
            ASSERT_EQ(numeric.factor(s, serial, &set), 0);
            EXPECT_TRUE(same_bits(x, solve_bits(s, numeric, serial, 7)));
            EXPECT_TRUE(same_bits(l, entries_below(s, numeric.values())));
            if (every) {
                EXPECT_TRUE(same_bits(l, entries_below(s, numeric.upper())));
            }
        }
    }
}

/// Values for factor_forward(): the symmetric part first, then both halves.
struct PieceWriter {
    const BlockMatrix& m;
    const Symbolic& s;
    const Unsymmetric& set;
    factor::Numeric& numeric;
    std::vector<int> piece_of = {};  ///< Piece of each node.
    BlockMatrix half = {};           ///< Symmetric part.

    void start() {
        half = m;
        half.dense = 0.5 * (m.dense + m.dense.transpose());
        piece_of.assign(m.pattern.size.size(), -1);
        for (std::size_t v = 0; v < piece_of.size(); ++v) {
            const std::int64_t address = s.column_address(s.position[v]);
            for (std::size_t i = 0; i < numeric.pieces().size(); ++i)
                if (address >= numeric.pieces()[i].panel_begin &&
                    address < numeric.pieces()[i].panel_end)
                    piece_of[v] = static_cast<int>(i);
            EXPECT_GE(piece_of[v], 0);
        }
    }
    static void write(void* self, int piece, double* panel) noexcept {
        auto& w = *static_cast<PieceWriter*>(self);
        fill_columns(w.half, w.s, panel,
                     [&](int v) { return w.piece_of[static_cast<std::size_t>(v)] == piece; });
    }
    static void skew(void* self, int piece, double* panel, double* upper) noexcept {
        auto& w = *static_cast<PieceWriter*>(self);
        EXPECT_TRUE(w.set.is_piece(w.s, w.numeric.pieces()[static_cast<std::size_t>(piece)]));
        auto mine = [&](int v) {
            return w.piece_of[static_cast<std::size_t>(v)] == piece && in_set(w.s, w.set, v);
        };
        fill_columns(w.m, w.s, panel, mine);
        fill_upper(w.m, w.s, upper, mine);
    }
};

/// Piece by piece or in phases, with one thread or three: equal bits. The second half of symmetric
/// fronts is not written.
TEST(Unsymmetric, PieceByPieceHasTheSameBits) {
    runtime::Pool pool(3);
    pool.resume();
    base::SerialExecutor serial;
    int resumed = 0;  // pieces that start within an unsymmetric batch
    const auto all = seeds(1, kSanitized ? 8 : 12, kSanitized ? 8 : 40, 400);
    for (const std::uint32_t seed : all) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const FrictionCase c(random, seed, 6);
        const Symbolic s = factor::analyse(c.m.pattern, factor::plan_elimination(c.m.pattern));
        const Unsymmetric set = find_set(s, columns_of(c.pairs));
        factor::Numeric phases;
        phases.reserve(s, 1, true);
        fill_both(c.m, s, set, phases, serial);
        ASSERT_EQ(phases.factor(s, serial, &set), 0);
        const std::vector<double> want = solve_bits(s, phases, serial, 3);
        for (base::Executor* executor :
             {static_cast<base::Executor*>(&serial), static_cast<base::Executor*>(&pool)}) {
            factor::Numeric numeric;
            numeric.piece_size = 500;
            numeric.reserve(s, executor->threads(), true);
            for (const factor::Piece& p : numeric.pieces())
                resumed += p.begin == p.end && set.is_batch(p.begin) &&
                           p.step_begin > s.batches[static_cast<std::size_t>(p.begin)].step_begin;
            std::fill_n(numeric.upper(), s.panel_size, std::nan(""));
            PieceWriter writer{c.m, s, set, numeric};
            writer.start();
            Random values(3);
            std::vector<double> x(static_cast<std::size_t>(s.scalars) + 8);
            for (double& v : x) v = values.uniform(-1, 1);
            ASSERT_EQ(numeric.factor_forward(s, {PieceWriter::write, &writer, PieceWriter::skew},
                                             x.data(), *executor, &set),
                      0);
            numeric.backward(s, x.data(), *executor);
            x.resize(static_cast<std::size_t>(s.scalars));
            EXPECT_TRUE(same_bits(x, want));
            EXPECT_TRUE(same_bits(solve_bits(s, numeric, *executor, 3), want));
            for (std::size_t f = 0; f < s.fronts.size(); ++f) {
                const factor::Front& front = s.fronts[f];
                if (front.batch >= 0 || set.is(static_cast<std::int32_t>(f))) continue;
                for (std::int64_t i = 0; i < static_cast<std::int64_t>(front.ld) * front.p; ++i)
                    ASSERT_TRUE(std::isnan(numeric.upper()[front.panel + i]));
            }
        }
    }
    if (all.size() > 1) {
        EXPECT_GT(resumed, static_cast<int>(all.size()));
    }
}

/// One Numeric and one set for structures of every size, with and without a second half.
TEST(Unsymmetric, FollowsOtherStructures) {
    base::SerialExecutor serial;
    factor::Numeric numeric;
    Unsymmetric set;
    Random random(first_seed(11));
    const auto structures = static_cast<std::uint32_t>(by_tier(kSanitized ? 8 : 20, 40, 400));
    for (std::uint32_t k = 0; k < structures; ++k) {
        SCOPED_TRACE(k);
        const FrictionCase c(random, k, 3);
        const Symbolic s = factor::analyse(c.m.pattern, factor::plan_elimination(c.m.pattern));
        const bool friction = !c.pairs.empty();
        numeric.reserve(s, 1, friction);
        set.reserve(s);
        set.find(s, columns_of(c.pairs));
        if (friction) {
            fill_both(c.m, s, set, numeric, serial);
        } else {
            numeric.clear(s, serial);
            fill(c.m, s, numeric.values());
        }
        ASSERT_EQ(numeric.factor(s, serial, friction ? &set : nullptr), 0);
        const Vector b = random_matrix(random, c.m.scalars(), 1);
        Vector y = Vector::Zero(b.size() + 8);
        y.head(b.size()) = permuted(c.m, s, b, false);
        numeric.solve(s, y.data(), serial);
        const Vector x = permuted(c.m, s, y.head(b.size()), true);
        EXPECT_LE(backward_error(c.m, x, b), 1e-12);  // growth below 1e4 times 2⁻⁵³
    }
}

TEST(Unsymmetric, SetIsClosedAndCountsFlops) {
    for (const std::uint32_t seed : seeds(1, 10, 40, 400)) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const FrictionCase c(random, seed, 5);
        const Symbolic s = factor::analyse(c.m.pattern, factor::plan_elimination(c.m.pattern));
        const std::vector<std::int32_t> columns = columns_of(c.pairs);
        Unsymmetric set = find_set(s, {});
        EXPECT_EQ(set.flops, s.flops);
        std::vector<std::int32_t> all;
        for (int v = 0; v < c.m.pattern.nodes(); ++v) all.push_back(v);
        set.find(s, all);
        EXPECT_EQ(set.flops, 2 * s.flops);
        set.find(s, columns);  // must contain nothing from the sets before
        std::int64_t flops = s.flops;
        std::vector<bool> want(s.fronts.size(), false);
        for (const std::int32_t v : columns)
            for (std::int32_t f = s.node_front[static_cast<std::size_t>(v)]; f >= 0;
                 f = s.fronts[static_cast<std::size_t>(f)].parent)
                want[static_cast<std::size_t>(f)] = true;
        for (std::size_t f = 0; f < s.fronts.size(); ++f) {
            const factor::Front& front = s.fronts[f];
            if (front.batch >= 0) {
                EXPECT_EQ(set.is(static_cast<std::int32_t>(f)), set.is_batch(front.batch));
                if (want[f]) {
                    EXPECT_TRUE(set.is_batch(front.batch));
                }
                continue;
            }
            EXPECT_EQ(set.is(static_cast<std::int32_t>(f)), want[f]) << seed;
            if (want[f]) flops += factor::front_flops(front.p, front.q);
        }
        for (std::size_t b = 0; b < s.batches.size(); ++b)
            if (set.is_batch(static_cast<std::int32_t>(b))) flops += s.batches[b].flops;
        EXPECT_EQ(set.flops, flops);
    }
}

}  // namespace
}  // namespace hawser::test
