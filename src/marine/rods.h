// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file rods.h
/// A rod of a rigid body in the water (hawser/water_rod.h), in pieces of several segments for
/// several threads.

#include <hawser/sea.h>

#include "marine/drag.h"
#include "marine/field.h"

#include <array>
#include <vector>

namespace hawser::marine {

class RodWater {
  public:
    static constexpr int kChunk = 16;  ///< Segments of one task.

    explicit RodWater(const WaterRod& def);
    void begin(const World& world) noexcept;
    [[nodiscard]] int chunks() const noexcept { return static_cast<int>(parts_.size()); }
    /// What water does to the segments of a task.
    void load(const WaterField& field, bool convective, int chunk) noexcept;
    /// Adds the parts up.
    void finish() noexcept;
    [[nodiscard]] BodyId body() const noexcept { return def_.body; }
    [[nodiscard]] bool any() const noexcept { return any_; }

    /// At the centre of mass, as BodyLoad has them.
    std::array<double, 6> force{};
    std::array<double, 21> mass{}, damping{}, stiffness{};

  private:
    /// Of some segments.
    struct Part {
        std::array<double, 6> force{};
        std::array<double, 21> mass{}, damping{};
        /// Σ c r rᵀ with r = (1, y, −x), by how much a segment rises as the body heaves and turns:
        /// c = ρ g V/s where the surface cuts it, and ρ g V where it is under water.
        std::array<double, 6> cut{}, under{};
        double righting = 0.0;  ///< Σ ρ g V z from the centre of mass [N m].
        double deepest = 0.0;   ///< Of its lowest point [m].
        bool wet = false, pierced = false;
    };
    void add_segment(const Vec3& arm, const WaterPoint& water, const WaterLaw& law,
                     Part& out) const noexcept;

    WaterRod def_;               ///< With its volume.
    Vec3 along_, side_, other_;  ///< Along the rod and across it, in the body's frame.
    double length_;              ///< Of a segment [m].
    std::vector<Part> parts_;
    // Of the step.
    Vec3 position_{0.0, 0.0, 0.0};
    Twist twist_{};
    Mat3 axes_ = Mat3::Identity();
    Vec3 t_, n_[2];     ///< Along and across, world.
    double reach_ = 0;  ///< s [m].
    bool any_ = false;
};

}  // namespace hawser::marine
