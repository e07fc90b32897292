// SPDX-License-Identifier: Apache-2.0
// Functions of `hawser-bench factor` around the solvers, against dense algebra.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>

#include <sstream>

#include "index.h"
#include "linear/reference.h"
#include "linear/scalar.h"
#include "linear/sweeps.h"
#include "paper_matrix/matrix_market.h"
#include "paper_matrix/paper_matrix.h"
#include "paper_matrix/structures.h"

namespace hawser::bench {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

Matrix full(const Sparse& lower) {
    Matrix k(lower);
    k.triangularView<Eigen::StrictlyUpper>() = k.transpose();
    return k;
}

/// Return the scalars of the nodes that a form keeps, and the others.
std::pair<std::vector<int>, std::vector<int>> split(const BlockSystem& s, const BlockForm& f) {
    std::pair<std::vector<int>, std::vector<int>> parts;
    for (int a = 0; a < s.pattern.nodes(); ++a)
        for (int i = s.offset[at(a)]; i < s.offset[at(a) + 1]; ++i)
            (f.index[at(a)] >= 0 ? parts.first : parts.second).push_back(i);
    return parts;
}

std::vector<BlockSystem> small_systems() {
    PaperOptions o;
    o.elements = 30;
    std::vector<BlockSystem> all;
    all.push_back(PaperScene(o).system());
    all.push_back(chain(30));
    all.push_back(net(6));
    for (BlockSystem& s : all) s.rhs.reserve(s.rhs.size() + 8);
    return all;
}

TEST(BlockForm, CondensedIsTheSchurComplement) {
    base::SerialExecutor serial;
    for (const BlockSystem& s : small_systems()) {
        const BlockForm f = make_form(s, true);
        EXPECT_EQ(f.kept.size(), at(s.bodies));
        std::vector<double> inverse(at(s.scalars()) + 8, 0.0);
        invert_sigma(s, f, inverse, serial);
        ScalarMatrix m(s, f);
        m.refresh(s, f, inverse, serial);
        const Matrix k = full(s.lower());
        const auto [kept, gone] = split(s, f);
        const Matrix g = k(gone, kept);
        const Vector sigma = -k.diagonal()(gone);
        const Matrix schur = k(kept, kept) + g.transpose() * sigma.cwiseInverse().asDiagonal() * g;
        // Rounding of sums of up to some hundred terms, each at most as large as the largest entry.
        EXPECT_LT((full(m.lower) - schur).cwiseAbs().maxCoeff(),
                  1e-14 * schur.cwiseAbs().maxCoeff())
            << s.name;
    }
}

TEST(BlockForm, SaddleMatrixIsTheSystem) {
    base::SerialExecutor serial;
    for (const BlockSystem& s : small_systems()) {
        const BlockForm f = make_form(s, false);
        ScalarMatrix m(s, f);
        const Sparse exact = s.lower();
        m.lower.coeffs().setZero();
        m.refresh(s, f, {}, serial);
        EXPECT_EQ((m.lower - exact).norm(), 0.0);
    }
}

TEST(Sweeps, FoldSolveUnfoldSolvesTheSystem) {
    base::SerialExecutor serial;
    for (const BlockSystem& s : small_systems())
        for (const bool condensed : {false, true}) {
            const BlockForm f = make_form(s, condensed);
            std::vector<double> inverse(at(s.scalars()) + 8, 0.0);
            invert_sigma(s, f, inverse, serial);
            ScalarMatrix m(s, f);
            m.refresh(s, f, inverse, serial);
            const Eigen::SimplicialLDLT<Sparse> library(m.lower);
            ASSERT_EQ(library.info(), Eigen::Success);
            SweepVectors v;
            v.resize(s);
            auto solve = [&] {
                Eigen::Map<Vector> x(v.folded.data(), f.scalars());
                x = library.solve(x).eval();
            };
            fold_right_side(s, f, inverse, v, serial);
            solve();
            unfold_solution(s, f, inverse, v, serial);
            const ReferenceSolution exact = solve_reference(s);
            const double first = relative_error(s, v.x, exact.x);
            fold_residual(s, f, v, serial);
            solve();
            add_correction(s, f, inverse, v, serial);
            const double refined = relative_error(s, v.x, exact.x);
            // Condition: bodies of 2e7 kg and of 1e2 kg, compliances 1e-9 and 1e1.
            EXPECT_LT(refined, 1e-8) << s.name << (condensed ? " condensed" : " saddle");
            EXPECT_LE(refined, 2.0 * first + 1e-15);
        }
}

TEST(Reference, SolvesInLongDouble) {
    for (const BlockSystem& s : small_systems()) {
        const ReferenceSolution r = solve_reference(s);
        EXPECT_LT(r.last_correction, 1e-12) << s.name;
        std::vector<double> y(r.x.size());
        multiply(s, r.x, y);
        const Matrix k = full(s.lower());
        const double scale =
            (k.cwiseAbs() * Eigen::Map<const Vector>(r.x.data(), s.scalars()).cwiseAbs())
                .maxCoeff();
        for (int i = 0; i < s.scalars(); ++i) ASSERT_NEAR(y[at(i)], s.rhs[at(i)], 1e-14 * scale);
    }
}

TEST(MatrixMarket, ReadsDetectsBlocksAndRefuses) {
    // Two bodies of two scalars each, coupled, and one row on both, with comments and blank lines.
    std::istringstream in(
        "%%MatrixMarket matrix coordinate real symmetric\n% comment\n\n5 5 12\n"
        "1 1 4\n2 1 1\n2 2 5\n3 3 6\n4 3 1\n4 4 7\n3 1 0.5\n4 1 0.25\n3 2 0.125\n4 2 0.1\n"
        "5 1 2\n5 5 -1e-3\n");
    const Sparse lower = parse_matrix_market(in);
    EXPECT_EQ(lower.nonZeros(), 12);
    const auto groups = indistinguishable_columns(lower);
    // The row touches scalar 1 alone; 2, 3 and 4 have entries in rows 1-4.
    EXPECT_EQ(groups, (std::vector<std::vector<int>>{{0}, {1, 2, 3}, {4}}));
    const BlockSystem s = group_blocks(lower, {{0, 1}, {2, 3}, {4}});
    EXPECT_EQ(s.pattern.nodes(), 3);
    EXPECT_EQ(s.bodies, 2);
    EXPECT_EQ((s.lower() - lower).norm(), 0.0);
    const BlockSystem t = group_blocks(lower, groups);
    EXPECT_EQ((t.lower() - lower).norm(), 0.0);
    for (const char* text : {"", "%%MatrixMarket matrix array real symmetric\n1 1\n1\n",
                             "%%MatrixMarket matrix coordinate real general\n1 1 1\n1 1 1\n",
                             "%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n1 1 1\n",
                             "%%MatrixMarket matrix coordinate real symmetric\n2 2 1\n3 1 1\n",
                             "%%MatrixMarket matrix coordinate real symmetric\n2 3 1\n1 1 1\n"}) {
        std::istringstream bad(text);
        EXPECT_THROW((void)parse_matrix_market(bad), std::runtime_error) << text;
    }
}

TEST(MatrixMarket, FindsTheBlocksOfAPaperMatrix) {
    const BlockSystem s = chain(20);
    const auto groups = indistinguishable_columns(s.lower());
    const BlockSystem t = group_blocks(s.lower(), groups);
    EXPECT_EQ(t.scalars(), s.scalars());
    EXPECT_EQ(t.islands(), 1);
    for (const auto& g : groups) EXPECT_LE(g.size(), 6u);
}

}  // namespace
}  // namespace hawser::bench
