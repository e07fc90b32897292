// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file field.h
/// Water at many points of one moment, as lines and hulls ask for it: kWavePoints at a time, and
/// what all points share computed once.

#include <hawser/sea.h>

#include "base/memory.h"
#include "marine/wave_sums.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace hawser::marine {

/// Wheeler's z' of a point z of a column under a surface; 0 at the surface and above.
[[nodiscard]] inline double stretched(double depth, double z, double elevation) noexcept {
    if (!(z < elevation)) return 0.0;
    const double column = depth + elevation;
    if (!(column > 0.0) || z <= -depth) return -depth;
    return depth * (z + depth) / column - depth;
}

/// What flows at one depth of a profile.
[[nodiscard]] inline Vec3 flow_of(const SeaCurrent& c, double factor) noexcept {
    const double speed = factor * c.speed;
    return {speed * std::cos(c.direction), speed * std::sin(c.direction), 0.0};
}

/// A profile at a depth below the level: its flows, `flow` of place i, linearly between them.
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
    const double share = (depth - a.depth) / (b.depth - a.depth);
    return (1.0 - share) * flow(i - 1) + share * flow(i);
}

/// What sums of waves do at a point, all amplitudes by the factor of the moment.
inline void add_waves(const WaveSums& s, const SeaMoment& now, double density,
                      WaterPoint& out) noexcept {
    for (int k = 0; k < 3; ++k) {
        out.velocity[k] += now.waves * s.u[k];
        out.acceleration[k] += now.waves * s.a[k];
    }
    out.dynamic_pressure = now.waves * density * s.p;
}

class WaterField {
  public:
    /// @param sea, current  Stay where they are; those of one definition.
    WaterField(const Sea& sea, const std::vector<SeaCurrent>& current);
    /// Begins a moment, which stays where it is until the next one.
    void begin(const SeaMoment& now) noexcept;

    [[nodiscard]] const Sea& sea() const noexcept { return *sea_; }
    [[nodiscard]] const SeaMoment& now() const noexcept { return *now_; }

    /// As Sea::water() and Sea::elevation() have it, but for rounding. @param count  1 to
    /// kWavePoints.
    void water(const Vec3* points, int count, WaterPoint* out) const noexcept;
    /// Elevation of the surface, and the dynamic pressure of what is below it. @param waves
    /// Without them the surface is that of still water. @param rise  Null: not asked for.
    void press(const Vec3* points, int count, bool waves, double* surface,
               double* rise) const noexcept;
    /// As Sea::current() has it.
    [[nodiscard]] Vec3 current(double z) const noexcept;

  private:
    [[nodiscard]] bool moves() const noexcept { return padded_ > 0 && now_->waves != 0.0; }
    const WaveKernel& surfaces(const Vec3* points, int count, double* circle,
                               double* surface) const noexcept;

    const Sea* sea_;
    const SeaMoment* now_ = nullptr;
    base::Array<double> table_;  ///< wave_table() of the sea.
    int padded_ = 0;
    base::Array<double> phase_;  ///< Of the moment, aligned.
    const std::vector<SeaCurrent>* current_;
    std::vector<Vec3> flow_;  ///< At its depths, now [m/s].
};

}  // namespace hawser::marine
