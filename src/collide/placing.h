// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file placing.h
/// Shapes of a world: what they are, and where they are in the present step.

#include "collide/bounds.h"
#include "collide/geometry.h"
#include "model/bodies.h"
#include "model/interactions.h"

#include <cstdint>

namespace hawser::collide {

/// A shape as added; segments have two bodies.
struct Shape {
    Geometry geometry;
    Placement local;       ///< In the body's frame; of a segment only `x`, see `held`.
    std::int32_t body[2];  ///< Second: −1 unless a segment.
    /// End of a segment that is held at a point of a body, 0 or 1; −1: both are lumps, or the
    /// centre of a fixed body. The point is that at which the element there (`line`) leaves the
    /// body; without one it is `local.x` in the body's frame.
    std::int32_t held;
    std::int32_t owner[2];  ///< See Contacts at shared lumps in reduce.h; −1: the shape itself.
    std::int32_t line;  ///< Interaction that a segment lies along, or −1: it goes when that parts.
    std::int32_t material;
    std::uint32_t group, touches;
    double margin;     ///< Its own [m]; counts where larger than that of all.
    double thickness;  ///< Beyond which something in it comes out behind [m]; infinite: never.
    bool moves;        ///< Some body of it has freedom.
    [[nodiscard]] bool segment() const noexcept { return body[1] >= 0; }
    /// It was removed, and nothing has taken its place.
    [[nodiscard]] bool gone() const noexcept { return body[0] < 0; }
};

/// Velocity of a body [m/s, rad/s], world frame, at its centre of mass.
struct Motion {
    double v[3], w[3];
};
[[nodiscard]] Motion motion_of(const model::Bodies& bodies, std::int32_t body) noexcept;

/// What Shape::held is for a shape with these bodies and this point.
[[nodiscard]] std::int32_t held_end(const Shape& shape, const model::Bodies& bodies) noexcept;

/// A shape in one step.
struct Placed {
    Geometry geometry;  ///< That of a segment has the half_length of the step.
    Placement at;
    Bounds box;         ///< Around the shape where it is; unbounded: ±1e30.
    Bounds swept;       ///< Around all places that it can reach within the step, see place().
    double centre[3];   ///< Of `box`; of an unbounded shape: its origin.
    double radius;      ///< Of the sphere around `box`; 0 of an unbounded shape.
    Motion motion;      ///< Of the body, at `origin`; of a segment: mean velocity of its ends.
    double origin[3];   ///< Centre of mass of the body; of a segment: its middle.
    double stretch[3];  ///< Velocity of a segment's end b against its middle [m/s]; else 0.
    double spread;      ///< Its magnitude.
    double held[3];     ///< Where a body holds a segment (Shape::held), world frame [m].
    bool unbounded;
};

/// Place a shape at the present poses. `swept` holds every place of the shape during a step of h
/// at the present velocities, a turn counted as |ω| times the largest arm, and half of the margin
/// around it, or its own: shapes that can come closer than the margin within the step have boxes
/// that meet. `placed` is that of the last step; its box is kept where nothing moved.
/// @param lines  Where Shape::line is looked up; null: there are none.
void place(const Shape& shape, const model::Bodies& bodies, const model::Interactions* lines,
           double h, double margin, Placed& placed) noexcept;

/// Bound on the speed of two shapes against each other, at any point where they may touch [m/s].
[[nodiscard]] double relative_speed(const Placed& a, const Placed& b) noexcept;

}  // namespace hawser::collide
