// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file rods.h
/// Compute the water loads on a rod of a rigid body (hawser/water_rod.h), in tasks of several
/// segments.

#include <hawser/sea.h>

#include "marine/drag.h"
#include "marine/field.h"

#include <array>
#include <vector>

namespace hawser::marine {

class RodWater {
  public:
    static constexpr int kChunk = 16;  ///< Number of segments of one task.

    explicit RodWater(const WaterRod& def);
    void begin(const World& world) noexcept;
    [[nodiscard]] int chunks() const noexcept { return static_cast<int>(parts_.size()); }
    /// Compute the water loads on the segments of a task.
    void load(const WaterField& field, bool convective, int chunk) noexcept;
    /// Sum the loads that the tasks of load() have computed.
    void finish() noexcept;
    [[nodiscard]] BodyId body() const noexcept { return def_.body; }
    [[nodiscard]] bool any() const noexcept { return any_; }

    /// Loads at the centre of mass, in the layout of BodyLoad.
    std::array<double, 6> force{};
    std::array<double, 21> mass{}, damping{}, stiffness{};

  private:
    /// Sums of the segments of a task.
    struct Part {
        std::array<double, 6> force{};
        std::array<double, 21> mass{}, damping{};
        /// Σ c r rᵀ with r = (1, y, −x), the rise of a segment for heave and rotations of the body:
        /// c = ρ g V/s if the surface cuts the segment, and ρ g V under water.
        std::array<double, 6> cut{}, under{};
        double righting = 0.0;  ///< Σ ρ g V z relative to the centre of mass [N m].
        double deepest = 0.0;   ///< Depth of the lowest point [m].
        bool wet = false, pierced = false;
    };
    void add_segment(const Vec3& arm, const WaterPoint& water, const WaterLaw& law,
                     Part& out) const noexcept;

    WaterRod def_;               ///< With its volume.
    Vec3 along_, side_, other_;  ///< Along the rod and across it, in the body's frame.
    double length_;              ///< Length of a segment [m].
    std::vector<Part> parts_;
    // Values of the present step.
    Vec3 position_{0.0, 0.0, 0.0};
    Twist twist_{};
    Mat3 axes_ = Mat3::Identity();
    Vec3 t_, n_[2];               ///< Along and across, world.
    double vertical_extent_ = 0;  ///< s [m].
    bool any_ = false;
};

}  // namespace hawser::marine
