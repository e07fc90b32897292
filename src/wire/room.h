// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file room.h
/// How long elements beside a guide or post may be where the next one is near.
///
/// Nodes run through a guide as long as there is an element of wire with a lump on each side of it.
/// Where the next guide is nearer than two elements, elements between both are half of what lies
/// there. Where a wire passes a post that it does not lie on yet, an element with a capsule has to
/// pass that, as parts at guides have none: a lump comes half-way.
/// ```
///     ( A )──── part ────o──── element ────o          o lumps
///                  d/2       ( B )                    d from A along the wire to B
/// ```
/// Limits: what is nearer than 0.2 m along the wire is left alone. A part that moves across by more
/// than a fifth of an element in a step passes a post before a lump has come.

#include <hawser/guide.h>

#include <array>
#include <cstddef>

namespace hawser {
class World;
}

namespace hawser::wire {

/// A post as a guide sees it whose wire passes it.
class PassedPost {
  public:
    struct Apart {
        double gap, share;  ///< Between surface and line [m]; along the line, from its first end.
    };
    /// Whether a wire lies on it.
    [[nodiscard]] virtual bool has(WireId wire) const noexcept = 0;
    /// Where a line passes nearest to it.
    [[nodiscard]] virtual Apart apart(const World& world,
                                      const std::array<Vec3, 2>& line) const = 0;

  protected:
    PassedPost() = default;
    ~PassedPost() = default;
};

/// Length that elements on a side of a guide have now: GuideDef::element_length, or less [m].
/// @param line  The part on that side. @param straight  Of it [m].
[[nodiscard]] double element_beside(const World& world, const GuideDef& def, InteractionId line,
                                    std::size_t side, double straight);

}  // namespace hawser::wire
