// SPDX-License-Identifier: Apache-2.0
#include "collide/narrow/polish.h"

#include "collide/narrow/shape_data.h"

namespace hawser::collide::narrow {
namespace {

/// Normals of faces and directions of edges that may be exact where the guess is approximate.
struct NearbyFeatures {
    int faces = 0, edges = 0;
    V3 face[8], edge[16];
    void add_face(const V3& n) {
        if (faces < 8) face[faces++] = n;
    }
    void add_edge(const V3& e) {
        if (edges < 16) edge[edges++] = e;
    }
};

/// Accuracy required of a guess [rad]; GJK and EPA are far more accurate.
constexpr double kGuessAccuracy = 0.05;

/// Collect the faces of `s` with normals near n, and the edges nearly perpendicular to n.
void collect_nearby(const Convex& s, const V3& n, NearbyFeatures& out) {
    const double near_cos = 1.0 - 0.5 * kGuessAccuracy * kGuessAccuracy;
    switch (s.kind) {
        case ShapeKind::box:
        case ShapeKind::cylinder:
        case ShapeKind::capsule:
            for (int k = s.kind == ShapeKind::box ? 0 : 2; k < 3; ++k) {
                const V3 e = axis(s.r, k);
                const double x = dot(e, n);
                if (std::fabs(x) < kGuessAccuracy) out.add_edge(e);
                if (std::fabs(x) > near_cos && s.kind != ShapeKind::capsule)
                    out.add_face(x > 0.0 ? e : -e);
            }
            break;
        case ShapeKind::hull: {
            const V3 m = tmul(s.r, n), p = tmul(s.r, support(s, n) - s.c);
            const ShapeData& hull = *s.data;
            const double level = dot(p, m) - kGuessAccuracy * s.size;
            for (const HullFace& f : hull.faces)
                if (dot(f.normal, m) > near_cos) out.add_face(s.r * f.normal);
            for (const HullEdge& e : hull.edges) {
                const V3 &v = hull.vertices[e.vertex[0]], &w = hull.vertices[e.vertex[1]];
                if (dot(v, m) < level || dot(w, m) < level) continue;
                const V3 d = normalized(w - v);
                if (std::fabs(dot(d, m)) < kGuessAccuracy) out.add_edge(s.r * d);
            }
            break;
        }
        case ShapeKind::mesh: {
            const double x = dot(s.face, n);
            if (std::fabs(x) > near_cos) out.add_face(x > 0.0 ? s.face : -s.face);
            for (int k = 0; k < 3; ++k) {
                const V3 e = normalized(s.corner[(k + 1) % 3] - s.corner[k]);
                if (std::fabs(dot(e, n)) < kGuessAccuracy) out.add_edge(e);
            }
            break;
        }
        default:
            break;
    }
}

V3 gradient(const Convex& a, const Convex& b, const V3& n) {
    return support(b, -n) - support(a, n);
}

/// Find the maximum of s(n) over n perpendicular to e, near the guess. Bisection on the slope along
/// the circle also finds kinks. @return false if no maximum is nearby.
bool maximum_around_edge(const Convex& a, const Convex& b, const V3& e, const V3& guess, V3& n) {
    const V3 across = guess - dot(guess, e) * e;
    const V3 u = normalized(across), v = cross(e, u);
    const auto slope = [&](double x) {
        const double c = std::cos(x), s = std::sin(x);
        return dot(c * v - s * u, gradient(a, b, c * u + s * v));
    };
    // Other maxima may be near: shrink the bracket until it contains one.
    double low = 0.0, high = 0.0, at_low = 0.0, at_high = 0.0;
    for (double reach = 2.0 * kGuessAccuracy; at_low <= 0.0 || at_high >= 0.0; reach *= 0.1) {
        if (reach < 1e-7) return false;
        low = -reach;
        high = reach;
        at_low = slope(low);
        at_high = slope(high);
    }
    // False position that halves the weight of an unchanged end (Illinois), with a bisection if
    // convergence is slow.
    int kept = 0;
    for (int i = 0; i < 80 && high - low > 1e-15; ++i) {
        double x = low + (high - low) * at_low / (at_low - at_high);
        if (i % 4 == 3 || !(x > low) || !(x < high)) x = 0.5 * (low + high);
        const double y = slope(x);
        if (y > 0.0) {
            low = x;
            at_low = y;
            if (kept == 1) at_high *= 0.5;
            kept = 1;
        } else if (y < 0.0) {
            high = x;
            at_high = y;
            if (kept == -1) at_low *= 0.5;
            kept = -1;
        } else {
            low = high = x;
        }
    }
    const double x = 0.5 * (low + high);
    n = std::cos(x) * u + std::sin(x) * v;
    return true;
}

/// Add the second derivative of the support function of a rim to a 2×2 matrix over (u, v).
void add_curvature(const Convex& s, const V3& n, const V3& u, const V3& v, double* h) {
    if (s.kind != ShapeKind::cylinder) return;
    const V3 z = axis(s.r, 2), tangent = cross(z, n);
    const double across = norm(tangent);
    if (across < 1e-9) return;
    const double k = s.radius / (across * across * across);
    const double tu = dot(tangent, u), tv = dot(tangent, v);
    h[0] += k * tu * tu;
    h[1] += k * tu * tv;
    h[2] += k * tv * tv;
}

/// Find a maximum of s on the sphere by Newton's method, where s is smooth.
V3 newton_maximum(const Convex& a, const Convex& b, V3 n) {
    for (int i = 0; i < 8; ++i) {
        const V3 u = any_perpendicular(n), v = cross(n, u), g = gradient(a, b, n);
        double h[3] = {0.0, 0.0, 0.0};
        add_curvature(a, n, u, v, h);
        add_curvature(b, n, u, v, h);
        // Negative second derivative of s along the sphere.
        const double s = dot(g, n);
        h[0] += s;
        h[2] += s;
        const double det = h[0] * h[2] - h[1] * h[1];
        if (!(det > 0.0) || !(h[0] > 0.0)) return n;  // no maximum here
        const double gu = dot(g, u), gv = dot(g, v);
        const double x = (h[2] * gu - h[1] * gv) / det, y = (h[0] * gv - h[1] * gu) / det;
        if (!(x * x + y * y < 4.0 * kGuessAccuracy * kGuessAccuracy)) return n;
        n = normalized(n + x * u + y * v);
        if (x * x + y * y < 1e-30) return n;
    }
    return n;
}

}  // namespace

double separation_along(const Convex& a, const Convex& b, const V3& n) {
    return dot(n, gradient(a, b, n));
}

Separation polish(const Convex& a, const Convex& b, const V3& guess, double most) {
    Separation best{guess, separation_along(a, b, guess)};
    const double size = a.size + b.size;
    // In a tie, normals of faces precede normals of edges, and these precede iterated ones.
    const double tie = 1e-14 * size;
    bool exact = false;
    const auto propose = [&](const V3& n) {
        const double s = separation_along(a, b, n);
        if (s > best.s + (exact ? tie : -tie)) best = {n, s}, exact = true;
    };
    // An exact normal at the upper bound ends the search; an iterated one may still be 1e-6 off.
    const double enough = most - 1e-13 * size;
    NearbyFeatures of_a, of_b;
    collect_nearby(a, guess, of_a);
    collect_nearby(b, -guess, of_b);
    for (int i = 0; i < of_a.faces; ++i) propose(of_a.face[i]);
    for (int i = 0; i < of_b.faces; ++i) propose(-of_b.face[i]);
    if (exact && best.s >= enough) return best;
    for (int i = 0; i < of_a.edges; ++i)
        for (int j = 0; j < of_b.edges; ++j) {
            const V3 m = cross(of_a.edge[i], of_b.edge[j]);
            const double length = norm(m);
            if (length < 1e-4) continue;
            propose((dot(m, guess) < 0.0 ? -1.0 / length : 1.0 / length) * m);
        }
    const bool curved = a.kind == ShapeKind::cylinder || b.kind == ShapeKind::cylinder;
    if (!curved || (exact && best.s >= enough)) return best;
    const auto refine = [&](const V3& n) {
        const double s = separation_along(a, b, n);
        if (s > best.s + (exact ? tie : -tie)) best = {n, s};
    };
    refine(newton_maximum(a, b, guess));
    V3 n;
    for (int i = 0; i < of_a.edges; ++i)
        if (maximum_around_edge(a, b, of_a.edge[i], guess, n)) refine(n);
    for (int i = 0; i < of_b.edges; ++i)
        if (maximum_around_edge(a, b, of_b.edge[i], guess, n)) refine(n);
    return best;
}

}  // namespace hawser::collide::narrow
