// SPDX-License-Identifier: Apache-2.0
/// @file
/// Cargo on a deck: a load that is put into a world and removed while it runs.
///
/// Boxes are stacked in twos on a deck that oscillates so strongly that they slide. Before and
/// after the load they hang weightless above it, separately, at almost no cost. No object is added
/// to the world or removed: boxes are moved by World::set_pose(), and their weight is a force.
#pragma once

#include <hawser/hawser.h>

#include <vector>

namespace hawser::bench {

class DeckCargo {
  public:
    static constexpr int kHigh = 2;
    static constexpr double kMass = 1000.0;       ///< Mass of a box of 1 m [kg].
    static constexpr double kFriction = 0.3;      ///< Friction coefficient of all contacts.
    static constexpr double kStiffness = 1e7;     ///< Stiffness of a contact point [N/m].
    static constexpr double kAcceleration = 4.0;  ///< Largest acceleration of the deck [m/s²].
    static constexpr double kFrequency = 3.0;     ///< Frequency of the deck [rad/s].
    /// Speed of the deck, which no box exceeds [m/s].
    static constexpr double kSpeed = kAcceleration / kFrequency;

    /// Add deck and boxes. @param stacks  Number of stacks of kHigh boxes.
    DeckCargo(World& world, int stacks);
    void lower_deck(World& world);
    void remove_boxes(World& world);
    /// Move the deck; called before each step.
    void move_deck(World& world) const;

    [[nodiscard]] const std::vector<BodyId>& boxes() const noexcept { return boxes_; }
    /// Return the deepest penetration of the boxes' contacts in the last step [m].
    [[nodiscard]] double penetration(const World& world) const;
    /// Return the speed of the fastest box [m/s].
    [[nodiscard]] double speed(const World& world) const;

  private:
    BodyId deck_{};
    std::vector<BodyId> boxes_;
    std::vector<Vec3> home_;
    std::int32_t first_shape_ = 0;
    double since_ = 0.0;  ///< Time at which the load was put down [s].
    bool down_ = false;
};

}  // namespace hawser::bench
