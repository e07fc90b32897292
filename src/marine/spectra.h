// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file spectra.h
/// Compute the components of a sea from its definition (hawser/sea.h).

#include <hawser/sea.h>

#include "base/memory.h"

#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

namespace hawser::marine {

inline constexpr double kTwoPi = 2.0 * std::numbers::pi;

/// Draw numbers in [0, 1) from a seed, equal on every machine: SplitMix64 (G. L. Steele, D. Lea, C.
/// H. Flood, "Fast splittable pseudorandom number generators", 2014).
class Draw {
  public:
    explicit Draw(std::uint64_t seed) noexcept : state_(seed) {}
    double operator()() noexcept {
        state_ += 0x9e3779b97f4a7c15U;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
        return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }

  private:
    std::uint64_t state_;
};

/// Append the components of one wave definition, which must be valid.
void add_components(const WaveDef& def, double depth, double gravity,
                    std::vector<WaveComponent>& out);
/// Return the gust components: bins of equal ratio from 1/600 to 0.5 Hz, with a random frequency in
/// each.
[[nodiscard]] std::vector<GustComponent> gust_components(const WindDef& def);
/// Integrate f over [a, b] by Simpson's rule in `pieces` double pieces.
template <class F>
double integral(const F& f, double a, double b, int pieces) noexcept {
    const double h = (b - a) / (2 * pieces);
    double sum = f(a) + f(b);
    for (int i = 1; i < 2 * pieces; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * f(a + i * h);
    return sum * h / 3.0;
}

/// Build the table of wave_sums.h for wave components, padded to a multiple of eight columns.
[[nodiscard]] base::Array<double> wave_table(std::span<const WaveComponent> waves, double depth);

}  // namespace hawser::marine
