// SPDX-License-Identifier: Apache-2.0
#include "marine/spectra.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hawser {

double wave_number(double omega, double depth, double gravity) noexcept {
    // With x = k d and y = ω² d/g, solve x tanh x = y by Newton's method from above, where the
    // function is convex.
    const double y = omega * omega * depth / gravity;
    if (!(y > 0.0)) return 0.0;
    double x = y > 1.0 ? y : std::sqrt(y) * (1.0 + y / 6.0 + 11.0 * y * y / 360.0);
    for (int i = 0; i < 50; ++i) {
        const double t = std::tanh(x), change = (x * t - y) / (t + x * (1.0 - t * t));
        x -= change;
        if (std::abs(change) <= 1e-15 * x) break;
    }
    return x / depth;
}

double wave_spectrum(const WaveDef& def, double omega) noexcept {
    if (!(omega > 0.0)) return 0.0;
    const double peak = marine::kTwoPi / def.period, ratio = peak / omega;
    const double r4 = ratio * ratio * ratio * ratio;
    const double base = 0.3125 * def.height * def.height * r4 / omega * std::exp(-1.25 * r4);
    if (def.kind != WaveKind::jonswap) return base;
    const double width = omega <= peak ? 0.07 : 0.09, off = (omega / peak - 1.0) / width;
    return (1.0 - 0.287 * std::log(def.gamma)) * base *
           std::pow(def.gamma, std::exp(-0.5 * off * off));
}

double gust_spectrum(double speed, double frequency) noexcept {
    constexpr double kIsoExponent = 0.468;  // ISO 19901-1, A.7.4
    if (!(speed > 0.0)) return 0.0;
    const double over_10 = 0.1 * speed;
    const double f = 172.0 * frequency * std::pow(over_10, -0.75);
    return 320.0 * over_10 * over_10 /
           std::pow(1.0 + std::pow(f, kIsoExponent), 5.0 / (3.0 * kIsoExponent));
}

namespace marine {
namespace {

/// Find the direction θ with ∫_{−π}^{θ} cos^2s(φ/2) dφ = fraction of the whole, by bisection of a
/// table.
class Spreading {
  public:
    explicit Spreading(double s) : sum_(kAngleCells + 1, 0.0) {
        const auto density = [&](double angle) { return std::pow(std::cos(0.5 * angle), 2.0 * s); };
        for (int i = 0; i < kAngleCells; ++i)
            sum_[static_cast<std::size_t>(i) + 1] =
                sum_[static_cast<std::size_t>(i)] +
                integral(density, angle_of(i), angle_of(i + 1), 1);
    }
    [[nodiscard]] double angle(double fraction) const {
        const double target_sum = fraction * sum_.back();
        const auto above = std::upper_bound(sum_.begin() + 1, sum_.end() - 1, target_sum);
        const auto cell = static_cast<int>(above - sum_.begin()) - 1;
        const double low = *(above - 1), high = *above;
        return angle_of(cell + (high > low ? (target_sum - low) / (high - low) : 0.5));
    }

  private:
    static constexpr int kAngleCells = 2000;
    static double angle_of(double i) { return std::numbers::pi * (2.0 * i / kAngleCells - 1.0); }
    std::vector<double> sum_;
};

/// Draw one random direction from each of `count` equal fractions of the distribution. The results
/// are in random order.
std::vector<double> directions(const WaveDef& def, Draw& draw) {
    const auto count = static_cast<std::size_t>(def.components);
    std::vector<double> out(count, def.direction);
    if (def.spreading == 0.0) return out;
    const Spreading spread(def.spreading);
    for (std::size_t i = 0; i < count; ++i)
        out[i] += spread.angle((static_cast<double>(i) + draw()) / static_cast<double>(count));
    for (std::size_t i = count - 1; i > 0; --i) {
        const auto other = static_cast<std::size_t>(draw() * static_cast<double>(i + 1));
        std::swap(out[i], out[std::min(other, i)]);
    }
    return out;
}

}  // namespace

void add_components(const WaveDef& def, double depth, double gravity,
                    std::vector<WaveComponent>& out) {
    if (def.kind == WaveKind::regular) {
        const double omega = kTwoPi / def.period;
        out.push_back({0.5 * def.height, omega, wave_number(omega, depth, gravity), def.direction,
                       def.phase});
        return;
    }
    Draw draw(def.seed);
    const std::vector<double> towards = directions(def, draw);
    const std::size_t first = out.size();
    const double peak = kTwoPi / def.period;
    const double low = def.lowest * peak, bin = (def.highest - def.lowest) * peak / def.components;
    double energy = 0.0;
    for (int i = 0; i < def.components; ++i) {
        const double begin = low + i * bin, omega = begin + draw() * bin;
        const double fraction =
            integral([&](double w) { return wave_spectrum(def, w); }, begin, begin + bin, 4);
        energy += fraction;
        out.push_back({std::sqrt(2.0 * fraction), omega, wave_number(omega, depth, gravity),
                       towards[static_cast<std::size_t>(i)], kTwoPi * draw()});
    }
    const double scale = energy > 0.0 ? 0.25 * def.height / std::sqrt(energy) : 0.0;
    for (std::size_t i = first; i < out.size(); ++i) out[i].amplitude *= scale;
}

std::vector<GustComponent> gust_components(const WindDef& def) {
    std::vector<GustComponent> out;
    if (!def.gusts) return out;
    constexpr double kMinFrequency = 1.0 / 600.0, kMaxFrequency = 0.5;
    Draw draw(def.seed);
    const double ratio = std::pow(kMaxFrequency / kMinFrequency, 1.0 / def.components);
    double begin = kMinFrequency;
    for (int i = 0; i < def.components; ++i) {
        const double end = begin * ratio;
        out.push_back({begin + draw() * (end - begin), end - begin, kTwoPi * draw()});
        begin = end;
    }
    return out;
}

}  // namespace marine
}  // namespace hawser
