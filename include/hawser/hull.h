// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hull.h
/// Hulls: closed surfaces of triangles, apart from collision shapes, and what still water does to
/// them.
///
/// A hull is cut by the surface z = η; what is below is pressed by p, linear over each triangle:
/// ```
///        ________            p = ρ g s at each corner, s = η − z its depth
///   ~~~~/~~~~~~~~\~~~~  η    a triangle with corners above and below is cut at s = 0
///       \________/
/// ```
/// Over a triangle of area A with normal n (outwards) and pressures p₀ p₁ p₂ at x₀ x₁ x₂
/// ```
///     F = −n A (p₀ + p₁ + p₂)/3        τ = Σᵢ xᵢ × (−n) A (p₀ + p₁ + p₂ + pᵢ)/12
/// ```
/// exactly, so that hydrostatics of a mesh are those of its polyhedron to rounding. Volume and its
/// centre follow from the divergence theorem with the waterplane as lid.
///
/// *Tangent.* Where the hull moves by (x, φ), each piece of the waterplane at (x, y) rises by
/// r = (0, 0, 1, y, −x, 0)·(x, φ): K = ρ g ∫ r rᵀ dA over the waterplane. It is positive
/// semi-definite; of the moments of weight and buoyancy, ρ g V (z_B − z_G) about x and y, it takes
/// in what is stable. Up and down it is at least ρ g V over the depth of the lowest point, the
/// secant to where the hull is out of the water.
///
/// Source of the formulas: A. B. Biran, *Ship Hydrostatics and Stability*, 2003. Limits: the
/// surface is linear over each triangle, so that triangles are to be small against waves.

#include <hawser/math.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hawser {

/// Triangles, counterclockwise seen from outside.
struct HullMesh {
    std::vector<Vec3> vertices{};                          ///< [m].
    std::vector<std::array<std::int32_t, 3>> triangles{};  ///< Corners by number.
};

/// What is wrong with a mesh, in words with the edge or triangle; "": it is closed, consistent and
/// its normals point outwards.
[[nodiscard]] std::string hull_fault(const HullMesh& mesh);

/// Read an OBJ file, an STL file, text or binary, a GDF file (WAMIT) or a mesh of NEMOH (.dat), by
/// its ending; corners at the same place become one. Polygons are cut into triangles; halves of
/// GDF and NEMOH files get their mirror images. @throws DefError with the line where it is wrong.
[[nodiscard]] HullMesh read_hull(const std::string& file);

/// Meshes of WAMIT and NEMOH end at the waterline: walls up from there, and a deck.
/// @param top  z of the deck, above that of all open edges [m]; at it: a deck alone.
/// @throws DefError where an edge is open that does not lie within 1e-3 m of the highest.
void close_hull(HullMesh& mesh, double top);

/// A box as a mesh; each side of nx × ny × nz pieces. @param half  Half sizes [m].
[[nodiscard]] HullMesh box_hull(const Vec3& half, int nx = 1, int ny = 1, int nz = 1);

/// A block of a hull's volume: what lies inside the mesh on the vertical line through the middle of
/// a cell of an even grid, between two levels of the grid.
struct HullCell {
    Vec3 at{0.0, 0.0, 0.0};               ///< Its middle, in the body's frame [m].
    Vec3 size{0.0, 0.0, 0.0};             ///< Along the body's axes [m].
    std::array<std::int32_t, 3> index{};  ///< Of the grid's cell.
    [[nodiscard]] double volume() const noexcept { return size.prod(); }
};
/// Cut a hull into some 200 cells of about equal edges; at least one. A mesh without volume has one
/// of the size of its box.
[[nodiscard]] std::vector<HullCell> hull_cells(const HullMesh& mesh);

/// A mesh under the still surface z = 0.
struct HullStatics {
    double volume = 0.0;                      ///< [m³].
    Vec3 buoyancy{0.0, 0.0, 0.0};             ///< Its centre, B [m].
    double plane_area = 0.0;                  ///< Of the waterplane [m²].
    Vec3 plane_centre{0.0, 0.0, 0.0};         ///< Of it [m].
    double inertia_x = 0.0, inertia_y = 0.0;  ///< Of it about axes through its centre [m⁴].
    double inertia_xy = 0.0;                  ///< ∫ x y [m⁴].
    double lowest = 0.0;                      ///< z of the lowest point [m].
};

/// Of a mesh at a pose, under z = level. Positions are in the world frame.
[[nodiscard]] HullStatics hull_statics(const HullMesh& mesh, const Pose& pose, double level = 0.0);

/// A hull afloat.
struct Flotation {
    bool floats = false;   ///< False: it sinks.
    double draught = 0.0;  ///< From the surface to the lowest point [m].
    Pose pose{};           ///< Of the body, whose centre of mass is its origin.
    HullStatics statics{};
    double kb = 0.0;       ///< B above the lowest point [m].
    double bm = 0.0;       ///< I_x/V, about x [m].
    double bm_long = 0.0;  ///< I_y/V, about y [m].
    double kg = 0.0;       ///< Centre of mass above the lowest point [m].
    double gm = 0.0;       ///< KB + BM − KG [m].
    double trim = 0.0;     ///< About y, positive bow down [rad].
};

/// Where a hull of a mass floats at a heel (about the body's x axis) [rad], with its centre of mass
/// at the origin of the mesh: sinkage by Newton's method. The x axis stays level, or
/// @param trims  turns about the heeled y axis until the moment about that is gone.
[[nodiscard]] Flotation float_hull(const HullMesh& mesh, double mass, double density,
                                   double heel = 0.0, bool trims = false);
/// Righting lever at a heel [m]: horizontal distance of B from G, positive where it rights.
[[nodiscard]] double righting_lever(const HullMesh& mesh, double mass, double density, double heel,
                                    bool trims = false);

}  // namespace hawser
