// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file random.h
/// Random numbers that are equal on every machine (std::uniform_real_distribution is not).

#include <hawser/math.h>

#include <cstdint>
#include <random>
#include <vector>

namespace hawser::test {

class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    /// Return a number in [0, 1).
    double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    double uniform(double low, double high) { return low + (high - low) * unit(); }
    /// Return an integer from low to high, both included.
    int integer(int low, int high) {
        return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
    }
    bool chance(double p) { return unit() < p; }
    Vec3 vector(double size) {
        const double x = uniform(-size, size), y = uniform(-size, size), z = uniform(-size, size);
        return {x, y, z};
    }
    Quat rotation() {
        for (;;) {
            const double w = uniform(-1, 1), x = uniform(-1, 1), y = uniform(-1, 1),
                         z = uniform(-1, 1);
            const Quat q(w, x, y, z);
            if (q.norm() > 0.2 && q.norm() < 1.0) return q.normalized();
        }
    }
    template <class T>
    void shuffle(std::vector<T>& v) {
        for (std::size_t i = v.size(); i > 1; --i)
            std::swap(v[i - 1], v[static_cast<std::size_t>(integer(0, static_cast<int>(i) - 1))]);
    }

  private:
    std::mt19937_64 engine_;
};

}  // namespace hawser::test
