// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file room.h
/// Lengths of elements next to a guide or bollard if the next one is near.
///
/// Nodes run through a guide while there is an element of wire with a node on each side of it. If
/// the next guide is nearer than two elements, the elements between both guides have half of the
/// length between them. If a wire passes a bollard that it has not engaged, the bollard can engage
/// only an element with a capsule. Parts at guides have no capsule, so a node is inserted halfway.
/// ```
///     ( A )──── part ────o──── element ────o          o nodes
///                  d/2       ( B )                    d from A along the wire to B
/// ```
/// Limits: distances below 0.2 m along the wire are left unchanged. A part that moves across by
/// more than a fifth of an element in a step passes a bollard before a node is inserted.

#include <hawser/guide.h>

#include <array>
#include <cstddef>

namespace hawser {
class World;
}

namespace hawser::wire {

/// Data of a bollard for a guide whose wire passes the bollard.
class PassedPost {
  public:
    struct Separation {
        /// Gap between surface and line [m]; fraction along the line, from its first end.
        double gap, fraction;
    };
    /// Return true if a wire lies on the bollard.
    [[nodiscard]] virtual bool carries(WireId wire) const noexcept = 0;
    /// Return the gap between the bollard and a line, and the nearest point on the line.
    [[nodiscard]] virtual Separation separation(const World& world,
                                                const std::array<Vec3, 2>& line) const = 0;

  protected:
    PassedPost() = default;
    ~PassedPost() = default;
};

/// Return the length of the elements that a guide inserts on one side at present [m]. It is at most
/// GuideDef::element_length, and less if another guide or bollard is near.
/// @param line  The part of the wire on that side.
/// @param straight  Length of the straight piece of this part [m].
[[nodiscard]] double element_length_at_guide(const World& world, const GuideDef& def,
                                             InteractionId line, std::size_t side, double straight);

}  // namespace hawser::wire
