// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file shapes.h
/// Shapes that touch, and the materials that say how.
///
/// A shape belongs to one body, or to a *segment* between two lumps of a wire: a capsule whose
/// ends are the lumps, so that contact on it is shared by them according to the place. A body may
/// have any number of shapes; without one it touches nothing. Shapes of the same body, of bodies
/// joined by a segment, and of two bodies without freedom never touch each other.
///
/// A segment may also run from a lump to where a body holds the wire: a point of it, a drum, the
/// wheel of a guide. The body has its share of what touches there, at the lever that keeps momentum
/// and angular momentum. Such a segment does not touch what of that body, or of one that a joint
/// holds to it, has the hold within the sphere around it; of another segment that the same body
/// holds, what is within twice both radii of both holds. What of the body is farther away it
/// touches as all else does.

#include <hawser/id.h>
#include <hawser/math.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace hawser {

enum class ShapeKind : std::uint8_t {
    sphere,       ///< radius.
    capsule,      ///< radius, half_length: along the shape's z; or a segment (body_b).
    box,          ///< half_size.
    cylinder,     ///< radius, half_length along the shape's z; flat ends.
    plane,        ///< Half-space below the shape's x-y plane; z points out of the solid.
    heightfield,  ///< rows × columns heights over the shape's x-y plane; solid below.
    hull,         ///< Convex hull of vertices.
    mesh,         ///< Triangles, on a body without freedom only; both sides touch.
};
[[nodiscard]] const char* to_string(ShapeKind kind) noexcept;

/// What touches how. Where two materials meet, World::add_material_pair decides; without a pair:
/// friction, rolling and torsional resistance: geometric mean; restitution: the larger one;
/// stiffness: the two in series; damping time: the larger one.
struct MaterialDef {
    std::string name{};        ///< Unique among materials. Required.
    double friction = 0.5;     ///< Coulomb coefficient μ, 0 to 100.
    double restitution = 0.0;  ///< e of an impact, 0 to 1.
    double stiffness = 1e8;    ///< Normal stiffness of one contact point [N/m], 1 to 1e12.
    /// Tangential stiffness over normal stiffness while sticking, 0.01 to 10.
    double tangential = 0.7;
    /// Damping time τ of the contact [s], 0 to 1e3; kDefault: two steps.
    double damping_time = std::numeric_limits<double>::quiet_NaN();
    /// Rolling resistance: moment over normal force [m], 0 to 10. This and the next act between
    /// bodies with an orientation, not on lumps and segments, and need Nonsmooth::newton.
    double rolling = 0.0;
    /// Resistance to spinning about the normal: moment over normal force [m], 0 to 10.
    double torsional = 0.0;
};

/// How two given materials touch; replaces the mixing rules.
struct MaterialPairDef {
    MaterialId a{}, b{};   ///< In any order; may be the same one.
    MaterialDef values{};  ///< Its name is not used.
};

struct ShapeDef {
    std::string name{};  ///< Unique among shapes, or empty.
    ShapeKind kind = ShapeKind::sphere;
    BodyId body{};  ///< Required. Scalars have no shape; lumps: sphere or segment.
    /// Second end of a segment (capsule only; half_length, orientation are then not used); invalid:
    /// the shape belongs to `body` alone. One of the two may be a body that is no lump and no
    /// scalar: the end is then where an element of a wire from `body` to `body_b` leaves it, else
    /// `position` in its frame. With a fixed body and `position` 0 the end is its centre, and the
    /// segment counts as a shape of that body, too.
    BodyId body_b{};
    Vec3 position{0.0, 0.0, 0.0};         ///< Of the shape's frame in the body's frame [m].
    Quat orientation = Quat::Identity();  ///< Shape to body.
    double radius = 0.0;                  ///< [m].
    double half_length = 0.0;             ///< [m].
    Vec3 half_size{0.0, 0.0, 0.0};        ///< [m].
    /// Heightfield: height of node (row i, column j) at heights[i columns + j], over
    /// x = (j − (columns − 1)/2) cell[0], y = (i − (rows − 1)/2) cell[1] [m].
    int rows = 0, columns = 0;
    std::array<double, 2> cell{0.0, 0.0};                  ///< [m].
    std::vector<double> heights{};                         ///< [m].
    std::vector<Vec3> vertices{};                          ///< Hull, mesh: shape's frame [m].
    std::vector<std::array<std::int32_t, 3>> triangles{};  ///< Mesh: indices of vertices.
    MaterialId material{};        ///< Invalid: the world's first material, the defaults above.
    std::uint32_t group = 1;      ///< Bits of the groups it is in.
    std::uint32_t touches = ~0U;  ///< Two touch when each's `group` meets the other's `touches`.
    /// How near to it contacts are looked for [m], to 1000, where that is more than the world's
    /// contact_margin. Contacts foresee what comes with its present velocity (docs/methods.md); a
    /// larger margin holds up what is yanked through a thin shape within a step.
    double margin = 0.0;
};

/// One contact point of the last step, for readers.
struct ContactView {
    ShapeId shape[2];      ///< Shapes; the normal points from the first to the second.
    Vec3 point;            ///< World frame [m].
    Vec3 normal;           ///< Unit, world frame.
    double gap = 0.0;      ///< Distance [m]; negative: penetration.
    Vec3 force;            ///< On the second shape, world frame [N].
    bool sliding = false;  ///< Friction at its limit.
    bool asleep = false;   ///< Between bodies that sleep: its force is that of their last step.
    // The law that the step's impulses follow, for checks of it (docs/methods.md, 8). Zeros, the
    // moment apart, where it sleeps.
    double friction = 0.0;    ///< μ.
    double softness[2] = {};  ///< Σ of the normal and of the tangents [1/kg].
    Vec3 target{0, 0, 0};     ///< b: velocity that closes gap and bristle, world frame [m/s].
    // The law of resistance to rolling and spinning; zeros also where there is none.
    Vec3 moment{0, 0, 0};                   ///< On the second shape, world frame [N m].
    double rolling = 0.0, torsional = 0.0;  ///< Moment over normal force, at most [m].
    double turn_softness = 0.0;             ///< Σ [1/(kg m²)].
    Vec3 turn_target{0, 0, 0};              ///< b [rad/s].
};

}  // namespace hawser
