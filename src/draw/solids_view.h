// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file solids_view.h
/// Convex solids in a parallel projection with hidden lines.
///
/// *Order.* Of two convex solids that do not overlap, a plane of a face of one mostly has all of
/// the other behind it: what lies on the side to which the face looks cannot be hidden by the solid
/// if the face looks at the viewer, and cannot hide it if it looks away (M. E. Newell, R. G.
/// Newell, T. L. Sancha, "A solution to the hidden surface problem", 1972). Solids are painted in
/// an order that keeps all of these relations, from far to near where nothing tells and where they
/// go round in a circle. *Lines.* A point is hidden where the ray from it to the viewer meets a
/// solid: the ray is clipped by the planes of its faces (M. Cyrus, J. Beck, 1978), exactly.

#include "draw/drawing.h"
#include "record/solids.h"

#include <hawser/math.h>

#include <array>
#include <vector>

namespace hawser::draw {

/// Where a parallel projection looks from.
struct Camera {
    Vec3 right{0, 1, 0}, up{0, 0, 1};
    Vec3 to_viewer{1, 0, 0};

    /// @param azimuth  From x towards y, of the place of the viewer. @param elevation  [deg]
    [[nodiscard]] static Camera at(double azimuth, double elevation);
    [[nodiscard]] Point flat(const Vec3& p) const { return {p.dot(right), p.dot(up)}; }
};

struct Solid {
    record::Triangles surface;  ///< World frame.
    Color color;
    std::vector<Vec3> normals;              ///< Of its triangles, outwards.
    std::vector<double> offsets;            ///< n · x on each.
    double x0 = 0, x1 = 0, y0 = 0, y1 = 0;  ///< What it covers, as Camera::flat() has it.
    double depth = 0.0;                     ///< Of its middle, towards the viewer.
};

[[nodiscard]] Solid make_solid(record::Triangles surface, Color color, const Camera& camera);

/// Places in `solids`, what is to be painted first first.
[[nodiscard]] std::vector<std::size_t> painting_order(const std::vector<Solid>& solids,
                                                      const Camera& camera);

/// Whether a solid stands between a point and the viewer.
[[nodiscard]] bool is_hidden(const Vec3& p, const std::vector<Solid>& solids, const Camera& camera);

/// What of a polygon lies above a level z, or below (Sutherland and Hodgman, 1974).
[[nodiscard]] std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, double level, bool above);

/// An edge between two triangles of a solid that is worth a line: a crease, or the rim.
struct Crease {
    Vec3 from, to;
};
/// Those of which the viewer sees at least one side.
[[nodiscard]] std::vector<Crease> visible_creases(const Solid& solid, const Camera& camera);

}  // namespace hawser::draw
