// SPDX-License-Identifier: Apache-2.0
/// @file
/// A load that is put into a world and taken away again while it runs: cargo on a deck.
///
/// Boxes are stacked in twos on a deck that moves to and fro, so hard that they slide. Until the
/// load begins, and after it has ended, they hang weightless above it, one by one, where they cost
/// next to nothing. Nothing is added to the world or removed from it on the way: they are moved
/// with World::set_pose(), and their weight is a force.
#pragma once

#include <hawser/hawser.h>

#include <vector>

namespace hawser::bench {

class DeckCargo {
  public:
    static constexpr int kHigh = 2;
    static constexpr double kMass = 1000.0;       ///< Of a box of 1 m [kg].
    static constexpr double kFriction = 0.3;      ///< Of all that touches.
    static constexpr double kStiffness = 1e7;     ///< Of a contact point [N/m].
    static constexpr double kAcceleration = 4.0;  ///< Of the deck, at most [m/s²].
    static constexpr double kFrequency = 3.0;     ///< Of the deck [rad/s].
    /// No box can be faster than the deck that takes it along [m/s].
    static constexpr double kSpeed = kAcceleration / kFrequency;

    /// Adds deck and boxes. @param stacks  Of kHigh boxes each.
    DeckCargo(World& world, int stacks);
    void set_down(World& world);
    void take_away(World& world);
    /// Before each step.
    void move_deck(World& world) const;

    [[nodiscard]] const std::vector<BodyId>& boxes() const noexcept { return boxes_; }
    /// Deepest penetration of a contact of the boxes in the last step [m].
    [[nodiscard]] double penetration(const World& world) const;
    /// Of the fastest box [m/s].
    [[nodiscard]] double speed(const World& world) const;

  private:
    BodyId deck_{};
    std::vector<BodyId> boxes_;
    std::vector<Vec3> home_;
    std::int32_t first_shape_ = 0;
    double since_ = 0.0;  ///< [s]
    bool down_ = false;
};

}  // namespace hawser::bench
