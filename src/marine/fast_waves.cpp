// SPDX-License-Identifier: Apache-2.0
#include "marine/fast_waves.h"

#include "marine/spectra.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace hawser::marine {
namespace {

constexpr double kLeftOut =
    kKinematicTolerance / 8.0;  ///< Error of the components that are left out.
constexpr double kPhaseFraction = 0.375 * kKinematicTolerance;  ///< Error of rounded phases.
constexpr double kFloatRounding = 0x1p-24;                      ///< Unit of rounding.
constexpr double kNoBottom = 16.0;  ///< Where e^(−2kd + kζ) is below 1.2e-7 it is left out.

/// Amplitudes at still water of one component.
struct Motion {
    double elevation, velocity, acceleration, pressure;
};
Motion motion_of(const WaveComponent& w, double depth) noexcept {
    const double coth = 1.0 / std::tanh(w.wave_number * depth);
    const double speed = w.amplitude * w.frequency * coth;
    return {w.amplitude, speed, speed * w.frequency, speed * w.frequency / w.wave_number};
}

/// Return the significant amplitude: twice the root of half the sum of squares.
template <class Amplitude>
double significant_of(std::span<const WaveComponent> waves, const Amplitude& amplitude) {
    double sum = 0.0;
    for (const WaveComponent& w : waves) sum += amplitude(w) * amplitude(w);
    return std::sqrt(2.0 * sum);
}

/// Return the least depth in [0, deepest] at which a decreasing function is ≤ `limit`; infinite if
/// there is none.
template <class Falling>
double depth_of(const Falling& falling, double deepest, double limit) {
    if (falling(0.0) <= limit) return 0.0;
    if (!(falling(deepest) <= limit)) return std::numeric_limits<double>::infinity();
    double low = 0.0, high = deepest;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (falling(middle) <= limit ? high : low) = middle;
    }
    return high;
}

}  // namespace

FastWaves::FastWaves(std::span<const WaveComponent> waves, double depth)
    : sea_depth_(depth), kernels_(&fast_wave_kernels()) {
    if (static_cast<int>(waves.size()) <= kFewComponents) return;
    sort(waves);
    significant_.elevation = significant_of(
        waves_, [&](const WaveComponent& w) { return motion_of(w, sea_depth_).elevation; });
    significant_.velocity = significant_of(
        waves_, [&](const WaveComponent& w) { return motion_of(w, sea_depth_).velocity; });
    significant_.acceleration = significant_of(
        waves_, [&](const WaveComponent& w) { return motion_of(w, sea_depth_).acceleration; });
    significant_.pressure = significant_of(
        waves_, [&](const WaveComponent& w) { return motion_of(w, sea_depth_).pressure; });
    if (!(reach_of(waves_.size()) > 0.0)) return;
    padded_ = static_cast<int>((waves_.size() + kFastGroup - 1) / kFastGroup) * kFastGroup;
    fill_tables();
    find_depths();
    list_extents();
    for (int g = 0; g <= groups(); ++g)
        reach_.push_back(reach_of(static_cast<std::size_t>(g) * kFastGroup));
}

void FastWaves::sort(std::span<const WaveComponent> waves) {
    order_.resize(waves.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t i, std::size_t j) {
        return waves[i].wave_number < waves[j].wave_number;
    });
    for (const std::size_t i : order_) {
        waves_.push_back(waves[i]);
        highest_ += waves[i].amplitude;
    }
}

void FastWaves::fill_tables() {
    const auto padded = static_cast<std::size_t>(padded_);
    const WaveComponent& longest = waves_.front();
    gravity_ = longest.frequency * longest.frequency /
               (longest.wave_number * std::tanh(longest.wave_number * sea_depth_));
    table_.assign(kFastRows * padded, 0.0F);
    reference_.assign(kReferenceRows * padded, 0.0);
    middle_.assign(kMaxFastGroups, 0.0F);
    width_.assign(kMaxFastGroups, 0.0F);
    const auto middle_of = [&](std::size_t group) {
        const std::size_t last = std::min((group + 1) * kFastGroup, waves_.size()) - 1;
        return 0.5 * (waves_[group * kFastGroup].wave_number + waves_[last].wave_number);
    };
    for (std::size_t i = 0; i < waves_.size(); ++i) {
        const WaveComponent& w = waves_[i];
        const auto set = [&](FastRow row, double value) {
            table_[static_cast<std::size_t>(row) * padded + i] = static_cast<float>(value);
        };
        const double dx = std::cos(w.direction), dy = std::sin(w.direction), k = w.wave_number;
        const double rate = -w.frequency / std::expm1(-2.0 * k * sea_depth_);
        reference_[kReferenceX * padded + i] = k * dx / kTwoPi;
        reference_[kReferenceY * padded + i] = k * dy / kTwoPi;
        set(kFastPhaseX, 2.0 * k * dx / kTwoPi);
        set(kFastPhaseY, 2.0 * k * dy / kTwoPi);
        set(kFastAmplitude, w.amplitude);
        set(kFastDecay, -k * std::numbers::log2e);
        const double middle = middle_of(i / kFastGroup);
        set(kFastOffset, middle - k);
        float& width = width_[i / kFastGroup];
        width = std::max(width, static_cast<float>(std::abs(middle - k)));
        middle_[i / kFastGroup] = static_cast<float>(-middle * std::numbers::log2e);
        const double bottom = std::exp(-2.0 * k * sea_depth_);
        set(kFastBottom, bottom > 1e-37 ? bottom : 0.0);  // no denormal number
        set(kFastPressure, 1.0 / (1.0 + bottom));
        set(kFastSpeedX, rate * dx);
        set(kFastSpeedY, rate * dy);
        set(kFastRateZ, rate * w.frequency);
        set(kFastSpeedZ, w.amplitude * rate);
        set(kFastRateX, w.amplitude * rate * w.frequency * dx);
        set(kFastRateY, w.amplitude * rate * w.frequency * dy);
    }
    for (std::size_t g = 0; g < padded; g += kFastGroup) lowest_.push_back(waves_[g].wave_number);
}

