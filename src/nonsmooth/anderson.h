// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file anderson.h
/// Anderson's acceleration of a fixed-point iteration x ← F(x). Sources: D. G. Anderson, "Iterative
/// procedures for nonlinear integral equations", 1965; H. F. Walker, P. Ni, 2011.
///
/// With f = F(x) − x, and the differences Δf, ΔF of the last iterations,
/// ```
///   x₊ = F(x) − ΔF γ,   γ = argmin ‖f − Δf γ‖
/// ```
/// For one unknown this is the secant method. If F is affine, as in GMRES, n ≤ kHistoryDepth
/// unknowns need at most n + 1 iterations, independent of the convergence of x ← F(x). If f grows
/// by a factor of 100, the history is cleared, and a plain step is made.

#include <cstddef>
#include <vector>

namespace hawser::nonsmooth {

class Anderson {
  public:
    /// Number of iterations in the history.
    static constexpr int kHistoryDepth = 8;

    /// Reserve buffers for n unknowns. @throws std::bad_alloc.
    void reserve(std::size_t n);
    /// Clear the history: earlier iterations belong to another problem.
    void restart() noexcept { count_ = -1; }
    /// Return the buffers for x and F(x) of this iteration, n entries each; next() overwrites both.
    [[nodiscard]] double* x() noexcept { return x_.data(); }
    [[nodiscard]] double* image() noexcept { return image_.data(); }
    /// Compute the next iterate. @param floor  Entries are weighted by 1/(|F(x)| + floor). @return
    /// x₊, n entries.
    [[nodiscard]] const double* next(double floor) noexcept;

  private:
    [[nodiscard]] double* df(int j) noexcept {
        return df_.data() + static_cast<std::size_t>(j) * n_;
    }
    [[nodiscard]] double* dg(int j) noexcept {
        return dg_.data() + static_cast<std::size_t>(j) * n_;
    }
    [[nodiscard]] double* q(int j) noexcept { return q_.data() + static_cast<std::size_t>(j) * n_; }

    std::size_t n_ = 0;
    int count_ = -1;  ///< Number of stored differences, the latest first; −1: no iteration yet.
    double norm_ = 0.0;
    std::vector<double> x_, image_, f_, last_f_, last_image_, df_, dg_, q_, weight_;
};

}  // namespace hawser::nonsmooth
