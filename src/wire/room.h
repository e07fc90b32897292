// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file room.h
/// Lengths of elements beside a guide or bollard if the next one is near.
///
/// Nodes run through a guide while there is an element of wire with a node on each side of it. If
/// the next guide is nearer than two elements, the elements between them are half of the length
/// there. If a wire passes a bollard without lying on it yet, an element with a capsule must pass
/// it, since parts at guides have none. So a node is inserted halfway.
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

/// A bollard as seen by a guide whose wire passes it.
class PassedPost {
  public:
    struct Separation {
        /// Gap between surface and line [m]; fraction along the line, from its first end.
        double gap, fraction;
    };
    /// Return true if a wire lies on it.
    [[nodiscard]] virtual bool carries(WireId wire) const noexcept = 0;
    /// Find the nearest point of a line.
    [[nodiscard]] virtual Separation separation(const World& world,
                                                const std::array<Vec3, 2>& line) const = 0;

  protected:
    PassedPost() = default;
    ~PassedPost() = default;
};

/// Return the current length of elements on a side of a guide: GuideDef::element_length or less
/// [m].
/// @param line  The part on that side.
/// @param straight  Its straight length [m].
[[nodiscard]] double element_length_at_guide(const World& world, const GuideDef& def,
                                             InteractionId line, std::size_t side, double straight);

}  // namespace hawser::wire
