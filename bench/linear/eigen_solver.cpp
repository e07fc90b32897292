// SPDX-License-Identifier: Apache-2.0
#include "linear/solver.h"

#include <Eigen/SparseCholesky>

#include <stdexcept>

namespace hawser::bench {
namespace {

/// With the matrix permuted before and its upper triangle stored, Eigen makes no copy.
class EigenSolver final : public ScalarSolver {
  public:
    explicit EigenSolver(Order order) : ScalarSolver(order, Triangle::upper) {}

    bool prepare_own(const Input& input) override {
        natural_ = &input.matrix->lower;
        return true;
    }
    void analyse_own() override { own_.analyzePattern(*natural_); }
    void factor(base::Executor&) override {
        ldlt_.factorize(upper_);
        if (ldlt_.info() != Eigen::Success) throw std::runtime_error("a zero pivot");
    }
    [[nodiscard]] double factor_nnz() const override {
        // Its L has no diagonal.
        return static_cast<double>(ldlt_.matrixL().nestedExpression().nonZeros()) + matrix_.size();
    }

  protected:
    void analyse_pattern() override {
        const int n = matrix_.size();
        upper_.resize(n, n);
        upper_.resizeNonZeros(static_cast<Eigen::Index>(matrix_.row.size()));
        std::copy(matrix_.start.begin(), matrix_.start.end(), upper_.outerIndexPtr());
        std::copy(matrix_.row.begin(), matrix_.row.end(), upper_.innerIndexPtr());
        ldlt_.analyzePattern(upper_);
    }
    double* values() override { return upper_.valuePtr(); }
    void solve_permuted(std::vector<double>& x) override {
        Eigen::Map<Eigen::VectorXd> v(x.data(), static_cast<Eigen::Index>(x.size()));
        v = ldlt_.solve(v).eval();
    }

  private:
    const Sparse* natural_ = nullptr;
    Eigen::SimplicialLDLT<Sparse, Eigen::Lower, Eigen::AMDOrdering<int>> own_;  // its default
    Sparse upper_;
    Eigen::SimplicialLDLT<Sparse, Eigen::Upper, Eigen::NaturalOrdering<int>> ldlt_;
};

}  // namespace

std::unique_ptr<Solver> make_eigen(Order order) { return std::make_unique<EigenSolver>(order); }

}  // namespace hawser::bench
