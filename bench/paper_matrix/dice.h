// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file dice.h
/// Random numbers that are equal on every machine and in every release: a counter through the mixer
/// of Steele, Lea, Flood, "Fast splittable pseudorandom number generators" (2014).

#include <cstdint>

namespace hawser::bench {

class Dice {
  public:
    explicit Dice(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15ULL + 1) {}
    std::uint64_t bits() {
        state_ += 0x9E3779B97F4A7C15ULL;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
        return z ^ (z >> 31);
    }
    /// Return a number in [0, 1).
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
    double uniform(double low, double high) { return low + (high - low) * unit(); }
    /// Return a number in [0, count). The bias of the remainder is below 1e-13 for the counts used
    /// here.
    int below(int count) { return static_cast<int>(bits() % static_cast<std::uint64_t>(count)); }

  private:
    std::uint64_t state_;
};

}  // namespace hawser::bench
