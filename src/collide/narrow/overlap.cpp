// SPDX-License-Identifier: Apache-2.0
#include "collide/narrow/overlap.h"

#include <algorithm>
#include <utility>

namespace hawser::collide::narrow {
namespace {

struct Point2 {
    double x, y;
};

/// Projection of a part along the normal, counter-clockwise, with its height over the projection
/// plane.
struct ProjectedPolygon {
    int count;
    Point2 p[kMaxPoly];
    std::uint16_t vertex[kMaxPoly], edge[kMaxPoly];
    V3 base, normal;  ///< Plane of a polygon.
};

struct View {
    V3 n, u, v, centre;
    Point2 project_to_view(const V3& p) const { return {dot(p - centre, u), dot(p - centre, v)}; }
    /// Return the point of a polygon's plane whose projection is q.
    V3 point_over_polygon(const Point2& q, const ProjectedPolygon& s) const {
        const V3 foot = centre + q.x * u + q.y * v;
        return foot + (dot(s.normal, s.base - foot) / dot(s.normal, n)) * n;
    }
};

void project(const View& view, const Poly& poly, ProjectedPolygon& out) {
    out.count = poly.count;
    for (int i = 0; i < poly.count; ++i) {
        out.p[i] = view.project_to_view(poly.p[i]);
        out.vertex[i] = poly.vertex[i];
        out.edge[i] = poly.edge[i];
    }
    if (poly.count < 3) return;
    double area = 0.0;
    V3 normal{0, 0, 0};
    for (int i = 0; i < poly.count; ++i) {
        const int j = i + 1 == poly.count ? 0 : i + 1;
        area += out.p[i].x * out.p[j].y - out.p[j].x * out.p[i].y;
        normal = normal + cross(poly.p[i] - poly.p[0], poly.p[j] - poly.p[0]);
    }
    out.base = poly.p[0];
    out.normal = normalized(normal);
    if (area >= 0.0) return;
    // Reverse the order; edge i runs from i to i + 1.
    std::reverse(out.p, out.p + out.count);
    std::reverse(out.vertex, out.vertex + out.count);
    std::reverse(out.edge, out.edge + out.count - 1);
}

/// Corner of a polygon during clipping. Its name is derived from its two edges.
struct Corner {
    Point2 p;
    std::uint32_t name;
    int next_edge;  ///< Edge to the next corner: edge of a if ≥ 0, else −1 − edge of b.
};

std::uint32_t crossing_name(int edge, int clip_edge) {
    if (edge >= 0) return feature(2, static_cast<unsigned>(edge), static_cast<unsigned>(clip_edge));
    const int other = -1 - edge;
    return feature(1, static_cast<unsigned>(std::min(other, clip_edge)),
                   static_cast<unsigned>(std::max(other, clip_edge)));
}

/// Clip a polygon by a line: keep the part to the left of the line from p to q.
int clip(const Corner* in, int count, const Point2& p, const Point2& q, int clip_edge, double snap,
         Corner* out) {
    const double dx = q.x - p.x, dy = q.y - p.y, length = std::hypot(dx, dy);
    if (!(length > 0.0)) {
        std::copy(in, in + count, out);
        return count;
    }
    const auto side = [&](const Point2& c) {
        return (dx * (c.y - p.y) - dy * (c.x - p.x)) / length;
    };
    int kept = 0;
    for (int i = 0; i < count; ++i) {
        const Corner& from = in[i];
        const Corner& to = in[i + 1 == count ? 0 : i + 1];
        const double d = side(from.p), e = side(to.p);
        const bool inside = d >= -snap, next_inside = e >= -snap;
        if (inside) out[kept++] = from;
        if (inside == next_inside) continue;
        const double t = clamp(d / (d - e), 0.0, 1.0);
        const Point2 at{from.p.x + t * (to.p.x - from.p.x), from.p.y + t * (to.p.y - from.p.y)};
        if (inside) {
            if (d <= snap) {
                out[kept - 1].next_edge = -1 - clip_edge;
            } else {
                out[kept++] = {at, crossing_name(from.next_edge, clip_edge), -1 - clip_edge};
            }
        } else if (e > snap) {
            out[kept++] = {at, crossing_name(from.next_edge, clip_edge), from.next_edge};
        }
    }
    return kept;
}

void add_point(const V3& on0, const V3& on1, const V3& n, std::uint32_t name, Points& out) {
    out.add({on0, on1, n, dot(on1 - on0, n), name});
}

void intersect_polygons(const View& view, const ProjectedPolygon& a, const ProjectedPolygon& b,
                        double snap, Points& out) {
    Corner buffer[2][2 * kMaxPoly];
    Corner *now = buffer[0], *next = buffer[1];
    int count = a.count;
    for (int i = 0; i < count; ++i) now[i] = {a.p[i], feature(0, a.vertex[i], 0), a.edge[i]};
    for (int i = 0; i < b.count && count > 0; ++i) {
        const int j = i + 1 == b.count ? 0 : i + 1;
        count = clip(now, count, b.p[i], b.p[j], b.edge[i], snap, next);
        std::swap(now, next);
    }
    for (int i = 0; i < count; ++i)
        add_point(view.point_over_polygon(now[i].p, a), view.point_over_polygon(now[i].p, b),
                  view.n, now[i].name, out);
}

/// Add the contacts of the part of segment s that projects onto the polygon. @param first  True if
/// the segment belongs to shape 0.
void segment_polygon(const View& view, const Poly& s, const ProjectedPolygon& polygon, bool first,
                     double snap, Points& out) {
    const Point2 p = view.project_to_view(s.p[0]), q = view.project_to_view(s.p[1]);
    const unsigned own = first ? 0U : 1U;
    // Two cuts at one corner of the polygon differ only by rounding; the first edge applies.
    const double parameter_tolerance = snap / norm(s.p[1] - s.p[0]);
    double t[2] = {0.0, 1.0};
    std::uint32_t name[2] = {feature(own, s.vertex[0], 0), feature(own, s.vertex[1], 0)};
    for (int i = 0; i < polygon.count; ++i) {
        const Point2& k = polygon.p[i];
        const Point2& l = polygon.p[i + 1 == polygon.count ? 0 : i + 1];
        const double dx = l.x - k.x, dy = l.y - k.y, length = std::hypot(dx, dy);
        if (!(length > 0.0)) continue;
        const double d = (dx * (p.y - k.y) - dy * (p.x - k.x)) / length;
        const double e = (dx * (q.y - k.y) - dy * (q.x - k.x)) / length;
        if (d < -snap && e < -snap) return;
        if (d >= -snap && e >= -snap) continue;
        const double cut = d / (d - e);
        const int end = d < e ? 0 : 1;
        if (end == 0 ? cut > t[0] + parameter_tolerance : cut < t[1] - parameter_tolerance) {
            t[end] = cut;
            name[end] = feature(2, first ? s.edge[0] : polygon.edge[i],
                                first ? polygon.edge[i] : s.edge[0]);
        }
    }
    if (t[0] > t[1] + parameter_tolerance) return;
    for (int end = 0; end < 2; ++end) {
        const V3 on = s.p[0] + t[end] * (s.p[1] - s.p[0]);
        const V3 other = view.point_over_polygon(view.project_to_view(on), polygon);
        add_point(first ? on : other, first ? other : on, view.n, name[end], out);
        if (t[1] - t[0] <= parameter_tolerance) return;
    }
}

void segments(const View& view, const Poly& a, const Poly& b, double snap, Points& out) {
    const Point2 p = view.project_to_view(a.p[0]), p1 = view.project_to_view(a.p[1]);
    const Point2 q = view.project_to_view(b.p[0]), q1 = view.project_to_view(b.p[1]);
    const Point2 d{p1.x - p.x, p1.y - p.y}, e{q1.x - q.x, q1.y - q.y}, w{q.x - p.x, q.y - p.y};
    const double dd = d.x * d.x + d.y * d.y, ee = e.x * e.x + e.y * e.y;
    const double turn = d.x * e.y - d.y * e.x;
    if (!(dd > 0.0) || !(ee > 0.0)) return;
    const V3 da = a.p[1] - a.p[0], db = b.p[1] - b.p[0];
    // Up to 1 degree from parallel: use the ends of the common length.
    if (turn * turn > 3e-4 * dd * ee) {
        const double s = (w.x * e.y - w.y * e.x) / turn, t = (w.x * d.y - w.y * d.x) / turn;
        const double ds = snap / std::sqrt(dd), dt = snap / std::sqrt(ee);
        if (s < -ds || s > 1.0 + ds || t < -dt || t > 1.0 + dt) return;
        return add_point(a.p[0] + clamp(s, 0.0, 1.0) * da, b.p[0] + clamp(t, 0.0, 1.0) * db, view.n,
                         feature(2, a.edge[0], b.edge[0]), out);
    }
    // Project the ends of b on a.
    double s[2] = {0.0, 1.0};
    std::uint32_t name[2] = {feature(0, a.vertex[0], 0), feature(0, a.vertex[1], 0)};
    double r[2] = {(w.x * d.x + w.y * d.y) / dd, 0.0};
    const double along = (e.x * d.x + e.y * d.y) / dd;
    r[1] = r[0] + along;
    const int low = along < 0.0 ? 1 : 0;
    const double ds = snap / std::sqrt(dd);
    if (r[low] > s[0] + ds) s[0] = r[low], name[0] = feature(1, b.vertex[low], 0);
    if (r[1 - low] < s[1] - ds) s[1] = r[1 - low], name[1] = feature(1, b.vertex[1 - low], 0);
    if (s[0] > s[1]) return;
    for (int end = 0; end < 2; ++end)
        add_point(a.p[0] + s[end] * da, b.p[0] + clamp((s[end] - r[0]) / along, 0.0, 1.0) * db,
                  view.n, name[end], out);
}

}  // namespace

void overlap(const Poly& a, const Poly& b, const V3& n, double separation, double snap,
             Points& out) {
    if (a.count == 1)
        return add_point(a.p[0], a.p[0] + separation * n, n, feature(0, a.vertex[0], b.vertex[0]),
                         out);
    if (b.count == 1)
        return add_point(b.p[0] - separation * n, b.p[0], n, feature(1, b.vertex[0], a.vertex[0]),
                         out);
    View view{n, any_perpendicular(n), {}, a.p[0]};
    view.v = cross(n, view.u);
    if (a.count == 2 && b.count == 2) return segments(view, a, b, snap, out);
    ProjectedPolygon shadow[2];
    if (a.count > 2) project(view, a, shadow[0]);
    if (b.count > 2) project(view, b, shadow[1]);
    if (a.count == 2) return segment_polygon(view, a, shadow[1], true, snap, out);
    if (b.count == 2) return segment_polygon(view, b, shadow[0], false, snap, out);
    intersect_polygons(view, shadow[0], shadow[1], snap, out);
}

}  // namespace hawser::collide::narrow