void FastWaves::find_depths() {
    const double d = sea_depth_;
    const auto decay = [&](const WaveComponent& w, double depth) {
        return (std::exp(-w.wave_number * depth) + std::exp(-w.wave_number * (2.0 * d - depth))) /
               (1.0 + std::exp(-2.0 * w.wave_number * d));
    };
    const auto sums_from = [&](std::size_t first, double depth, bool slope) {
        double speed = 0.0, rate = 0.0, pressure = 0.0;
        for (std::size_t i = first; i < waves_.size(); ++i) {
            const Motion m = motion_of(waves_[i], d);
            const double e = decay(waves_[i], depth) * (slope ? waves_[i].wave_number : 1.0);
            speed += m.velocity * e;
            rate += m.acceleration * e;
            pressure += m.pressure * e;
        }
        return std::max({speed / significant_.velocity, rate / significant_.acceleration,
                         pressure / significant_.pressure});
    };
    const bool column_stays = d >= 4.0 * highest_;  // and levels above −d/4: ∂z'/∂η ≤ 2
    for (std::size_t first = 0; first < waves_.size(); first += kFastGroup) {
        below_.push_back(
            depth_of([&](double z) { return sums_from(first, z, false); }, d, kLeftOut));
        double tail = 0.0;
        for (std::size_t i = first; i < waves_.size(); ++i) tail += waves_[i].amplitude;
        stretch_below_.push_back(
            column_stays ? depth_of([&](double z) { return 2.0 * tail * sums_from(0, z, true); }, d,
                                    kLeftOut)
                         : std::numeric_limits<double>::infinity());
    }
}

/// Fill the table of the numbers of wave groups that must be summed at each depth. A row applies
/// from its depth to that of the next row. Contributions decrease with depth, except those that the
/// bottom changes, which increase.
void FastWaves::list_extents() {
    const auto count = [&](const auto& holds) {
        int n = 0;
        while (n < groups() && holds(static_cast<std::size_t>(n))) ++n;
        return n;
    };
    rows_per_metre_ = static_cast<double>(kExtentRows - 1) / sea_depth_;
    for (std::size_t i = 0; i < kExtentRows; ++i) {
        const double low = static_cast<double>(i) / rows_per_metre_;
        const double high = low + 1.0 / rows_per_metre_;
        FastExtent row;
        row.groups = count([&](std::size_t g) { return low < below_[g]; });
        // Kinematics use the phases of the elevation, so at least as many groups are needed.
        row.stretching =
            std::max(row.groups, count([&](std::size_t g) { return low < stretch_below_[g]; }));
        row.bottom = std::min(row.groups, count([&](std::size_t g) {
                                  return lowest_[g] * (2.0 * sea_depth_ - high) < kNoBottom;
                              }));
        extents_.push_back(row);
    }
}

/// Return the largest distance from the reference point at which the phase error keeps its fraction
/// of the tolerance. The error of a phase is at most 2π 2^−24 (3/2 + 1.13 k r), as |k_x x| + |k_y
/// y| ≤ √2 k r. Rounding is independent for each component, with a standard deviation of 1/√3 of
/// the largest error.
double FastWaves::reach_of(std::size_t components) const {
    const auto error = [&](double r) {
        double worst = 0.0;
        const auto add = [&](double Motion::* of) {
            double sum = 0.0, all = 0.0;
            for (std::size_t i = 0; i < waves_.size(); ++i) {
                const WaveComponent& w = waves_[i];
                const double a = motion_of(w, sea_depth_).*of;
                const double off = kTwoPi * kFloatRounding * (1.5 + 1.13 * w.wave_number * r);
                sum += i < components ? a * a * off * off : 0.0;
                all += a * a;
            }
            worst = std::max(worst, all > 0.0 ? std::sqrt(3.0 * sum / all) : 0.0);  // 6/(2 √3)
        };
        add(&Motion::elevation);
        add(&Motion::velocity);
        add(&Motion::acceleration);
        add(&Motion::pressure);
        return worst;
    };
    if (!(error(0.0) < kPhaseFraction)) return 0.0;
    double low = 0.0, high = 1e6;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (error(middle) <= kPhaseFraction ? low : high) = middle;
    }
    return low;
}

void FastWaves::begin(std::span<const double> phase) noexcept {
    double* const to = reference_.data() + kReferencePhase * padded_;
    for (std::size_t i = 0; i < order_.size() && padded_ > 0; ++i) to[i] = phase[order_[i]];
}

}  // namespace hawser::marine
