// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file solids_view.h
/// Draw convex solids in a parallel projection with hidden lines.
///
/// Order of painting: take two convex solids that do not overlap. Usually all of one lies in front
/// of the plane of a face of the other. If the face points at the viewer, the solid in front cannot
/// be hidden by the other. If it points away, the solid in front cannot hide the other. Source: M.
/// E. Newell, R. G. Newell, T. L. Sancha, "A solution to the hidden surface problem", 1972. The
/// painting order keeps all these relations. Undecided or cyclic pairs are painted from far to
/// near.
///
/// Hidden lines: a point is hidden if the ray from it to the viewer meets a solid. The ray is
/// clipped exactly by the planes of the solid's faces (M. Cyrus, J. Beck, 1978).

#include "draw/drawing.h"
#include "record/solids.h"

#include <hawser/math.h>

#include <array>
#include <vector>

namespace hawser::draw {

/// Directions of a parallel projection.
struct Camera {
    Vec3 right{0, 1, 0}, up{0, 0, 1};
    Vec3 to_viewer{1, 0, 0};

    /// Return the camera at a direction. @param azimuth  Azimuth of the viewer, from x towards y
    /// [deg]. @param elevation  Elevation of the viewer [deg].
    [[nodiscard]] static Camera at(double azimuth, double elevation);
    [[nodiscard]] Point flat(const Vec3& p) const { return {p.dot(right), p.dot(up)}; }
};

struct Solid {
    record::Triangles surface;  ///< Surface in the world frame [m].
    Color color;
    std::vector<Vec3> normals;    ///< Outward normals of its triangles.
    std::vector<double> offsets;  ///< Value n · x on each triangle [m].
    /// Covered rectangle, in coordinates of Camera::flat() [m].
    double x0 = 0, x1 = 0, y0 = 0, y1 = 0;
    double depth = 0.0;  ///< Depth of its centre, towards the viewer [m].
};

[[nodiscard]] Solid make_solid(record::Triangles surface, Color color, const Camera& camera);

/// Return the indices of `solids` in painting order.
[[nodiscard]] std::vector<std::size_t> painting_order(const std::vector<Solid>& solids,
                                                      const Camera& camera);

/// True if a solid is between a point and the viewer.
[[nodiscard]] bool is_hidden(const Vec3& p, const std::vector<Solid>& solids, const Camera& camera);

/// Return the part of a polygon above or below a level z (Sutherland and Hodgman, 1974).
[[nodiscard]] std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, double level, bool above);

/// Edge between two triangles of a solid that is drawn as a line: a crease or the rim.
struct Crease {
    Vec3 from, to;
};
/// Return the creases with at least one side visible to the viewer.
[[nodiscard]] std::vector<Crease> visible_creases(const Solid& solid, const Camera& camera);

}  // namespace hawser::draw
