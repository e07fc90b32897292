// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hull_flow.h
/// Water past a hull: means over its wet cells, and projected areas (hawser/water_hull.h).

#include <hawser/water_hull.h>

#include "marine/field.h"

#include <vector>

namespace hawser::marine {

/// Projected areas along the body's axes [m²].
struct ProjectedAreas {
    Vec3 wet{0.0, 0.0, 0.0}, dry{0.0, 0.0, 0.0};
};

class HullFlow {
  public:
    /// Create the cells at which the water is sampled.
    /// @param def  Must have a design draught, and outlive this object.
    explicit HullFlow(const WaterHull& def);
    /// Return the number of points at which water is sampled.
    [[nodiscard]] std::size_t count() const noexcept { return cells_.size(); }
    /// Sample the water at cells [begin, end). @param still  The surface is that of still water.
    void sample(const WaterField& field, bool convective, bool still, const Pose& pose,
                const Mat3& axes, std::size_t begin, std::size_t end) noexcept;
    /// Return the largest error of a sampled velocity [m/s]. @param points  Increased by the number
    /// of samples.
    [[nodiscard]] double velocity_error(const WaterField& field, const Pose& pose,
                                        std::int64_t& points) const;
    /// Compute the mean motion of the water over the samples.
    /// @param at_centre  Water at the centre of mass, for a hull without wet cells.
    void finish(const Mat3& axes, const WaterPoint& at_centre) noexcept;

    Vec3 velocity{0.0, 0.0, 0.0}, acceleration{0.0, 0.0, 0.0};  ///< Means [m/s, m/s²].
    Vec3 turn{0.0, 0.0, 0.0}, turn_rate{0.0, 0.0, 0.0};         ///< ω, α, world axes [rad/s, …].
    /// Ratio of projected areas to their values at the design draught, along the body's axes.
    Vec3 wet_fraction{1.0, 1.0, 1.0}, dry_fraction{1.0, 1.0, 1.0};

  private:
    struct Sample {
        Vec3 arm{0.0, 0.0, 0.0};  ///< Arm from the centre of mass, world axes [m].
        Vec3 velocity{0.0, 0.0, 0.0}, acceleration{0.0, 0.0, 0.0};
        double wet = 0.0;  ///< Wetted fraction.
    };
    [[nodiscard]] ProjectedAreas project() noexcept;

    std::vector<HullCell> cells_;
    std::vector<Sample> samples_;
    /// Row of each cell along x, y and z, and the largest wet and dry extents of rows.
    std::vector<std::array<std::int32_t, 3>> row_;
    std::array<std::vector<double>, 3> wet_row_, dry_row_;
    std::array<std::vector<double>, 3>
        width_;  ///< Width of each row across, or its ground area along z.
    ProjectedAreas design_;
    bool small_ = false;  ///< True for small motions about rest: areas have their design values.
};

}  // namespace hawser::marine
