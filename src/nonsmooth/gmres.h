// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file gmres.h
/// GMRES: solves A x = b for an operator that is only applied. Source: Y. Saad, M. H. Schultz,
/// "GMRES: a generalized minimal residual algorithm for solving nonsymmetric linear systems", 1986.
/// There is no restart: few iterations are intended, otherwise the caller factorises again.
/// Modified Gram-Schmidt, Givens rotations. Sums have a fixed order, so that a result depends on
/// its inputs alone.

#include <cstddef>
#include <vector>

namespace hawser::nonsmooth {

class Gmres {
  public:
    /// Reserve buffers for vectors of n entries and `iterations` iterations. @throws
    /// std::bad_alloc.
    void reserve(std::size_t n, int iterations);

    /// Start an iteration with x = 0.
    /// @param b  Right-hand side of n entries; the initial residual is ‖b‖.
    void start(std::size_t n, const double* b) noexcept;
    /// Return the vector to which A must be applied next.
    [[nodiscard]] const double* direction() const noexcept { return basis(count_); }
    /// Return the buffer for A direction().
    [[nodiscard]] double* image() noexcept { return basis(count_ + 1); }
    /// Process image(), which must contain A direction(): extend the Krylov space by it. @return
    /// the residual divided by ‖b‖.
    double take() noexcept;
    /// Compute the solution x as a combination of the Krylov directions. @param x  n entries.
    void solution(double* x) noexcept;

    [[nodiscard]] int count() const noexcept { return count_; }
    [[nodiscard]] double start_norm() const noexcept { return norm_; }

  private:
    [[nodiscard]] double* basis(int k) noexcept {
        return basis_.data() + static_cast<std::size_t>(k) * n_;
    }
    [[nodiscard]] const double* basis(int k) const noexcept {
        return basis_.data() + static_cast<std::size_t>(k) * n_;
    }
    [[nodiscard]] double& h(int row, int column) noexcept {
        return h_[static_cast<std::size_t>(column) * (static_cast<std::size_t>(limit_) + 1) +
                  static_cast<std::size_t>(row)];
    }

    std::vector<double> basis_, h_, cosine_, sine_, g_;
    std::size_t n_ = 0;
    int limit_ = 0, count_ = 0;
    double norm_ = 0.0;
};

}  // namespace hawser::nonsmooth
