// SPDX-License-Identifier: Apache-2.0
#include "collide/narrow/convex.h"

#include "collide/narrow/shape_data.h"

#include <algorithm>

namespace hawser::collide::narrow {

V3 any_perpendicular(const V3& v) {
    // Use the axis along which v has the smallest component.
    const double x = std::fabs(v.x), y = std::fabs(v.y), z = std::fabs(v.z);
    const V3 least = x <= y && x <= z ? V3{1, 0, 0} : (y <= z ? V3{0, 1, 0} : V3{0, 0, 1});
    return normalized(cross(v, least));
}

Convex make_convex(const Geometry& shape, const Placement& placed, const double* origin) {
    Convex o{};
    o.kind = shape.kind;
    o.c = generic::load3(placed.x) - generic::load3(origin);
    o.r = generic::load9(placed.r);
    switch (shape.kind) {
        case ShapeKind::sphere:
            o.rounding = shape.radius;
            break;
        case ShapeKind::capsule:
            o.rounding = shape.radius;
            o.half_length = o.size = shape.half_length;
            break;
        case ShapeKind::cylinder:
            o.radius = shape.radius;
            o.half_length = shape.half_length;
            o.size = std::hypot(o.radius, o.half_length);
            break;
        case ShapeKind::box:
            o.half = generic::load3(shape.half_size);
            o.size = norm(o.half);
            break;
        default:
            o.data = shape.data;
            for (int k = 0; k < 3 && o.data; ++k) {
                const double d = std::max(std::fabs(o.data->low[k]), std::fabs(o.data->high[k]));
                o.size += d * d;
            }
            o.size = std::sqrt(o.size);
    }
    return o;
}

Convex make_triangle(const V3& a, const V3& b, const V3& c) {
    Convex o{};
    o.kind = ShapeKind::mesh;
    o.c = (1.0 / 3.0) * (a + b + c);
    o.corner[0] = a;
    o.corner[1] = b;
    o.corner[2] = c;
    o.face = normalized(cross(b - a, c - a));
    o.size = std::max({norm(a - o.c), norm(b - o.c), norm(c - o.c)});
    return o;
}

namespace {

/// Return the vertex of a hull furthest along m. Climbs from vertex to neighbour: on a convex
/// surface a local maximum is global. A hull of up to 32 vertices is searched completely.
int support_vertex(const ShapeData& hull, const V3& m) {
    const int count = static_cast<int>(hull.vertices.size());
    int best = 0;
    double most = dot(hull.vertices[0], m);
    if (count <= 32) {
        for (int i = 1; i < count; ++i) {
            const double x = dot(hull.vertices[i], m);
            if (x > most) most = x, best = i;
        }
        return best;
    }
    for (bool moved = true; moved;) {
        moved = false;
        const int v = best;
        for (int k = hull.star[v]; k < hull.star[v + 1]; ++k) {
            const HullEdge& e = hull.edges[hull.star_edge[k]];
            const int other = e.vertex[0] == v ? e.vertex[1] : e.vertex[0];
            const double x = dot(hull.vertices[other], m);
            if (x > most) most = x, best = other, moved = true;
        }
    }
    return best;
}

V3 cylinder_support(const Convex& s, const V3& m) {
    const double across = std::sqrt(m.x * m.x + m.y * m.y);
    const double k = across > 0.0 ? s.radius / across : 0.0;
    return {k * m.x, k * m.y, m.z < 0.0 ? -s.half_length : s.half_length};
}

void add(Poly& out, const V3& p, int vertex, int edge) {
    if (out.count == kMaxPoly) return;
    out.p[out.count] = p;
    out.vertex[out.count] = static_cast<std::uint16_t>(vertex);
    out.edge[out.count++] = static_cast<std::uint16_t>(edge);
}

void box_facing(const Convex& s, const V3& m, double tilt, Poly& out) {
    // Axes along which the facing part extends. A vertex is named by the signs of its coordinates,
    // an edge by its axis and the signs of the other two coordinates.
    int free[3], count = 0, base = 0;
    for (int k = 0; k < 3; ++k) {
        if (std::fabs(component(m, k)) <= tilt && count < 2) {
            free[count++] = k;
        } else if (component(m, k) > 0.0) {
            base |= 1 << k;
        }
    }
    const auto vertex = [&](int bits) {
        return s.c + s.r * V3{bits & 1 ? s.half.x : -s.half.x, bits & 2 ? s.half.y : -s.half.y,
                              bits & 4 ? s.half.z : -s.half.z};
    };
    if (count == 0) return add(out, vertex(base), base, 0);
    const int a = 1 << free[0];
    if (count == 1) {
        const int edge = 8 * free[0] + base;
        add(out, vertex(base), base, edge);
        return add(out, vertex(base | a), base | a, edge);
    }
    const int b = 1 << free[1];
    add(out, vertex(base), base, 8 * free[0] + base);
    add(out, vertex(base | a), base | a, 8 * free[1] + (base | a));
    add(out, vertex(base | a | b), base | a | b, 8 * free[0] + (base | b));
    add(out, vertex(base | b), base | b, 8 * free[1] + base);
}

void cylinder_facing(const Convex& s, const V3& m, double tilt, Poly& out) {
    const double across = std::sqrt(m.x * m.x + m.y * m.y);
    const int top = m.z > 0.0 ? 1 : 0;
    const double z = top ? s.half_length : -s.half_length;
    if (across <= tilt) {
        static const struct Rim {
            double x[kCapPoints], y[kCapPoints];
            Rim() {
                for (int i = 0; i < kCapPoints; ++i) {
                    x[i] = std::cos(2.0 * M_PI * i / kCapPoints);
                    y[i] = std::sin(2.0 * M_PI * i / kCapPoints);
                }
            }
        } rim;
        for (int i = 0; i < kCapPoints; ++i)
            add(out, s.c + s.r * V3{s.radius * rim.x[i], s.radius * rim.y[i], z}, 32 * top + i,
                32 * top + i);
        return;
    }
    const double x = m.x * s.radius / across, y = m.y * s.radius / across;
    if (std::fabs(m.z) > tilt) return add(out, s.c + s.r * V3{x, y, z}, 64 + top, 0);
    add(out, s.c + s.r * V3{x, y, -s.half_length}, 66, 68);
    add(out, s.c + s.r * V3{x, y, s.half_length}, 67, 68);
}

void hull_facing(const Convex& s, const V3& m, double tilt, Poly& out) {
    const ShapeData& hull = *s.data;
    const auto place = [&](int v) { return s.c + s.r * hull.vertices[v]; };
    const int v = support_vertex(hull, m);
    int face = -1, edge = -1;
    double best = std::sqrt(1.0 - tilt * tilt), least = tilt;
    for (int k = hull.star[v]; k < hull.star[v + 1]; ++k) {
        const HullEdge& e = hull.edges[hull.star_edge[k]];
        for (const int f : e.face) {
            const double x = dot(hull.faces[f].normal, m);
            if (x >= best && (x > best || face < 0)) best = x, face = f;
        }
        const V3 d = normalized(hull.vertices[e.vertex[1]] - hull.vertices[e.vertex[0]]);
        const double x = std::fabs(dot(d, m));
        if (x <= least && (x < least || edge < 0)) least = x, edge = hull.star_edge[k];
    }
    if (face >= 0) {
        const HullFace& f = hull.faces[face];
        // Skip corners of a face that has too many.
        const int stride = (f.count + kMaxPoly / 2 - 1) / (kMaxPoly / 2);
        for (int i = 0; i < f.count; i += stride)
            add(out, place(hull.loop[f.first + i]), hull.loop[f.first + i],
                hull.loop_edge[f.first + i]);
        return;
    }
    if (edge < 0) return add(out, place(v), v, 0);
    for (const int w : hull.edges[edge].vertex) add(out, place(w), w, edge);
}

void triangle_facing(const Convex& s, const V3& n, double tilt, Poly& out) {
    if (dot(s.face, n) * dot(s.face, n) >= 1.0 - tilt * tilt) {
        for (int k = 0; k < 3; ++k) add(out, s.corner[k], k, k);
        return;
    }
    int edge = -1, vertex = 0;
    double least = tilt;
    for (int k = 1; k < 3; ++k)
        if (dot(s.corner[k] - s.corner[vertex], n) > 0.0) vertex = k;
    for (int k = 0; k < 3; ++k) {
        if (k != vertex && (k + 1) % 3 != vertex) continue;
        const double x = std::fabs(dot(normalized(s.corner[(k + 1) % 3] - s.corner[k]), n));
        if (x <= least) least = x, edge = k;
    }
    if (edge < 0) return add(out, s.corner[vertex], vertex, 0);
    add(out, s.corner[edge], edge, edge);
    add(out, s.corner[(edge + 1) % 3], (edge + 1) % 3, edge);
}

}  // namespace

V3 support(const Convex& s, const V3& n) {
    switch (s.kind) {
        case ShapeKind::sphere:
            return s.c;
        case ShapeKind::capsule: {
            const V3 z = axis(s.r, 2);
            return s.c + (dot(z, n) < 0.0 ? -s.half_length : s.half_length) * z;
        }
        case ShapeKind::box: {
            const V3 m = tmul(s.r, n);
            return s.c + s.r * V3{m.x < 0.0 ? -s.half.x : s.half.x,
                                  m.y < 0.0 ? -s.half.y : s.half.y,
                                  m.z < 0.0 ? -s.half.z : s.half.z};
        }
        case ShapeKind::cylinder:
            return s.c + s.r * cylinder_support(s, tmul(s.r, n));
        case ShapeKind::hull:
            return s.c + s.r * s.data->vertices[support_vertex(*s.data, tmul(s.r, n))];
        default: {
            int best = 0;
            for (int k = 1; k < 3; ++k)
                if (dot(s.corner[k] - s.corner[best], n) > 0.0) best = k;
            return s.corner[best];
        }
    }
}

void facing_polygon(const Convex& s, const V3& n, double tilt, Poly& out) {
    out.count = 0;
    switch (s.kind) {
        case ShapeKind::sphere:
            return add(out, s.c, 0, 0);
        case ShapeKind::capsule: {
            const V3 z = axis(s.r, 2), arm = s.half_length * z;
            const double along = dot(z, n);
            if (std::fabs(along) <= tilt && s.half_length > 0.0) {
                add(out, s.c - arm, 0, 0);
                return add(out, s.c + arm, 1, 0);
            }
            return along > 0.0 ? add(out, s.c + arm, 1, 0) : add(out, s.c - arm, 0, 0);
        }
        case ShapeKind::box:
            return box_facing(s, tmul(s.r, n), tilt, out);
        case ShapeKind::cylinder:
            return cylinder_facing(s, tmul(s.r, n), tilt, out);
        case ShapeKind::hull:
            return hull_facing(s, tmul(s.r, n), tilt, out);
        default:
            return triangle_facing(s, n, tilt, out);
    }
}

}  // namespace hawser::collide::narrow
