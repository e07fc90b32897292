// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file samples.h
/// Median, quantiles and maximum of many numbers in bounded memory.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hawser::report {

/// Keeps every number up to `capacity`; beyond, every second of them, then every fourth, and
/// so on. The maximum is that of all numbers.
class Samples {
  public:
    Samples() = default;
    explicit Samples(std::size_t capacity) : capacity_(capacity) {}
    void add(double value);
    /// @param q 0 = smallest, 0.5 = median, 1 = largest of those kept. 0 when there are none.
    [[nodiscard]] double quantile(double q) const;
    [[nodiscard]] double median() const { return quantile(0.5); }
    [[nodiscard]] double max() const noexcept { return max_; }
    [[nodiscard]] std::int64_t count() const noexcept { return count_; }

  private:
    std::size_t capacity_ = 262144;
    std::vector<double> kept_;
    std::int64_t count_ = 0;
    std::int64_t every_ = 1;
    double max_ = 0.0;
};

}  // namespace hawser::report
