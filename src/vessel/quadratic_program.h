// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file quadratic_program.h
/// Solve strictly convex quadratic programs of up to 40 variables.

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace hawser::vessel {

/// Minimise ½ xᵀH x + gᵀx subject to a_kᵀ x ≤ b_k.
///
/// Dual active-set method (D. Goldfarb and A. Idnani, "A numerically stable dual method for solving
/// strictly convex quadratic programs", 1983): starts at the minimum without constraints and adds
/// the most violated one, so that it needs no feasible start. A constraint acts on at most two
/// variables and is stored as such. All memory is of fixed size.
class QuadraticProgram {
  public:
    static constexpr int kMaxVariables = 40;  ///< Variables.
    using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxVariables, 1>;
    using Matrix =
        Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMaxVariables, kMaxVariables>;

    /// a x_first + b x_second ≤ bound; second = −1: one variable.
    struct Constraint {
        std::int32_t first = 0, second = -1;
        double a = 0.0, b = 0.0, bound = 0.0;
    };

    /// Remove all data and set the number of variables.
    /// @param variables  At most kMaxVariables.
    void begin(int variables);
    /// Reserve memory for constraints. Call before warm steps.
    void reserve(std::size_t constraints) { constraints_.reserve(constraints); }
    Matrix& hessian() noexcept { return hessian_; }
    Vector& gradient() noexcept { return gradient_; }
    void add(const Constraint& constraint) { constraints_.push_back(constraint); }
    /// Remove the constraints and keep the matrices.
    void clear_constraints() noexcept { constraints_.clear(); }
    /// Solve the program. @return false if no point meets the constraints, or H is not positive
    /// definite.
    [[nodiscard]] bool solve() noexcept;
    [[nodiscard]] const Vector& solution() const noexcept { return x_; }
    [[nodiscard]] int active() const noexcept { return active_count_; }

  private:
    [[nodiscard]] double violation(const Constraint& c) const noexcept;
    [[nodiscard]] int max_violated() const noexcept;
    [[nodiscard]] bool add_active(int index) noexcept;
    void direction(int index) noexcept;
    void drop(int slot) noexcept;

    int n_ = 0, active_count_ = 0;
    Matrix hessian_, factor_, columns_,
        gram_;  ///< L of H, L⁻¹N of active normals, its Gram matrix.
    Vector gradient_, x_, multipliers_, step_, slopes_, normal_;
    std::array<int, kMaxVariables> active_{};
    std::vector<Constraint> constraints_;
};

}  // namespace hawser::vessel
