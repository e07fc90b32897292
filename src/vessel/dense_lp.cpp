// SPDX-License-Identifier: Apache-2.0
#include "vessel/dense_lp.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hawser::vessel {
namespace {

constexpr double kOptimalityTolerance = 1e-11;  ///< Reduced cost that counts as 0.
constexpr double kMinPivot = 1e-10;             ///< Smallest pivot.
constexpr int kMaxPivots = 5000, kMaxStalledPivots = 60;

}  // namespace

// Create a linear program. The columns are the variables, followed by a slack variable for each
// limit. Artificial variables have no column.
DenseLp::DenseLp(Eigen::Index variables, Eigen::Index equalities, Eigen::Index limits)
    : variables_(variables),
      equalities_(equalities),
      limits_(limits),
      rows_(Eigen::MatrixXd::Zero(equalities + limits, variables + limits)),
      right_(Eigen::VectorXd::Zero(equalities + limits)),
      cost_(Eigen::VectorXd::Zero(variables + limits)),
      x_(Eigen::VectorXd::Zero(variables)) {}

Eigen::Index DenseLp::entering_column(const Eigen::VectorXd& reduced, bool first) const noexcept {
    Eigen::Index best = -1;
    double most = kOptimalityTolerance;
    for (Eigen::Index j = 0; j < reduced.size(); ++j)
        if (reduced[j] > most) {
            best = j;
            if (first) break;
            most = reduced[j];
        }
    return best;
}

/// Return the row with the smallest ratio, whose variable leaves the basis. An artificial variable
/// at 0 leaves the basis for a pivot of any sign.
Eigen::Index DenseLp::leaving_row(Eigen::Index column, bool first) const noexcept {
    Eigen::Index best = -1;
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < rows_.rows(); ++i) {
        const double pivot = rows_(i, column);
        const auto at = static_cast<std::size_t>(i);
        if (basis_[at] >= rows_.cols() && std::abs(pivot) > kMinPivot) return i;
        if (!(pivot > kMinPivot)) continue;
        const double ratio = std::max(right_[i], 0.0) / pivot;
        const bool tie = best >= 0 && ratio == least;
        const bool lower = tie && basis_[at] < basis_[static_cast<std::size_t>(best)];
        const bool larger = tie && pivot > rows_(best, column);
        if (ratio < least || (tie && (first ? lower : larger))) {
            least = ratio;
            best = i;
        }
    }
    return best;
}

bool DenseLp::solve() {
    for (Eigen::Index k = 0; k < limits_; ++k) rows_(equalities_ + k, variables_ + k) = 1.0;
    basis_.clear();
    for (Eigen::Index i = 0; i < equalities_; ++i) basis_.push_back(rows_.cols() + i);
    for (Eigen::Index k = 0; k < limits_; ++k) basis_.push_back(variables_ + k);
    Eigen::VectorXd reduced = cost_;
    double value = 0.0;
    int stalled = 0;
    for (int pivots = 0; pivots < kMaxPivots; ++pivots) {
        const bool first = stalled > kMaxStalledPivots;
        const Eigen::Index column = entering_column(reduced, first);
        if (column < 0) {
            value_ = value;
            read();
            return true;
        }
        const Eigen::Index row = leaving_row(column, first);
        if (row < 0) return false;
        const double inverse = 1.0 / rows_(row, column);
        rows_.row(row) *= inverse;
        right_[row] *= inverse;
        for (Eigen::Index i = 0; i < rows_.rows(); ++i) {
            const double f = rows_(i, column);
            if (i == row || f == 0.0) continue;
            rows_.row(i) -= f * rows_.row(row);
            rows_(i, column) = 0.0;
            right_[i] -= f * right_[row];
        }
        const double gain = reduced[column];
        reduced -= gain * rows_.row(row).transpose();
        reduced[column] = 0.0;
        const double more = gain * right_[row];
        stalled = more > 1e-14 ? 0 : stalled + 1;
        value += more;
        basis_[static_cast<std::size_t>(row)] = column;
    }
    return false;
}

void DenseLp::read() {
    x_.setZero();
    for (Eigen::Index i = 0; i < rows_.rows(); ++i) {
        const Eigen::Index j = basis_[static_cast<std::size_t>(i)];
        if (j < variables_) x_[j] = std::max(right_[i], 0.0);
    }
}

}  // namespace hawser::vessel
