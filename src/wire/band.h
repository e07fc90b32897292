// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file band.h
/// Symmetric band matrices of wires in a plane.

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hawser::wire {

/// A symmetric band matrix of half width 5: two coordinates per node, bending over three nodes.
class Band {
  public:
    static constexpr std::size_t kBandWidth = 6;

    explicit Band(std::size_t rows) : rows_(rows), a_(rows * kBandWidth, 0.0) {}
    void clear() { std::fill(a_.begin(), a_.end(), 0.0); }
    /// Return the entry of row i and column j ≤ i of the symmetric band matrix.
    double& at(std::size_t i, std::size_t j) { return a_[i * kBandWidth + (i - j)]; }
    /// Factor the matrix as L D Lᵀ in place.
    /// @return false if a pivot is not positive.
    bool factor() {
        for (std::size_t i = 0; i < rows_; ++i) {
            const std::size_t first = i >= kBandWidth - 1 ? i - (kBandWidth - 1) : 0;
            for (std::size_t j = first; j < i; ++j) {
                double sum = at(i, j);
                for (std::size_t k =
                         std::max(first, j >= kBandWidth - 1 ? j - (kBandWidth - 1) : 0);
                     k < j; ++k)
                    sum -= at(i, k) * at(j, k) * at(k, k);
                at(i, j) = sum / at(j, j);
            }
            double pivot = at(i, i);
            const double before = pivot;
            for (std::size_t k = first; k < i; ++k) pivot -= at(i, k) * at(i, k) * at(k, k);
            if (!(pivot > 1e-13 * before)) return false;
            at(i, i) = pivot;
        }
        return true;
    }
    void solve(std::vector<double>& x) {
        for (std::size_t i = 0; i < rows_; ++i)
            for (std::size_t k = i >= kBandWidth - 1 ? i - (kBandWidth - 1) : 0; k < i; ++k)
                x[i] -= at(i, k) * x[k];
        for (std::size_t i = 0; i < rows_; ++i) x[i] /= at(i, i);
        for (std::size_t i = rows_; i-- > 0;)
            for (std::size_t k = i >= kBandWidth - 1 ? i - (kBandWidth - 1) : 0; k < i; ++k)
                x[k] -= at(i, k) * x[i];
    }

  private:
    std::size_t rows_;
    std::vector<double> a_;
};

}  // namespace hawser::wire
