// SPDX-License-Identifier: Apache-2.0
#include "vessel/quadratic_program.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hawser::vessel {
namespace {

constexpr double kMetTolerance = 1e-10;  ///< Violation that counts as 0.
constexpr double kDependentSquare =
    1e-14;  ///< Squared independent part of a normal below which it depends on the active ones.
constexpr int kMaxRounds = 400;

}  // namespace

void QuadraticProgram::begin(int variables) {
    n_ = variables;
    hessian_.setZero(n_, n_);
    gradient_.setZero(n_);
    x_.setZero(n_);
    constraints_.clear();
    active_count_ = 0;
}

double QuadraticProgram::violation(const Constraint& c) const noexcept {
    const double second = c.second >= 0 ? c.b * x_[c.second] : 0.0;
    return c.a * x_[c.first] + second - c.bound;
}

int QuadraticProgram::max_violated() const noexcept {
    int worst = -1;
    double most = kMetTolerance;
    for (std::size_t k = 0; k < constraints_.size(); ++k) {
        const double v = violation(constraints_[k]);
        if (v > most) {
            most = v;
            worst = static_cast<int>(k);
        }
    }
    return worst;
}

/// Compute the directions z (step_) and r (slopes_) for a constraint: x moves along −z, the
/// multipliers along −r.
void QuadraticProgram::direction(int index) noexcept {
    const Constraint& c = constraints_[static_cast<std::size_t>(index)];
    normal_.setZero(n_);
    normal_[c.first] = c.a;
    if (c.second >= 0) normal_[c.second] = c.b;
    const auto lower = factor_.topLeftCorner(n_, n_).triangularView<Eigen::Lower>();
    lower.solveInPlace(normal_);
    step_ = normal_;
    const int q = active_count_;
    slopes_.setZero(q);
    if (q > 0) {
        for (int i = 0; i < q; ++i) slopes_[i] = columns_.col(i).head(n_).dot(normal_);
        gram_.resize(q, q);
        for (int i = 0; i < q; ++i)
            for (int j = 0; j < q; ++j)
                gram_(i, j) = columns_.col(i).head(n_).dot(columns_.col(j).head(n_));
        // Cholesky in place.
        for (int j = 0; j < q; ++j) {
            for (int k = 0; k < j; ++k) gram_(j, j) -= gram_(j, k) * gram_(j, k);
            gram_(j, j) = std::sqrt(std::max(gram_(j, j), 1e-300));
            for (int i = j + 1; i < q; ++i) {
                for (int k = 0; k < j; ++k) gram_(i, j) -= gram_(i, k) * gram_(j, k);
                gram_(i, j) /= gram_(j, j);
            }
        }
        for (int i = 0; i < q; ++i) {
            for (int k = 0; k < i; ++k) slopes_[i] -= gram_(i, k) * slopes_[k];
            slopes_[i] /= gram_(i, i);
        }
        for (int i = q; i-- > 0;) {
            for (int k = i + 1; k < q; ++k) slopes_[i] -= gram_(k, i) * slopes_[k];
            slopes_[i] /= gram_(i, i);
        }
        for (int i = 0; i < q; ++i) step_ -= slopes_[i] * columns_.col(i).head(n_);
    }
}

void QuadraticProgram::drop(int slot) noexcept {
    for (int i = slot; i + 1 < active_count_; ++i) {
        const auto at = static_cast<std::size_t>(i);
        active_[at] = active_[at + 1];
        multipliers_[i] = multipliers_[i + 1];
        columns_.col(i) = columns_.col(i + 1);
    }
    --active_count_;
}

/// Move the solution along the direction of a violated constraint until the constraint is met.
/// Active constraints whose multipliers reach 0 are dropped.
bool QuadraticProgram::add_active(int index) noexcept {
    double multiplier = 0.0;
    for (int rounds = 0; rounds < kMaxRounds; ++rounds) {
        direction(index);
        const double square = step_.squaredNorm();
        double least = std::numeric_limits<double>::infinity();
        int blocking = -1;
        for (int i = 0; i < active_count_; ++i)
            if (slopes_[i] > 0.0 && multipliers_[i] / slopes_[i] < least) {
                least = multipliers_[i] / slopes_[i];
                blocking = i;
            }
        const bool independent =
            square > kDependentSquare * std::max(normal_.squaredNorm(), 1e-300);
        const double over = violation(constraints_[static_cast<std::size_t>(index)]);
        const double full = independent ? over / square : std::numeric_limits<double>::infinity();
        const double t = std::min(least, full);
        if (!std::isfinite(t)) return false;
        if (independent) {
            normal_ = step_;
            factor_.topLeftCorner(n_, n_).triangularView<Eigen::Lower>().transpose().solveInPlace(
                normal_);
            x_ -= t * normal_;
        }
        for (int i = 0; i < active_count_; ++i) multipliers_[i] -= t * slopes_[i];
        multiplier += t;
        if (full <= least) {
            // Keep L⁻¹ of the normal.
            const Constraint& c = constraints_[static_cast<std::size_t>(index)];
            normal_.setZero(n_);
            normal_[c.first] = c.a;
            if (c.second >= 0) normal_[c.second] = c.b;
            factor_.topLeftCorner(n_, n_).triangularView<Eigen::Lower>().solveInPlace(normal_);
            columns_.col(active_count_).head(n_) = normal_;
            active_[static_cast<std::size_t>(active_count_)] = index;
            multipliers_[active_count_] = multiplier;
            ++active_count_;
            return true;
        }
        drop(blocking);
    }
    return false;
}

bool QuadraticProgram::solve() noexcept {
    active_count_ = 0;
    columns_.setZero(n_, n_);
    multipliers_.setZero(n_);
    factor_ = hessian_;
    for (int j = 0; j < n_; ++j) {
        for (int k = 0; k < j; ++k) factor_(j, j) -= factor_(j, k) * factor_(j, k);
        if (!(factor_(j, j) > 0.0)) return false;
        factor_(j, j) = std::sqrt(factor_(j, j));
        for (int i = j + 1; i < n_; ++i) {
            for (int k = 0; k < j; ++k) factor_(i, j) -= factor_(i, k) * factor_(j, k);
            factor_(i, j) /= factor_(j, j);
        }
    }
    x_ = -gradient_;
    const auto lower = factor_.topLeftCorner(n_, n_).triangularView<Eigen::Lower>();
    lower.solveInPlace(x_);
    lower.transpose().solveInPlace(x_);
    for (int rounds = 0; rounds < kMaxRounds; ++rounds) {
        const int worst = max_violated();
        if (worst < 0) return true;
        if (!add_active(worst)) return false;
    }
    return false;
}

}  // namespace hawser::vessel
