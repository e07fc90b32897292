// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file dice.h
/// Random numbers that are equal with every standard library.

#include <hawser/math.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace hawser::bench {

class Dice {
  public:
    Dice(std::uint64_t seed, std::uint64_t number) {
        std::seed_seq both{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                           static_cast<std::uint32_t>(number),
                           static_cast<std::uint32_t>(number >> 32)};
        engine_.seed(both);
    }
    double from(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
    /// Draw a number with a uniform logarithm.
    double spread(double low, double high) { return std::exp(from(std::log(low), std::log(high))); }
    int number(int low, int high) {  // both included
        return std::min(high, low + static_cast<int>(from(0.0, high - low + 1.0)));
    }
    bool chance(double share) { return from(0.0, 1.0) < share; }
    Vec3 vector(double size) {
        const double x = from(-size, size), y = from(-size, size);
        return {x, y, from(-size, size)};
    }
    Vec3 direction() {
        for (;;) {
            const Vec3 v = vector(1.0);
            if (const double n = v.norm(); n > 0.1 && n <= 1.0) return v / n;
        }
    }
    Quat turn() {
        const Vec3 axis = direction();
        return Quat(Eigen::AngleAxisd(from(0.0, 3.1), axis));
    }

  private:
    std::mt19937_64 engine_;
};

}  // namespace hawser::bench
