// SPDX-License-Identifier: Apache-2.0
// The systems of `hawser-bench factor`: sizes, connectedness, symmetry, definiteness, repetition.
#include "paper_matrix/paper_matrix.h"
#include "index.h"

#include "paper_matrix/structures.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <set>
#include <utility>

namespace hawser::bench {
namespace {

PaperOptions options(CableForm form, int scale, int elements = 94) {
    PaperOptions o;
    o.form = form;
    o.scale = scale;
    o.elements = elements;
    return o;
}

/// Pairs of bodies that share an interaction, and the scalars of the condensed lower triangle.
struct BodyGraph {
    std::set<std::pair<int, int>> pairs;
    std::int64_t condensed_nnz = 0;
    int largest_degree = 0;
    explicit BodyGraph(const BlockSystem& s) {
        std::vector<int> degree(at(s.pattern.nodes()), 0);
        for (int a = 0; a < s.pattern.nodes(); ++a) {
            if (s.positive(a)) condensed_nnz += s.size(a) * (s.size(a) + 1) / 2;
            if (s.positive(a)) continue;
            for (int i : s.pattern.neighbours(a))
                for (int j : s.pattern.neighbours(a))
                    if (i < j && pairs.emplace(i, j).second) {
                        condensed_nnz += s.size(i) * s.size(j);
                        largest_degree =
                            std::max({largest_degree, ++degree[at(i)], ++degree[at(j)]});
                    }
        }
    }
};

TEST(PaperMatrix, HasTheStatedSizes) {
    const struct {
        CableForm form;
        int velocities, scalars;
        std::int64_t condensed;
    } cases[] = {{CableForm::lumped, 3189, 9414, 34'197},
                 {CableForm::rigid, 6000, 14'079, 110'856}};
    for (const auto& c : cases) {
        const PaperScene scene(options(c.form, 1));
        const BlockSystem s = scene.system();
        EXPECT_EQ(scene.bodies(), 1000);
        EXPECT_EQ(scene.interactions(), 3000);
        EXPECT_EQ(scene.contacts().size(), 1000u);
        EXPECT_EQ(s.bodies, 1000);
        EXPECT_EQ(s.offset[1000], c.velocities);
        EXPECT_EQ(s.scalars(), c.scalars);
        const BodyGraph g(s);
        EXPECT_EQ(g.pairs.size(), 2496u);
        EXPECT_EQ(g.condensed_nnz, c.condensed);
        EXPECT_EQ(g.largest_degree, 132);
    }
}

TEST(PaperMatrix, IsOneIslandAtEveryScale) {
    for (int scale : {1, 2, 10}) {
        const BlockSystem s = PaperScene(options(CableForm::rigid, scale)).system();
        EXPECT_EQ(s.islands(), 1) << scale;
        // Each joint between two copies of the scene adds one bending joint of two rows.
        EXPECT_EQ(s.scalars(), 14'079 * scale + 2 * (scale - 1));
    }
}

TEST(PaperMatrix, RepeatsBitForBit) {
    const auto o = options(CableForm::lumped, 2);
    const BlockSystem a = PaperScene(o).system(), b = PaperScene(o).system();
    EXPECT_EQ(a.values, b.values);
    EXPECT_EQ(a.rhs, b.rhs);
    // Another seed gives another matrix of the same size.
    auto other = o;
    other.seed = 2;
    const BlockSystem c = PaperScene(other).system();
    EXPECT_EQ(a.pattern.size, c.pattern.size);
    EXPECT_NE(a.values, c.values);
}

TEST(PaperMatrix, ContactEditsChangeThatManyContactsAndNothingElse) {
    const auto o = options(CableForm::rigid, 2);
    for (int count : {10, 50, 200}) {
        PaperScene scene(o), again(o);
        for (int step = 0; step < 3; ++step) {
            const BlockSystem before = scene.system();
            const std::vector<int> changed = scene.change_contacts(count, step);
            EXPECT_EQ(changed, again.change_contacts(count, step));
            EXPECT_EQ(changed.size(), at(2 * count));
            const BlockSystem after = scene.system();
            EXPECT_EQ(after.pattern.size, before.pattern.size);
            EXPECT_EQ(after.islands(), 1);
            std::set<int> nodes;
            for (int i : changed) nodes.insert(scene.contact_node(i));
            int moved = 0;
            for (int a = scene.bodies(); a < after.pattern.nodes(); ++a) {
                const auto x = before.pattern.neighbours(a), y = after.pattern.neighbours(a);
                const bool same = std::equal(x.begin(), x.end(), y.begin(), y.end());
                if (!same) ++moved;
                EXPECT_TRUE(same || nodes.count(a) == 1) << "node " << a;
            }
            // A body with three points on its hull can change to itself by chance.
            EXPECT_GE(moved, 2 * count * 9 / 10);
        }
    }
}

/// Check A and A + GᵀΣ⁻¹G by dense Cholesky, and Σ by its diagonal. By Sylvester's law the matrix
/// then has as many positive pivots as bodies have scalars, and as many negative ones as there are
/// rows. This holds in any order.
void expect_quasi_definite(const BlockSystem& s) {
    const Sparse lower = s.lower();
    std::vector<int> row(at(s.scalars()), -1), body(at(s.scalars()), -1);
    int rows = 0, bodies = 0;
    for (int a = 0; a < s.pattern.nodes(); ++a)
        for (int i = s.offset[at(a)]; i < s.offset[at(a) + 1]; ++i)
            (s.positive(a) ? body[at(i)] : row[at(i)]) = s.positive(a) ? bodies++ : rows++;
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(bodies, bodies);
    Eigen::VectorXd sigma = Eigen::VectorXd::Zero(rows);
    std::vector<Eigen::Triplet<double>> g;
    for (int j = 0; j < lower.outerSize(); ++j)
        for (Sparse::InnerIterator it(lower, j); it; ++it) {
            const int i = static_cast<int>(it.row());
            if (body[at(i)] >= 0 && body[at(j)] >= 0)
                a(body[at(i)], body[at(j)]) = a(body[at(j)], body[at(i)]) = it.value();
            else if (i == j)
                sigma[row[at(i)]] = -it.value();
            else if (row[at(i)] >= 0 && body[at(j)] >= 0)
                g.emplace_back(row[at(i)], body[at(j)], it.value());
            else
                FAIL() << s.name << ": rows coupled to rows";
        }
    EXPECT_TRUE((sigma.array() > 0.0).all()) << s.name;  // or Σ is empty
    EXPECT_EQ(Eigen::LLT<Eigen::MatrixXd>(a).info(), Eigen::Success) << s.name;
    Sparse jacobian(rows, bodies);
    jacobian.setFromTriplets(g.begin(), g.end());
    const Sparse scaled = sigma.cwiseSqrt().cwiseInverse().asDiagonal() * jacobian;
    a += Sparse(scaled.transpose() * scaled);
    EXPECT_EQ(Eigen::LLT<Eigen::MatrixXd>(a).info(), Eigen::Success) << s.name;
}

TEST(PaperMatrix, SmallInstancesAreQuasiDefinite) {
    expect_quasi_definite(PaperScene(options(CableForm::lumped, 1, 30)).system());
    expect_quasi_definite(chain(40));
    expect_quasi_definite(tree_of_chains(4, 5));
    expect_quasi_definite(net(8));
    expect_quasi_definite(solid(4));
    expect_quasi_definite(moored_floats(90, 9, 3));
}

TEST(PaperMatrix, LowerAndProductAgreeWithTheBlocks) {
    for (const BlockSystem& s : {PaperScene(options(CableForm::rigid, 1, 30)).system(), net(5)}) {
        const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(s.scalars(), -1.0, 1.0);
        std::vector<double> y(at(s.scalars()));
        multiply(s, {x.data(), at(s.scalars())}, y);
        const Eigen::VectorXd z = s.lower().selfadjointView<Eigen::Lower>() * x;
        for (int i = 0; i < s.scalars(); ++i)
            // Sums of some hundred terms up to the size of the largest one, 4e10 at hulls.
            ASSERT_NEAR(y[at(i)], z[i], 1e-14 * 4e10);
    }
}

TEST(Structures, HaveTheStatedSizesAndAreOneIsland) {
    const BlockSystem c = chain(1000);
    EXPECT_EQ(c.bodies, 1000);
    EXPECT_EQ(c.scalars(), 9000);
    EXPECT_EQ(c.islands(), 1);
    const BlockSystem t = tree_of_chains(5, 7);
    EXPECT_EQ(t.bodies, 31 * 7);
    EXPECT_EQ(t.islands(), 1);
    const BlockSystem n = net(50);
    EXPECT_EQ(n.scalars(), 3 * 2500 + 2 * 50 * 49);
    EXPECT_EQ(n.islands(), 1);
    const BlockSystem m = moored_floats(1003, 20, 4);
    EXPECT_EQ(m.bodies, 1003 + 4);
    EXPECT_EQ(m.islands(), 1);
}

}  // namespace
}  // namespace hawser::bench
