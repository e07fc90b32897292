// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file shapes.h
/// Collision shapes, and materials with their contact laws.
///
/// A shape belongs to one body, or is a *segment* between two nodes of a wire. A segment is a
/// capsule whose ends are the nodes; a contact force on it acts on both according to its position.
/// A body may have any number of shapes; without shapes it has no contacts. No contacts arise
/// between shapes of one body, of bodies joined by a segment or joint, or of two bodies without
/// degrees of freedom.
///
/// A segment may also connect a node with a body that holds the wire: at a point, at a drum or at
/// the wheel of a guide. The body then receives its fraction of the contact force, at the lever arm
/// of the contact point, so that momentum and angular momentum are conserved.
/// ```
///     node o═══════╤══════o node        a segment; a force F at the fraction s
///                  │ F                  loads its nodes with (1 − s) F and s F
/// ```
/// Such a segment has no contact with a shape of the holding body if the holding point lies in the
/// shape's bounding sphere. The same applies to shapes of bodies joined to the holding body. Two
/// segments on the same body have no contact with each other within twice the sum of their radii
/// from both holding points.

#include <hawser/id.h>
#include <hawser/math.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace hawser {

/// Kind of a shape.
enum class ShapeKind : std::uint8_t {
    sphere,       ///< Sphere of `radius`.
    capsule,      ///< Cylinder with round ends: `radius`, `half_length` along the shape's z axis. A
                  ///< segment if `body_b` is set.
    box,          ///< Box of `half_size`.
    cylinder,     ///< Cylinder with flat ends: `radius`, `half_length` along the shape's z axis.
    plane,        ///< Half-space below the shape's x-y plane; z points out of the solid.
    heightfield,  ///< Heights of rows × columns nodes over the shape's x-y plane; solid below.
    hull,         ///< Convex hull of `vertices`.
    mesh,  ///< Triangles with contacts on both sides; only on a body without degrees of freedom.
};
/// Return the name of a kind, as in scene files.
[[nodiscard]] const char* to_string(ShapeKind kind) noexcept;

/// Material of a shape: parameters of the contact law.
///
/// Contacts between two materials combine their parameters: geometric means of friction, rolling
/// and torsional resistance, the larger restitution and damping time, and stiffnesses in series.
/// World::add_material_pair() replaces these rules for two given materials.
struct MaterialDef {
    std::string name{};        ///< Unique name among materials. Required.
    double friction = 0.5;     ///< Coulomb friction coefficient μ [1], 0 to 100.
    double restitution = 0.0;  ///< Coefficient of restitution e [1], 0 to 1.
    double stiffness = 1e8;    ///< Normal stiffness of one contact point [N/m], 1 to 1e12.
    /// Ratio of tangential to normal stiffness while sticking [1], 0.01 to 10.
    double tangential = 0.7;
    /// Damping time τ of the contact [s], 0 to 1e3; default (kDefault): two steps.
    double damping_time = std::numeric_limits<double>::quiet_NaN();
    /// Rolling resistance, moment per normal force [m], 0 to 10. Rolling and torsional resistance
    /// act between bodies with an orientation, and require Nonsmooth::newton.
    double rolling = 0.0;
    /// Torsional resistance about the normal, moment per normal force [m], 0 to 10.
    double torsional = 0.0;
};

/// Contact law of two given materials, instead of the combination rules.
struct MaterialPairDef {
    MaterialId a{}, b{};   ///< Materials in any order; may be equal.
    MaterialDef values{};  ///< Parameters of contacts between them; the name is not used.
};

/// Definition of a shape. World::add_shape() copies it.
struct ShapeDef {
    std::string name{};                  ///< Unique name among shapes, or empty.
    ShapeKind kind = ShapeKind::sphere;  ///< Kind of the shape.
    BodyId body{};  ///< Body of the shape; not a scalar body. On a lumped mass only a sphere or a
                    ///< segment. Required.
    /// Second end of a segment (capsule only; `half_length` and `orientation` are then not used).
    /// Invalid: the shape belongs to `body` alone. The ends are lumped masses; one of them may be
    /// another body that is not scalar. On that body the segment ends where the element from `body`
    /// to `body_b` leaves it. Without such an element it ends at `position` in the body's frame. If
    /// that body is fixed and `position` is 0, the end is its centre, and the segment also counts
    /// as a shape of that body.
    BodyId body_b{};
    Vec3 position{0.0, 0.0, 0.0};         ///< Origin of the shape's frame in the body's frame [m].
    Quat orientation = Quat::Identity();  ///< Shape frame to body frame.
    double radius = 0.0;                  ///< Radius [m].
    double half_length = 0.0;             ///< Half length [m].
    Vec3 half_size{0.0, 0.0, 0.0};        ///< Half sizes of a box [m].
    /// Nodes of a heightfield. Node (row i, column j) has the height heights[i columns + j] at x =
    /// (j − (columns − 1)/2) cell[0], y = (i − (rows − 1)/2) cell[1] [m].
    int rows = 0, columns = 0;
    std::array<double, 2> cell{0.0, 0.0};  ///< Spacing of the nodes along x and y [m].
    std::vector<double> heights{};         ///< Heights of the nodes [m].
    std::vector<Vec3> vertices{};          ///< Vertices of a hull or mesh, shape's frame [m].
    std::vector<std::array<std::int32_t, 3>> triangles{};  ///< Vertex indices of a mesh.
    MaterialId material{};    ///< Material; invalid: the world's first one, with the defaults of
                              ///< MaterialDef.
    std::uint32_t group = 1;  ///< Bit mask of the shape's collision groups.
    std::uint32_t touches = ~0U;  ///< Bit mask of accepted groups. Two shapes collide if each
                                  ///< `group` intersects the other's `touches`.
    /// Distance below which the shape gets contacts before it touches [m], up to 1000; values below
    /// WorldDef::contact_margin have no effect. Contacts are predicted with the present velocity
    /// (docs/collision.md). A larger margin also stops bodies that would pass a thin shape by
    /// motion that starts within a step.
    double margin = 0.0;
};

/// Contact point of the last step, also one that does not touch yet.
struct ContactView {
    ShapeId shape[2];      ///< The two shapes; the normal points from the first to the second.
    Vec3 point;            ///< Contact point, world frame [m].
    Vec3 normal;           ///< Unit normal, world frame.
    double gap = 0.0;      ///< Distance of the shapes along the normal [m]; < 0: penetration.
    Vec3 force;            ///< Force on the second shape, world frame [N].
    bool sliding = false;  ///< True if friction is at its bound.
    bool asleep = false;  ///< True if both bodies sleep or are fixed. The force is then that of the
                          ///< last step before they slept.
    // Contact law of the step's impulses, for verification (docs/theory/newton.md). Zeros, except
    // the moment, if asleep.
    double friction = 0.0;    ///< Friction coefficient μ [1].
    double softness[2] = {};  ///< Σ of the normal row and of the two tangential rows [1/kg].
    Vec3 target{0, 0, 0};     ///< b: relative velocity that closes the gap and releases the
                              ///< tangential spring, world frame [m/s].
    // Law of rolling and torsional resistance; zeros also if there is none.
    Vec3 moment{0, 0, 0};                   ///< Moment on the second shape, world frame [N m].
    double rolling = 0.0, torsional = 0.0;  ///< Largest moment per normal force [m].
    double turn_softness = 0.0;             ///< Σ of the three resistance rows [1/(kg m²)].
    Vec3 turn_target{0, 0, 0};              ///< b of the resistance rows, world frame [rad/s].
};

}  // namespace hawser
