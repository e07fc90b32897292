// SPDX-License-Identifier: Apache-2.0
#include "marine/field.h"

#include "marine/spectra.h"

#include <algorithm>
#include <limits>

namespace hawser::marine {
namespace {

/// Cosines and sines of the components at the points of a batch, in double or single precision.
constexpr int kCircleSize = 2 * kMaxWaveComponents * kWavePoints;
static_assert(kMaxWaveComponents % kFastGroup == 0 &&
              kMaxWaveComponents <= kFastGroup * kMaxFastGroups);

}  // namespace

/// Consecutive points that share a reference, or that are summed in double precision.
struct WaterField::Cluster {
    int end = 0;  ///< Behind its last point.
    bool fast = false;
    int groups = 0;
    double x = 0.0, y = 0.0;
    alignas(base::kAlign) float phase[kMaxWaveComponents];
};

/// At most kWavePoints points, from `first` on. Slots beyond `count` repeat the last point.
struct WaterField::Batch {
    int first = 0, count = 0;
    bool fast = false;
    bool motions = false;  ///< True: for velocities and accelerations as well.
    double surface[kWavePoints] = {};
    alignas(base::kAlign) double circle[kCircleSize];

    /// a cos θ and f of the components at each point in single precision.
    [[nodiscard]] float* floats() noexcept { return reinterpret_cast<float*>(circle); }
};

WaterField::WaterField(const Sea& sea, const std::vector<SeaCurrent>& current)
    : sea_(&sea),
      table_(wave_table(sea.components(), sea.depth())),
      padded_(static_cast<int>(table_.size()) / kWaveRows),
      phase_(static_cast<std::size_t>(padded_), 0.0),
      fast_(sea.components(), sea.depth()),
      current_(&current),
      flow_(current.size(), Vec3::Zero()) {}

void WaterField::begin(const SeaMoment& now) noexcept {
    now_ = &now;
    std::copy_n(now.phase.begin(), phase_.size(), phase_.begin());
    fast_.begin(now.phase);
    stretch_by_few_ = now.waves <= 1.0 && now.level >= -0.25 * sea_->depth();
    for (std::size_t i = 0; i < flow_.size(); ++i) flow_[i] = flow_of((*current_)[i], now.current);
}

Vec3 WaterField::current(double z) const noexcept {
    return profile_at(*current_, now_->level - z,
                      [&](std::size_t i) -> const Vec3& { return flow_[i]; });
}

double WaterField::still_depth(double z, double surface) const noexcept {
    return -stretched(sea_->depth(), z, surface);
}

/// Return the number of wave groups to sum for the elevation at a point. All groups are needed if a
/// wave can uncover the point.
int WaterField::surface_groups(const FieldPoint& point) const noexcept {
    const double lowest = now_->level - now_->waves * fast_.highest();
    if (!stretch_by_few_ || !(point.top < lowest)) return fast_.groups();
    return fast_.stretching_groups(still_depth(point.z, lowest));
}

/// Form a cluster of points from `first` on. Batches are appended as long as all points are near
/// enough to the middle of the cluster for single precision.
void WaterField::form_cluster(const FieldPoint* points, int first, int count, bool exact_surface,
                              Cluster& to) const noexcept {
    to.end = std::min(first + kWavePoints, count);
    to.fast = false;
    to.groups = 0;
    if (!fast_.on()) return;
    double low[2] = {points[first].x, points[first].y}, high[2] = {low[0], low[1]};
    for (int begin = first; begin < count; begin += kWavePoints) {
        const int end = std::min(begin + kWavePoints, count);
        double lower[2] = {low[0], low[1]}, upper[2] = {high[0], high[1]};
        int groups = to.groups;
        for (int i = begin; i < end; ++i) {
            lower[0] = std::min(lower[0], points[i].x);
            lower[1] = std::min(lower[1], points[i].y);
            upper[0] = std::max(upper[0], points[i].x);
            upper[1] = std::max(upper[1], points[i].y);
            groups = std::max(groups, exact_surface ? fast_.groups() : surface_groups(points[i]));
        }
        const double reach = fast_.reach(groups);
        const double wide = upper[0] - lower[0], deep = upper[1] - lower[1];
        if (!(wide * wide + deep * deep <= 4.0 * reach * reach)) break;
        std::copy_n(lower, 2, low);
        std::copy_n(upper, 2, high);
        to.end = end;
        to.fast = true;
        to.groups = groups;
    }
    if (!to.fast) return;
    to.x = 0.5 * (low[0] + high[0]);
    to.y = 0.5 * (low[1] + high[1]);
    fast_.kernels().refer(fast_.reference(), fast_.padded(), to.groups, to.x, to.y, to.phase);
}

void WaterField::fast_surfaces(const FieldPoint* points, const Cluster& of,
                               Batch& batch) const noexcept {
    float dx[kWavePoints], dy[kWavePoints];
    for (int i = 0; i < kWavePoints; ++i) {
        const FieldPoint& from = points[batch.first + std::min(i, batch.count - 1)];
        dx[i] = static_cast<float>(from.x - of.x);
        dy[i] = static_cast<float>(from.y - of.y);
    }
    const FastWaveKernels& by = fast_.kernels();
    const auto& compute = batch.motions ? by.surface : by.elevation;
    compute(fast_.table(), of.groups, of.phase, dx, dy, batch.floats(), batch.surface);
}

void WaterField::surfaces(const FieldPoint* points, const Cluster& of,
                          Batch& batch) const noexcept {
    batch.fast = of.fast;
    if (of.fast) {
        fast_surfaces(points, of, batch);
    } else {
        const WaveKernel& by = batch.count == 1 ? wave_kernels().one : wave_kernels().many;
        double x[kWavePoints], y[kWavePoints];
        for (int i = 0; i < kWavePoints; ++i) {
            const FieldPoint& from = points[batch.first + std::min(i, batch.count - 1)];
            x[i] = from.x;
            y[i] = from.y;
        }
        by.surface(table_.data(), padded_, phase_.data(), x, y, batch.circle, batch.surface);
    }
    for (int i = 0; i < batch.count; ++i)
        batch.surface[i] = now_->level + now_->waves * batch.surface[i];
}

void WaterField::motions(const FieldPoint* points, Batch& batch, WaterPoint* out) const noexcept {
    WaveSums sums[kWavePoints];
    if (batch.fast) {
        double depth[kWavePoints] = {};
        FastExtent extent[kWavePoints];
        for (int i = 0; i < batch.count; ++i) {
            depth[i] = still_depth(points[batch.first + i].z, batch.surface[i]);
            extent[i] = fast_.extent(depth[i]);
        }
        fast_.kernels().sums(fast_.table(), extent, batch.floats(), depth, batch.count, sums);
    } else {
        double still[kWavePoints];
        std::fill_n(still, kWavePoints, -std::numeric_limits<double>::infinity());
        for (int i = 0; i < batch.count; ++i)
            still[i] = -still_depth(points[batch.first + i].z, batch.surface[i]);
        const WaveKernel& by = batch.count == 1 ? wave_kernels().one : wave_kernels().many;
        by.sums(table_.data(), padded_, batch.circle, still, sums);
    }
    for (int i = 0; i < batch.count; ++i)
        for (int k = 0; k < 3; ++k) {
            out[i].velocity[k] = now_->waves * sums[i].u[k];
            out[i].acceleration[k] = now_->waves * sums[i].a[k];
        }
}

void WaterField::pressures(const FieldPoint* points, Batch& batch, double* rise) const noexcept {
    double still[kWavePoints], sum[kWavePoints] = {}, deepest = 0.0;
    std::fill_n(still, kWavePoints, -std::numeric_limits<double>::infinity());
    bool wet = false;
    for (int i = 0; i < batch.count; ++i) {
        const double z = points[batch.first + i].z;
        if (!(z < batch.surface[i])) continue;
        still[i] = stretched(sea_->depth(), z, batch.surface[i]);
        deepest = std::max(deepest, -still[i]);
        wet = true;
    }
    if (!wet) return;
    if (batch.fast) {
        FastExtent extent[kWavePoints];
        double depth[kWavePoints] = {};
        for (int i = 0; i < batch.count; ++i) {
            depth[i] = std::min(-still[i], deepest);  // dry points: that of a wet one
            extent[i] = fast_.extent(depth[i]);
        }
        fast_.kernels().pressure(fast_.table(), extent, batch.floats(), depth, batch.count, sum);
    } else {
        const WaveKernel& by = batch.count == 1 ? wave_kernels().one : wave_kernels().many;
        by.pressure(table_.data(), padded_, batch.circle, still, sum);
    }
    for (int i = 0; i < batch.count; ++i)
        if (std::isfinite(still[i])) rise[i] = now_->waves * sea_->density() * sum[i];
}

void WaterField::water(const FieldPoint* points, int count, WaterPoint* out) const noexcept {
    Cluster cluster;
    Batch batch;
    batch.motions = true;
    for (int first = 0; first < count; first += kWavePoints) {
        batch.first = first;
        batch.count = std::min(count - first, kWavePoints);
        std::fill_n(batch.surface, kWavePoints, now_->level);
        if (moves()) {
            if (first >= cluster.end) form_cluster(points, first, count, false, cluster);
            surfaces(points, cluster, batch);
            motions(points, batch, out + first);
        } else {
            std::fill_n(out + first, batch.count, WaterPoint{});
        }
        for (int i = 0; i < batch.count; ++i) {
            WaterPoint& at = out[first + i];
            at.elevation = batch.surface[i];
            at.velocity += current(std::min(points[first + i].z, now_->level));
        }
    }
}

void WaterField::press(const FieldPoint* points, int count, bool waves, double* surface,
                       double* rise) const noexcept {
    std::fill_n(surface, count, now_->level);
    if (rise != nullptr) std::fill_n(rise, count, 0.0);
    if (!waves || !moves()) return;
    Cluster cluster;
    Batch batch;
    for (int first = 0; first < count; first += kWavePoints) {
        batch.first = first;
        batch.count = std::min(count - first, kWavePoints);
        if (first >= cluster.end) form_cluster(points, first, count, true, cluster);
        surfaces(points, cluster, batch);
        std::copy_n(batch.surface, batch.count, surface + first);
        if (rise != nullptr) pressures(points, batch, rise + first);
    }
}

}  // namespace hawser::marine
