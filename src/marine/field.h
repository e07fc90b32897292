// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file field.h
/// Compute the water at many points at one time, for lines and hulls. Seas of more than
/// FastWaves::kFewComponents components are summed in single precision, within kKinematicTolerance
/// (fast_waves.h); others in double precision.

#include <hawser/sea.h>

#include "base/memory.h"
#include "marine/fast_waves.h"
#include "marine/wave_sums.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace hawser::marine {

/// Return Wheeler's stretched z' of a point z below a surface; 0 at the surface and above.
[[nodiscard]] inline double stretched(double depth, double z, double elevation) noexcept {
    if (!(z < elevation)) return 0.0;
    const double column = depth + elevation;
    if (!(column > 0.0) || z <= -depth) return -depth;
    return depth * (z + depth) / column - depth;
}

/// Return the current of one entry of a profile, multiplied by a factor [m/s].
[[nodiscard]] inline Vec3 flow_of(const SeaCurrent& c, double factor) noexcept {
    const double speed = factor * c.speed;
    return {speed * std::cos(c.direction), speed * std::sin(c.direction), 0.0};
}

/// Interpolate a profile linearly at a depth below the level. @param flow  flow(i): current of
/// entry i.
template <class Flow>
[[nodiscard]] Vec3 profile_at(const std::vector<SeaCurrent>& profile, double depth,
                              const Flow& flow) noexcept {
    if (profile.empty()) return Vec3::Zero();
    const auto below = std::upper_bound(profile.begin(), profile.end(), depth,
                                        [](double d, const SeaCurrent& c) { return d < c.depth; });
    const auto i = static_cast<std::size_t>(below - profile.begin());
    if (i == 0) return flow(0);
    if (i == profile.size()) return flow(i - 1);
    const SeaCurrent &a = profile[i - 1], &b = profile[i];
    const double fraction = (depth - a.depth) / (b.depth - a.depth);
    return (1.0 - fraction) * flow(i - 1) + fraction * flow(i);
}

/// Add the sums of waves to the water at a point, with all amplitudes multiplied by the wave factor
/// of the present time.
inline void add_waves(const WaveSums& s, const SeaMoment& now, double density,
                      WaterPoint& out) noexcept {
    for (int k = 0; k < 3; ++k) {
        out.velocity[k] += now.waves * s.u[k];
        out.acceleration[k] += now.waves * s.a[k];
    }
    out.dynamic_pressure = now.waves * density * s.p;
}

/// A point at which water is computed.
struct FieldPoint {
    double x = 0.0, y = 0.0, z = 0.0;  ///< [m].
    double top = 0.0;                  ///< z of the highest part of the object at the point [m].

    FieldPoint() = default;
    FieldPoint(const Vec3& at, double highest) noexcept
        : x(at.x()), y(at.y()), z(at.z()), top(highest) {}
};

class WaterField {
  public:
    static constexpr int kMostPoints = 64;  ///< Maximum number of points of one call.

    /// Create the water field.
    /// @param sea, current  Must outlive the field. `current` belongs to the same definition.
    WaterField(const Sea& sea, const std::vector<SeaCurrent>& current);
    /// Set the time of the water. `now` must outlive the following calls.
    void begin(const SeaMoment& now) noexcept;

    [[nodiscard]] const Sea& sea() const noexcept { return *sea_; }
    [[nodiscard]] const SeaMoment& now() const noexcept { return *now_; }
    [[nodiscard]] const FastWaves& fast() const noexcept { return fast_; }

    /// Compute elevation, velocity and acceleration like Sea::water(), without pressures. The
    /// elevation is approximate if no wave can uncover FieldPoint::top. @param count  0 to
    /// kMostPoints.
    void water(const FieldPoint* points, int count, WaterPoint* out) const noexcept;
    /// Compute the elevation of the water surface above points, and the dynamic pressure at points
    /// below it. @param waves  False: the surface is still water. @param surface  Output: elevation
    /// [m]. @param rise  Output: pressure; null: not required.
    void press(const FieldPoint* points, int count, bool waves, double* surface,
               double* rise) const noexcept;
    /// Return the current, like Sea::current().
    [[nodiscard]] Vec3 current(double z) const noexcept;

  private:
    struct Batch;
    struct Cluster;

    [[nodiscard]] bool moves() const noexcept { return padded_ > 0 && now_->waves != 0.0; }
    [[nodiscard]] double still_depth(double z, double surface) const noexcept;
    [[nodiscard]] int surface_groups(const FieldPoint& point) const noexcept;
    void form_cluster(const FieldPoint* points, int first, int count, bool exact_surface,
                      Cluster& to) const noexcept;
    void surfaces(const FieldPoint* points, const Cluster& of, Batch& batch) const noexcept;
    void fast_surfaces(const FieldPoint* points, const Cluster& of, Batch& batch) const noexcept;
    void motions(const FieldPoint* points, Batch& batch, WaterPoint* out) const noexcept;
    void pressures(const FieldPoint* points, Batch& batch, double* rise) const noexcept;

    const Sea* sea_;
    const SeaMoment* now_ = nullptr;
    base::Array<double> table_;  ///< wave_table() of the sea.
    int padded_ = 0;
    base::Array<double> phase_;  ///< Phases at the time of the step, aligned.
    FastWaves fast_;
    bool stretch_by_few_ = false;  ///< FastWaves::stretching_groups() is valid at this moment.
    const std::vector<SeaCurrent>* current_;
    std::vector<Vec3> flow_;  ///< At its depths, now [m/s].
};

}  // namespace hawser::marine
