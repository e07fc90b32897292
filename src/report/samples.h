// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file samples.h
/// Compute median, quantiles and maximum of many numbers in bounded memory.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hawser::report {

/// Stores every number up to `capacity`; beyond, every second number, then every fourth, and so on.
/// The maximum covers all numbers.
class Samples {
  public:
    Samples() = default;
    explicit Samples(std::size_t capacity) : capacity_(capacity) {}
    void add(double value);
    /// Return a quantile of the stored samples; 0 if there are none. @param q  0: smallest, 0.5:
    /// median, 1: largest.
    [[nodiscard]] double quantile(double q) const;
    [[nodiscard]] double median() const { return quantile(0.5); }
    [[nodiscard]] double max() const noexcept { return max_; }
    [[nodiscard]] std::int64_t count() const noexcept { return count_; }

  private:
    std::size_t capacity_ = 262144;
    std::vector<double> samples_;
    std::int64_t count_ = 0;
    std::int64_t sample_interval_ = 1;
    double max_ = 0.0;
};

}  // namespace hawser::report
