// SPDX-License-Identifier: Apache-2.0
/// The solver against dense references, by class of matrix. Backward errors: LDLᵀ without
/// pivoting of a quasi-definite matrix has an error of n·2⁻⁵³ times the growth, which is
/// 1 + ‖G‖²/(λ_A λ_Σ) (Gill, Saunders, Shinnerl 1996). Each class states its bound.
#include "factor/matrices.h"
#include "runtime/tasks.h"
#include "support/tier.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace hawser::test {
namespace {

Vector random_vector(Random& random, int n) { return random_matrix(random, n, 1); }

/// Make a chain of bodies (6) and joints (5 rows), with nodes in the order of `label`.
BlockMatrix chain(Random& random, int links, double sigma, bool shuffled) {
    const int nodes = 2 * links;  // joint i connects bodies i and i − 1
    std::vector<int> label(static_cast<std::size_t>(nodes));
    std::iota(label.begin(), label.end(), 0);
    if (shuffled) random.shuffle(label);
    std::vector<std::int8_t> size(label.size()), sign(label.size());
    std::vector<std::pair<int, int>> edges;
    auto body = [&](int i) { return label[static_cast<std::size_t>(2 * i)]; };
    auto joint = [&](int i) { return label[static_cast<std::size_t>(2 * i + 1)]; };
    for (int i = 0; i < links; ++i) {
        size[static_cast<std::size_t>(body(i))] = 6;
        sign[static_cast<std::size_t>(body(i))] = 1;
        size[static_cast<std::size_t>(joint(i))] = 5;
        sign[static_cast<std::size_t>(joint(i))] = -1;
        edges.emplace_back(joint(i), body(i));
        if (i > 0) edges.emplace_back(joint(i), body(i - 1));
    }
    BlockMatrix m = make_blocks(size, sign, edges);
    for (int i = 0; i < links; ++i) {
        m.block(body(i), body(i)) = definite(random, 6, 1.0, 1);
        m.block(joint(i), joint(i)) = -sigma * Matrix::Identity(5, 5);
        set_symmetric(m, joint(i), body(i), random_matrix(random, 5, 6));
        if (i > 0) set_symmetric(m, joint(i), body(i - 1), random_matrix(random, 5, 6));
    }
    return m;
}

void expect_solved(const BlockMatrix& m, double bound, std::uint64_t seed = 1) {
    Random random(seed);
    const Vector b = random_vector(random, m.scalars());
    const Solved s = solve(m, b);
    EXPECT_EQ(s.wrong, 0);
    EXPECT_LE(backward_error(m, s.x, b), bound);
}

TEST(DenseReference, OneBody) {
    Random random(1);
    for (int size = 1; size <= 6; ++size) {
        BlockMatrix m = make_blocks({static_cast<std::int8_t>(size)}, {1}, {});
        m.dense = definite(random, size, 3.0, 1);
        const Vector b = random_vector(random, size);
        const Solved s = solve(m, b);
        EXPECT_EQ(s.wrong, 0);
        // Definite, condition about 10: a few units in the last place.
        EXPECT_LE((s.x - reference(m, b)).norm(), 1e-14 * s.x.norm()) << size;
    }
}

TEST(DenseReference, NoBody) {
    const BlockMatrix m = make_blocks({}, {}, {});
    const Solved s = solve(m, Vector(0));
    EXPECT_EQ(s.wrong, 0);
    EXPECT_EQ(s.x.size(), 0);
}

TEST(DenseReference, NoInteraction) {
    Random random(2);
    std::vector<std::int8_t> size, sign(40, 1);
    for (int i = 0; i < 40; ++i) size.push_back(static_cast<std::int8_t>(1 + i % 6));
    BlockMatrix m = make_blocks(size, sign, {});
    for (int i = 0; i < 40; ++i)
        m.block(i, i) = definite(random, size[static_cast<std::size_t>(i)], 1.0, 1);
    expect_solved(m, 1e-15);
}

TEST(DenseReference, MassRatioOneMillion) {
    Random random(3);
    for (int heavy = 0; heavy < 10; ++heavy) {
        BlockMatrix m = chain(random, 10, 1e-3, false);
        for (int i = 0; i < 10; ++i) m.block(2 * i, 2 * i) *= i == heavy ? 1e6 : 1.0;
        const Vector b = random_vector(random, m.scalars());
        const Solved s = solve(m, b);
        EXPECT_EQ(s.wrong, 0);
        // Growth 1 + ‖G‖²/(λ_A Σ) ≈ 1e5 at the light bodies, but relative to ‖K‖ = 1e6.
        EXPECT_LE(backward_error(m, s.x, b), 1e-14);
        // Forward error: condition up to about 1e6/1e-3, measured against the reference.
        EXPECT_LE((s.x - reference(m, b)).norm(), 1e-9 * s.x.norm()) << "heavy body " << heavy;
    }
}

TEST(DenseReference, RedundantRows) {
    Random random(4);
    for (double sigma : {1e-3, 1e-6, 1e-9}) {
        // Five rows, three times: without Σ the matrix has rank 11 of 21.
        BlockMatrix m = make_blocks({6, 5, 5, 5}, {1, -1, -1, -1}, {{1, 0}, {2, 0}, {3, 0}});
        m.block(0, 0) = definite(random, 6, 1.0, 1);
        const Matrix g = random_matrix(random, 5, 6);
        for (int j = 1; j <= 3; ++j) {
            set_symmetric(m, j, 0, g);
            m.block(j, j) = -sigma * Matrix::Identity(5, 5);
        }
        const Vector b = random_vector(random, m.scalars());
        const Solved s = solve(m, b);
        EXPECT_EQ(s.wrong, 0) << sigma;
        // The Schur complement of a repeated row is of the order Σ: relative error 2⁻⁵³/Σ.
        EXPECT_LE(backward_error(m, s.x, b), 1e-14 + 1e-14 / sigma * 1e-2) << sigma;
    }
}

void expect_rows_behind_a_body(const BlockMatrix& m, const std::vector<std::int32_t>& order) {
    std::vector<int> position(order.size());
    for (std::size_t k = 0; k < order.size(); ++k)
        position[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
    for (int v = 0; v < m.pattern.nodes(); ++v) {
        if (m.pattern.sign[static_cast<std::size_t>(v)] > 0) continue;
        bool after = false;
        for (std::int32_t u : m.pattern.neighbours(v))
            after = after ||
                    position[static_cast<std::size_t>(u)] < position[static_cast<std::size_t>(v)];
        EXPECT_TRUE(after) << "row node " << v;
    }
}

/// ε = 0 exactly: the rows' own diagonal is zero. The matrix factors if they come after *all* their
/// bodies.
TEST(DenseReference, RigidRowsBehindAllTheirBodies) {
    Random random(5);
    for (int links : {1, 2, 7, 30}) {
        const BlockMatrix m = chain(random, links, 0.0, true);
        std::vector<std::int32_t> order(static_cast<std::size_t>(m.pattern.nodes()));
        std::iota(order.begin(), order.end(), 0);
        std::stable_partition(order.begin(), order.end(), [&](std::int32_t v) {
            return m.pattern.sign[static_cast<std::size_t>(v)] > 0;
        });
        base::SerialExecutor serial;
        const Vector b = random_vector(random, m.scalars());
        const Solved s = solve(m, factor::analyse(m.pattern, order), b, serial);
        EXPECT_EQ(s.wrong, 0) << links;
        // Random 5 × 6 Jacobians have a condition up to 1e3, squared in G A⁻¹ Gᵀ.
        EXPECT_LE(backward_error(m, s.x, b), 1e-11) << links;
    }
}

/// The solver's own order puts a row after only one of its bodies. Two joints after one body have
/// more rows than it has freedoms. ε = 0 then needs the floor Σ = 1e-9 G M⁻¹Gᵀ that the assembly
/// adds. One refinement recovers the lost digits.
TEST(DenseReference, RigidRowsInTheSolversOwnOrder) {
    Random random(5);
    for (int links : {1, 2, 7, 30}) {
        const BlockMatrix m = chain(random, links, 1e-9, true);
        const auto order = factor::order_nodes(m.pattern);
        expect_rows_behind_a_body(m, order);
        const Vector b = random_vector(random, m.scalars());
        const Solved first = solve(m, b);
        EXPECT_EQ(first.wrong, 0) << links;
        EXPECT_LE(backward_error(m, first.x, b), 1e-5) << links;  // 2⁻⁵³/Σ times conditions
        Vector x = first.x;
        for (int i = 0; i < 2; ++i) x += solve(m, b - m.dense * x).x;
        EXPECT_LE(backward_error(m, x, b), 1e-14) << links;
    }
}

TEST(DenseReference, SixtyLinkChainInRandomOrder) {
    for (const std::uint32_t seed : seeds(1, 5, 20, 200)) {
        SCOPED_TRACE(seed);
        Random random(seed);
        const BlockMatrix m = chain(random, 60, 1e-4, true);
        expect_solved(m, 1e-12, seed);
        EXPECT_LE(factor::analyse(m.pattern, factor::order_nodes(m.pattern)).factor_nnz, 60 * 200)
            << "a chain must not fill in: 60 × (6 + 5) pivots with at most 11 below";
    }
}

TEST(DenseReference, HubWithHundredsOfNeighbours) {
    Random random(6);
    constexpr int kLeaves = 300;
    std::vector<std::int8_t> size(kLeaves + 1, 3), sign(kLeaves + 1, 1);
    size[0] = 6;
    std::vector<std::pair<int, int>> edges;
    for (int i = 1; i <= kLeaves; ++i) {
        edges.emplace_back(0, i);
    }
    BlockMatrix m = make_blocks(size, sign, edges);
    m.block(0, 0) = definite(random, 6, 1e3, 1);
    for (int i = 1; i <= kLeaves; ++i) {
        m.block(i, i) = definite(random, 3, 1.0, sign[static_cast<std::size_t>(i)]);
        set_symmetric(m, 0, i, random_matrix(random, 6, 3));
    }
    expect_solved(m, 1e-14);
    EXPECT_LE(factor::analyse(m.pattern, factor::order_nodes(m.pattern)).flops, 300 * 600)
        << "leaves first: the hub must come last";
}

TEST(DenseReference, RandomQuasiDefinite) {
    for (const std::uint32_t seed : seeds(1, 30, 120, 1200)) {
        Random random(seed);
        const BlockMatrix m =
            random_quasi_definite(random, random.integer(1, 40), random.uniform(0.02, 0.5));
        const Vector b = random_vector(random, m.scalars());
        const Solved s = solve(m, b);
        EXPECT_EQ(s.wrong, 0);
        // ‖G‖² ≤ (6·40)², λ ≥ 1: growth below 6e4; 1e-16 · 6e4 with a margin.
        EXPECT_LE(backward_error(m, s.x, b), 1e-11) << "seed " << seed;
        // Condition ≤ ‖K‖/1 ≈ 1e3.
        EXPECT_LE((s.x - reference(m, b)).norm(), 1e-9 * (s.x.norm() + 1e-300)) << "seed " << seed;
    }
}

TEST(DenseReference, AnyOrderGivesTheSameSolution) {
    Random random(first_seed(8));
    const int trials = by_tier(30, 150, 1500);
    const BlockMatrix m = random_quasi_definite(random, 25, 0.15);
    const Vector b = random_vector(random, m.scalars()), want = reference(m, b);
    base::SerialExecutor serial;
    std::vector<std::int32_t> order(25);
    std::iota(order.begin(), order.end(), 0);
    for (int trial = 0; trial < trials; ++trial) {
        random.shuffle(order);
        const Solved s = solve(m, factor::analyse(m.pattern, order), b, serial);
        EXPECT_EQ(s.wrong, 0);
        EXPECT_LE((s.x - want).norm(), 1e-10 * want.norm()) << "trial " << trial;
    }
}

TEST(Pivots, WrongSignsAreCounted) {
    Random random(9);
    BlockMatrix m = chain(random, 8, 1e-2, false);
    const Vector b = random_vector(random, m.scalars());
    ASSERT_EQ(solve(m, b).wrong, 0);
    for (int node : {0, 5, 14, 15}) {
        BlockMatrix broken = m;
        broken.block(node, node) *= -1.0;  // indefinite where the pattern promises a sign
        if (node % 2 == 0) broken.block(node, node) -= 1e3 * Matrix::Identity(6, 6);
        if (node % 2 == 1) broken.block(node, node) += 1e3 * Matrix::Identity(5, 5);
        EXPECT_GT(solve(broken, b).wrong, 0) << "node " << node;
    }
}

TEST(Pivots, ZeroNotANumberAndInfinityAreCounted) {
    Random random(10);
    const BlockMatrix m = chain(random, 8, 1e-2, false);
    const Vector b = random_vector(random, m.scalars());
    for (double bad : {0.0, std::nan(""), HUGE_VAL, -HUGE_VAL}) {
        BlockMatrix broken = m;
        if (bad == 0.0) {
            broken.dense.row(0).setZero();
            broken.dense.col(0).setZero();
        } else {
            broken.dense(0, 0) = bad;
        }
        EXPECT_GT(solve(broken, b).wrong, 0) << bad;
    }
}

void expect_same_bits(const BlockMatrix& m, std::size_t min_tasks) {
    const factor::Symbolic s = factor::analyse(m.pattern, factor::order_nodes(m.pattern));
    EXPECT_GE(s.tasks.size(), min_tasks) << "nothing to run in parallel";
    Random random(1);
    const Vector b = random_vector(random, m.scalars());
    base::SerialExecutor serial;
    const Solved want = solve(m, s, b, serial);
    EXPECT_EQ(want.wrong, 0);
    EXPECT_LE(backward_error(m, want.x, b), 1e-12);
    for (int threads : {1, 2, 4, 8}) {
        runtime::Pool pool(threads);
        pool.resume();
        for (int round = 0; round < 3; ++round) {
            const Solved got = solve(m, s, b, pool);
            EXPECT_EQ(got.wrong, 0);
            EXPECT_EQ(std::memcmp(want.x.data(), got.x.data(),
                                  sizeof(double) * static_cast<std::size_t>(want.x.size())),
                      0)
                << threads << " threads";
        }
    }
}

TEST(Threads, SameBitsOfAChain) {
    Random random(11);
    for (int links : {3, 40}) expect_same_bits(chain(random, links, 1e-3, true), 1);
}

/// A grid of bodies with blocks of every size: many tasks and a top task.
TEST(Threads, SameBitsOfAGrid) {
    Random random(12);
    constexpr int kSide = 18;
    std::vector<std::int8_t> size, sign;
    std::vector<std::pair<int, int>> edges;
    for (int i = 0; i < kSide * kSide; ++i) {
        size.push_back(static_cast<std::int8_t>(random.integer(1, 6)));
        sign.push_back(random.chance(0.7) ? 1 : -1);
        if (i % kSide > 0) edges.emplace_back(i, i - 1);
        if (i >= kSide) edges.emplace_back(i, i - kSide);
    }
    BlockMatrix m = make_blocks(size, sign, edges);
    for (int i = 0; i < kSide * kSide; ++i) {
        const auto k = static_cast<std::size_t>(i);
        m.block(i, i) = definite(random, size[k], 20.0, sign[k]);
    }
    // At most four neighbours of six scalars: 24 × 0.5 stays below the diagonal's 20.
    for (const auto& [i, j] : edges)
        set_symmetric(m, i, j,
                      0.5 * random_matrix(random, size[static_cast<std::size_t>(i)],
                                          size[static_cast<std::size_t>(j)]));
    expect_same_bits(m, 5);
}

}  // namespace
}  // namespace hawser::test
