// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file placing.h
/// Shapes of a world, and their placement in the present step.

#include "collide/bounds.h"
#include "collide/geometry.h"
#include "model/bodies.h"
#include "model/interactions.h"

#include <cstdint>

namespace hawser::collide {

/// A shape as added; a segment has two bodies.
struct Shape {
    Geometry geometry;
    Placement local;  ///< Placement in the frame of the body; of a segment only `x`, see `held`.
    std::int32_t body[2];  ///< Bodies; the second is −1 unless the shape is a segment.
    /// End of a segment that is held at a point of a body, 0 or 1. −1: both ends are nodes or the
    /// centre of a fixed body. The point is where the element there (`line`) leaves the body;
    /// without an element it is `local.x` in the frame of the body.
    std::int32_t held;
    /// Owner at each end, see is_duplicate() in match.h; −1: the shape itself.
    std::int32_t owner[2];
    /// Interaction that a segment lies along, or −1; the segment is removed if it breaks.
    std::int32_t line;
    std::int32_t material;
    std::uint32_t group, touches;
    double margin;  ///< Own margin [m]; applies if larger than the common one.
    /// Depth above which a shape inside it leaves on the far side [m]; infinite: never.
    double thickness;
    bool moves;  ///< True if at least one of its bodies has degrees of freedom.
    [[nodiscard]] bool segment() const noexcept { return body[1] >= 0; }
    /// True if the shape was removed and its slot is vacant.
    [[nodiscard]] bool is_removed() const noexcept { return body[0] < 0; }
};

/// Velocity of a body at its centre of mass, world frame [m/s, rad/s].
struct Motion {
    double v[3], w[3];
};
[[nodiscard]] Motion motion_of(const model::Bodies& bodies, std::int32_t body) noexcept;

/// Return which end of the segment of a shape a body holds (Shape::held), 0 or 1; −1 if there is
/// none.
[[nodiscard]] std::int32_t held_segment_end(const Shape& shape,
                                            const model::Bodies& bodies) noexcept;

/// A shape in one step.
struct Placed {
    Geometry geometry;  ///< Geometry; a segment has the half_length of this step.
    Placement at;
    Bounds box;  ///< Bounding box at the present pose; unbounded: ±1e30.
    /// Bounding box of all poses that the shape can reach within the step, see place().
    Bounds swept;
    double centre[3];  ///< Centre of `box`; for an unbounded shape its origin.
    double radius;     ///< Radius of the sphere around `box`; 0 for an unbounded shape.
    /// Motion of the body at `origin`; for a segment the mean velocity of its ends.
    Motion motion;
    double origin[3];   ///< Centre of mass of the body; for a segment its middle.
    double stretch[3];  ///< Velocity of end b of a segment relative to its middle [m/s]; else 0.
    double spread;      ///< Magnitude of `stretch`.
    double held[3];     ///< Point at which a body holds a segment (Shape::held), world frame [m].
    bool unbounded;
};

/// Place a shape at the present poses. `swept` contains every pose of the shape during a step of h
/// at the present velocities. A rotation counts as |ω| times the largest arm. Half of the margin is
/// added, or half of the shape's own margin if that is larger. If two shapes can come closer than
/// the margin within the step, their boxes therefore intersect. @param lines  Interactions for
/// Shape::line; null: none. @param placed  Data of the last step; the box is kept if nothing moved.
void place(const Shape& shape, const model::Bodies& bodies, const model::Interactions* lines,
           double h, double margin, Placed& placed) noexcept;

/// Return a bound on the relative speed of two shapes at any point of contact [m/s].
[[nodiscard]] double relative_speed(const Placed& a, const Placed& b) noexcept;

}  // namespace hawser::collide
