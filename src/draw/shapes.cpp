// SPDX-License-Identifier: Apache-2.0
#include "draw/shapes.h"

#include "record/outlines.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace hawser::draw {
namespace {

double cross(const Point& o, const Point& a, const Point& b) {
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

/// Return the convex hull (monotone chain: A. M. Andrew, 1979).
std::vector<Point> convex(std::vector<Point> p) {
    std::sort(p.begin(), p.end(), [](const Point& a, const Point& b) {
        return a.x < b.x || (a.x == b.x && a.y < b.y);
    });
    std::vector<Point> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t first = hull.size();
        for (const Point& q : p) {
            while (hull.size() >= first + 2 && cross(hull[hull.size() - 2], hull.back(), q) <= 0.0)
                hull.pop_back();
            hull.push_back(q);
        }
        hull.pop_back();
        std::reverse(p.begin(), p.end());
    }
    return hull;
}

Vec3 on_body(const record::Frame& frame, const record::RecordedOutline& o, std::size_t point) {
    const Pose& pose = frame.poses[static_cast<std::size_t>(o.body)];
    return pose.position + pose.orientation.normalized() * o.points[point];
}

constexpr Color kEarthLine{150, 128, 96, 255};

/// Draw the intersection of a half-space with the plane of the picture through the middle of the
/// panel.
void draw_plane(Drawing& drawing, const Axes& axes, const View& view, const Vec3& at,
                const Vec3& normal) {
    const double nr = normal[view.right], nu = normal[view.up];
    const double size = std::hypot(nr, nu);
    if (size < 0.1) return;  // the plane is parallel to the picture
    const double r = 0.5 * (axes.x.low + axes.x.high), u = 0.5 * (axes.y.low + axes.y.high);
    // Point of the line nearest to the middle; the depth is that of the plane's own point.
    const double d = (nr * (at[view.right] - r) + nu * (at[view.up] - u)) / size;
    const double er = nr / size, eu = nu / size;
    const double far = 2.0 * (std::abs(axes.x.span()) + std::abs(axes.y.span()));
    const auto point = [&](double along, double out) {
        return axes.at(r + (d + out) * er - along * eu, u + (d + out) * eu + along * er);
    };
    if (std::abs(d) > far) return;
    drawing.add(Path{.points = {point(-far, 0), point(far, 0), point(far, -far), point(-far, -far)},
                     .width = 0.0,
                     .fill = {226, 214, 194, 110},
                     .closed = true});
    drawing.line(point(-far, 0), point(far, 0), kEarthLine, 1.4);
}

}  // namespace

void add_outlines_to_bounds(const record::Recording& recording, const record::Frame& frame,
                            Bounds& bounds) {
    for (const record::RecordedOutline& o : recording.outlines) {
        if (o.kind != record::OutlineKind::solid) continue;
        for (std::size_t i = 0; i < o.points.size(); ++i)
            for (const double r : {-o.radius, o.radius})
                bounds.add(on_body(frame, o, i) + Vec3::Constant(r));
    }
}

void draw_grounds(Drawing& drawing, const Axes& axes, const View& view,
                  const record::Recording& recording, const record::Frame& frame) {
    drawing.add(Clip{axes.frame});
    for (const record::RecordedOutline& o : recording.outlines) {
        if (o.kind == record::OutlineKind::plane) {
            const Pose& pose = frame.poses[static_cast<std::size_t>(o.body)];
            draw_plane(drawing, axes, view, on_body(frame, o, 0),
                       pose.orientation.normalized() * o.points[1]);
        } else if (o.kind == record::OutlineKind::lines) {
            const auto row = static_cast<std::size_t>(o.row);
            for (std::size_t i = 0; i + row <= o.points.size(); i += row) {
                Path path{.points = {}, .stroke = kEarthLine.with_alpha(120), .width = 0.7};
                for (std::size_t k = i; k < i + row; ++k)
                    path.points.push_back(project(axes, view, on_body(frame, o, k)));
                drawing.add(std::move(path));
            }
        }
    }
    drawing.add(Clip{});
}

void draw_solids(Drawing& drawing, const Axes& axes, const View& view,
                 const record::Recording& recording, const record::Frame& frame, bool ghost) {
    for (const record::RecordedOutline& o : recording.outlines) {
        if (o.kind != record::OutlineKind::solid) continue;
        std::vector<Point> points;
        for (std::size_t i = 0; i < o.points.size(); ++i) {
            const Vec3 centre = on_body(frame, o, i);
            const int around = o.radius > 0.0 ? record::kOutlineRim : 1;
            for (int k = 0; k < around; ++k) {
                const double t = 2.0 * std::numbers::pi * k / record::kOutlineRim;
                Vec3 p = centre;
                p[view.right] += o.radius * std::cos(t);
                p[view.up] += o.radius * std::sin(t);
                points.push_back(project(axes, view, p));
            }
        }
        drawing.add(Path{.points = convex(std::move(points)),
                         .stroke = ghost ? Color{205, 210, 216, 255} : Color{52, 62, 74, 255},
                         .width = ghost ? 0.8 : 1.0,
                         .fill = ghost ? kNoColor : Color{176, 186, 200, 120},
                         .closed = true});
    }
}

}  // namespace hawser::draw
