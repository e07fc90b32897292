// SPDX-License-Identifier: Apache-2.0
#include "marine/field.h"

#include "marine/spectra.h"

#include <algorithm>
#include <limits>

namespace hawser::marine {
namespace {

/// Cosines and sines of the components at the points of a call.
constexpr int kCircle = 2 * kMaxWaveComponents * kWavePoints;

}  // namespace

WaterField::WaterField(const Sea& sea, const std::vector<SeaCurrent>& current)
    : sea_(&sea),
      table_(wave_table(sea.components(), sea.depth())),
      padded_(static_cast<int>(table_.size()) / kWaveRows),
      phase_(static_cast<std::size_t>(padded_), 0.0),
      current_(&current),
      flow_(current.size(), Vec3::Zero()) {}

void WaterField::begin(const SeaMoment& now) noexcept {
    now_ = &now;
    std::copy_n(now.phase.begin(), phase_.size(), phase_.begin());
    for (std::size_t i = 0; i < flow_.size(); ++i) flow_[i] = flow_of((*current_)[i], now.current);
}

Vec3 WaterField::current(double z) const noexcept {
    return profile_at(*current_, now_->level - z,
                      [&](std::size_t i) -> const Vec3& { return flow_[i]; });
}

/// Places beyond `count` have the last point again.
const WaveKernel& WaterField::surfaces(const Vec3* points, int count, double* circle,
                                       double* surface) const noexcept {
    const WaveKernel& by = count == 1 ? wave_kernels().one : wave_kernels().many;
    double x[kWavePoints], y[kWavePoints];
    for (int i = 0; i < kWavePoints; ++i) {
        const Vec3& from = points[std::min(i, count - 1)];
        x[i] = from.x();
        y[i] = from.y();
    }
    by.surface(table_.data(), padded_, phase_.data(), x, y, circle, surface);
    for (int i = 0; i < count; ++i) surface[i] = now_->level + now_->waves * surface[i];
    return by;
}

void WaterField::water(const Vec3* points, int count, WaterPoint* out) const noexcept {
    std::fill_n(out, count, WaterPoint{});
    double surface[kWavePoints];
    std::fill_n(surface, kWavePoints, now_->level);
    if (moves()) {
        alignas(base::kAlign) double circle[kCircle];
        double still[kWavePoints];
        const WaveKernel& by = surfaces(points, count, circle, surface);
        std::fill_n(still, kWavePoints, -std::numeric_limits<double>::infinity());
        for (int i = 0; i < count; ++i)
            still[i] = stretched(sea_->depth(), points[i].z(), surface[i]);
        WaveSums sums[kWavePoints];
        by.sums(table_.data(), padded_, circle, still, sums);
        for (int i = 0; i < count; ++i) add_waves(sums[i], *now_, sea_->density(), out[i]);
    }
    for (int i = 0; i < count; ++i) {
        const double z = points[i].z();
        out[i].elevation = surface[i];
        out[i].velocity += current(std::min(z, now_->level));
        if (z < surface[i])
            out[i].pressure =
                sea_->density() * sea_->gravity() * (now_->level - z) + out[i].dynamic_pressure;
    }
}

void WaterField::press(const Vec3* points, int count, bool waves, double* surface,
                       double* rise) const noexcept {
    std::fill_n(surface, count, now_->level);
    if (rise != nullptr) std::fill_n(rise, count, 0.0);
    if (!waves || !moves()) return;
    alignas(base::kAlign) double circle[kCircle];
    double sum[kWavePoints], still[kWavePoints];
    const WaveKernel& by = surfaces(points, count, circle, sum);
    std::copy_n(sum, count, surface);
    if (rise == nullptr) return;
    std::fill_n(still, kWavePoints, -std::numeric_limits<double>::infinity());
    bool wet = false;
    for (int i = 0; i < count; ++i) {
        if (!(points[i].z() < surface[i])) continue;
        still[i] = stretched(sea_->depth(), points[i].z(), surface[i]);
        wet = true;
    }
    if (!wet) return;
    by.pressure(table_.data(), padded_, circle, still, sum);
    for (int i = 0; i < count; ++i) rise[i] = now_->waves * sea_->density() * sum[i];
}

}  // namespace hawser::marine
