// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hull.h
/// Hulls: closed triangle surfaces for water loads, separate from collision shapes, and their
/// hydrostatics.
///
/// The surface z = η divides a hull. The pressure p acts on the part below it, and is linear over
/// each triangle:
/// ```
///        ________            p = ρ g s at each corner, s = η − z its depth
///   ~~~~/~~~~~~~~\~~~~  η    a triangle with corners above and below is cut at s = 0
///       \________/
/// ```
/// A triangle of area A with outward normal n has the pressures p₀ p₁ p₂ at x₀ x₁ x₂. Its exact
/// load is
/// ```
///     F = −n A (p₀ + p₁ + p₂)/3        τ = Σᵢ xᵢ × (−n) A (p₀ + p₁ + p₂ + pᵢ)/12
/// ```
/// Hydrostatics of a mesh are therefore those of its polyhedron, to rounding. Volume and its centre
/// follow from the divergence theorem with the waterplane as lid.
///
/// *Stiffness*. A small displacement and rotation of the body raise its point (x, y) of the
/// waterplane by r·(displacement, rotation), r = (0, 0, 1, y, −x, 0). The stiffness is K = ρ g ∫ r
/// rᵀ dA over the waterplane, positive semi-definite. The moments of weight and buoyancy, ρ g V
/// (z_B − z_G) about x and y, contribute their stable part. The heave stiffness is at least ρ g V
/// over the depth of the lowest point: the secant to the position above the water.
///
/// Source of the formulas: A. B. Biran, *Ship Hydrostatics and Stability*, 2003. Limits: the
/// surface is linear over each triangle, so that triangles must be small compared with waves.

#include <hawser/math.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hawser {

/// Triangle mesh, counterclockwise seen from outside.
struct HullMesh {
    std::vector<Vec3> vertices{};                          ///< Positions [m].
    std::vector<std::array<std::int32_t, 3>> triangles{};  ///< Vertex indices of the corners.
};

/// Check a mesh. Return its fault in words, with the edge or triangle; "": the mesh is closed and
/// consistently oriented, and its normals point outwards.
[[nodiscard]] std::string hull_fault(const HullMesh& mesh);

/// Read a mesh file by its extension: OBJ, STL (text or binary), GDF (WAMIT), or NEMOH (.dat).
/// Corners at equal positions are merged. Polygons are divided into triangles. Halves in GDF and
/// NEMOH files are mirrored.
/// @throws DefError with the line of the fault.
[[nodiscard]] HullMesh read_hull(const std::string& file);

/// Close a mesh of WAMIT or NEMOH, which ends at the waterline, by vertical walls and a deck.
/// @param top  z of the deck, at or above all open edges [m]. If it is their height, no walls are
/// added.
/// @throws DefError if an open edge is more than 1e-3 m below the highest.
void close_hull(HullMesh& mesh, double top);

/// Return a box as a mesh with nx × ny × nz divisions.
/// @param half  Half sizes [m].
[[nodiscard]] HullMesh box_hull(const Vec3& half, int nx = 1, int ny = 1, int nz = 1);

/// Cell of a hull's volume: the part of one cell of an even grid that lies inside the hull,
/// measured on the vertical line through the middle of the grid cell.
struct HullCell {
    Vec3 at{0.0, 0.0, 0.0};               ///< Centre, in the body's frame [m].
    Vec3 size{0.0, 0.0, 0.0};             ///< Size along the body's axes [m].
    std::array<std::int32_t, 3> index{};  ///< Indices of the grid cell.
    /// Return the volume [m³].
    [[nodiscard]] double volume() const noexcept { return size.prod(); }
};
/// Divide a hull into about 200 cells with nearly equal edges, at least one. A mesh without volume
/// has one cell of the size of its bounding box.
[[nodiscard]] std::vector<HullCell> hull_cells(const HullMesh& mesh);

/// Hydrostatics of a mesh below the still surface z = 0.
struct HullStatics {
    double volume = 0.0;                      ///< Displaced volume [m³].
    Vec3 buoyancy{0.0, 0.0, 0.0};             ///< Centre of buoyancy B [m].
    double plane_area = 0.0;                  ///< Area of the waterplane [m²].
    Vec3 plane_centre{0.0, 0.0, 0.0};         ///< Centre of the waterplane [m].
    double inertia_x = 0.0, inertia_y = 0.0;  ///< Second moments of the waterplane about axes
                                              ///< through its centre [m⁴].
    double inertia_xy = 0.0;                  ///< Product moment ∫ x y of the waterplane [m⁴].
    double lowest = 0.0;                      ///< z of the lowest point [m].
};

/// Compute the hydrostatics of a mesh at a pose. Positions of the result are in the world frame.
/// @param level  z of the still surface [m].
[[nodiscard]] HullStatics hull_statics(const HullMesh& mesh, const Pose& pose, double level = 0.0);

/// Equilibrium of a floating hull.
struct Flotation {
    bool floats = false;   ///< False: the hull sinks.
    double draught = 0.0;  ///< Depth of the lowest point below the surface [m].
    Pose pose{};           ///< Pose of the body; its origin is the centre of mass.
    HullStatics statics{};
    double kb = 0.0;       ///< Height of B above the lowest point [m].
    double bm = 0.0;       ///< Transverse metacentric radius I_x/V [m].
    double bm_long = 0.0;  ///< Longitudinal metacentric radius I_y/V [m].
    double kg = 0.0;       ///< Height of the centre of mass above the lowest point [m].
    double gm = 0.0;       ///< Metacentric height KB + BM − KG [m].
    double trim = 0.0;     ///< Rotation about y, positive bow down [rad].
};

/// Compute the equilibrium of a hull at a heel angle about the body's x axis, with its centre of
/// mass at the mesh's origin. Method: Newton iterations for the sinkage.
/// @param mass  Mass [kg].
/// @param density  Density of the water [kg/m³].
/// @param heel  Heel angle [rad].
/// @param trims  True: the hull turns about the heeled y axis until that moment is zero. False: the
/// x axis stays level.
[[nodiscard]] Flotation float_hull(const HullMesh& mesh, double mass, double density,
                                   double heel = 0.0, bool trims = false);
/// Compute the righting lever at a heel angle [m]: horizontal distance of B from G, positive if it
/// rights the hull.
[[nodiscard]] double righting_lever(const HullMesh& mesh, double mass, double density, double heel,
                                    bool trims = false);

}  // namespace hawser
