// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file dense_lp.h
/// Small linear programs by the simplex method on a dense tableau.

#include <Eigen/Core>

#include <vector>

namespace hawser::vessel {

/// Maximise cᵀx for x ≥ 0 subject to rows A x = 0 and rows G x ≤ h with h ≥ 0.
///
/// No first phase is needed, because x = 0 is feasible: equality rows begin with artificial
/// variables at 0, which leave the basis at the first pivot in their row. The pivot rule is
/// Dantzig's. After a run of pivots without progress it is Bland's, so that the method ends.
class DenseLp {
  public:
    /// @param variables  Number of variables x. Rows and costs are initially 0.
    DenseLp(Eigen::Index variables, Eigen::Index equalities, Eigen::Index limits);
    double& cost(Eigen::Index variable) { return cost_[variable]; }
    double& equality(Eigen::Index row, Eigen::Index variable) { return rows_(row, variable); }
    double& limit(Eigen::Index row, Eigen::Index variable) {
        return rows_(equalities_ + row, variable);
    }
    double& bound(Eigen::Index row) { return right_[equalities_ + row]; }
    /// Solve the program. @return false if it is unbounded or the pivots do not end.
    [[nodiscard]] bool solve();
    [[nodiscard]] double value() const noexcept { return value_; }
    [[nodiscard]] const Eigen::VectorXd& solution() const noexcept { return x_; }

  private:
    [[nodiscard]] Eigen::Index entering_column(const Eigen::VectorXd& reduced,
                                               bool first) const noexcept;
    [[nodiscard]] Eigen::Index leaving_row(Eigen::Index column, bool first) const noexcept;
    void read();

    Eigen::Index variables_, equalities_, limits_;
    Eigen::MatrixXd rows_;
    Eigen::VectorXd right_, cost_, x_;
    std::vector<Eigen::Index>
        basis_;  ///< Variable of each row; numbers above the last variable are artificial.
    double value_ = 0.0;
};

}  // namespace hawser::vessel
