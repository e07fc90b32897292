// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file uniform.h
/// Random numbers of cases.

#include <cmath>
#include <cstdint>
#include <random>

namespace hawser::validate {

/// Uniform random numbers between two limits, equal on every machine.
class Uniform {
  public:
    explicit Uniform(std::uint64_t seed) : bits_(seed) {}
    double operator()(double low, double high) {
        return low + (high - low) * static_cast<double>(bits_() >> 11U) * 0x1p-53;
    }
    int whole(int low, int high) { return static_cast<int>(std::floor((*this)(low, high + 1.0))); }

  private:
    std::mt19937_64 bits_;
};

}  // namespace hawser::validate
