// SPDX-License-Identifier: Apache-2.0
#include "support/collide/reference.h"

#include <algorithm>

namespace hawser::reference {

Body make_body(const collide::Geometry& shape, const collide::Placement& placed) {
    Body o;
    o.kind = shape.kind;
    o.c = {placed.x[0], placed.x[1], placed.x[2]};
    for (int k = 0; k < 3; ++k) o.axis[k] = {placed.r[k], placed.r[3 + k], placed.r[6 + k]};
    switch (shape.kind) {
        case ShapeKind::sphere:
            o.rounding = shape.radius;
            break;
        case ShapeKind::capsule:
            o.rounding = shape.radius;
            o.half_length = shape.half_length;
            o.edges = {o.axis[2]};
            break;
        case ShapeKind::cylinder:
            o.radius = shape.radius;
            o.half_length = shape.half_length;
            o.edges = o.faces = {o.axis[2]};
            break;
        default:
            for (int k = 0; k < 3; ++k) o.half[k] = shape.half_size[k];
            o.edges = o.faces = {o.axis[0], o.axis[1], o.axis[2]};
    }
    return o;
}

Body make_points(const std::vector<Vec>& points, const std::vector<Vec>& faces,
                 const std::vector<Vec>& edges) {
    Body o;
    o.kind = ShapeKind::hull;
    o.points = points;
    for (const Vec& p : points) o.c = o.c + (Real(1) / points.size()) * p;
    o.faces = faces;
    o.edges = edges;
    return o;
}

Vec support(const Body& s, Vec n) {
    const Real m[3] = {dot(s.axis[0], n), dot(s.axis[1], n), dot(s.axis[2], n)};
    switch (s.kind) {
        case ShapeKind::sphere:
            return s.c;
        case ShapeKind::capsule:
            return s.c + (m[2] < 0 ? -s.half_length : s.half_length) * s.axis[2];
        case ShapeKind::cylinder: {
            const Real across = std::sqrt(m[0] * m[0] + m[1] * m[1]);
            const Real k = across > 0 ? s.radius / across : 0;
            return s.c + (k * m[0]) * s.axis[0] + (k * m[1]) * s.axis[1] +
                   (m[2] < 0 ? -s.half_length : s.half_length) * s.axis[2];
        }
        case ShapeKind::box: {
            Vec p = s.c;
            for (int k = 0; k < 3; ++k) p = p + (m[k] < 0 ? -s.half[k] : s.half[k]) * s.axis[k];
            return p;
        }
        default: {
            Vec best = s.points[0];
            Real most = dot(best, n);
            for (const Vec& p : s.points) {
                const Real x = dot(p, n);
                if (x > most) most = x, best = p;
            }
            return best;
        }
    }
}

namespace {

Vec difference(const Body& a, const Body& b, Vec n) {
    return support(b, -1.0L * n) - support(a, n);
}
Real cores(const Body& a, const Body& b, Vec n) { return dot(n, difference(a, b, n)); }

/// Find the nearest point to the origin of the affine hull of some points, if it lies within them.
bool inside_nearest(const Vec* w, int count, Vec& out) {
    if (count == 1) return out = w[0], true;
    // Normal equations of the differences from w[0], by elimination with pivoting.
    const int m = count - 1;
    Real g[3][4] = {};
    for (int i = 0; i < m; ++i) {
        for (int j = 0; j < m; ++j) g[i][j] = dot(w[i + 1] - w[0], w[j + 1] - w[0]);
        g[i][m] = -dot(w[i + 1] - w[0], w[0]);
    }
    for (int i = 0; i < m; ++i) {
        int pivot = i;
        for (int j = i + 1; j < m; ++j)
            if (std::fabs(g[j][i]) > std::fabs(g[pivot][i])) pivot = j;
        for (int k = 0; k <= m; ++k) std::swap(g[i][k], g[pivot][k]);
        if (!(std::fabs(g[i][i]) > 1e-36L)) return false;
        for (int j = 0; j < m; ++j) {
            if (j == i) continue;
            const Real f = g[j][i] / g[i][i];
            for (int k = i; k <= m; ++k) g[j][k] -= f * g[i][k];
        }
    }
    Real first = 1;
    out = w[0];
    for (int i = 0; i < m; ++i) {
        const Real t = g[i][m] / g[i][i];
        if (t < 0) return false;
        first -= t;
        out = out + t * (w[i + 1] - w[0]);
    }
    return first >= 0;
}

/// Minimise |b − a|; `gap`: bound of |v − v*|².
Vec nearest(const Body& a, const Body& b, Real& gap) {
    std::vector<Vec> w;
    Vec v = difference(a, b, unit(b.c - a.c + Vec{1e-30L, 0, 0}));
    w.push_back(v);
    gap = 1e30L;
    for (int iteration = 0; iteration < 400; ++iteration) {
        if (length(v) < 1e-13L) break;
        const Vec p = difference(a, b, unit(v));
        const Real now = dot(v, v) - dot(v, p);
        gap = std::fmin(gap, std::fmax(now, 0));
        if (now < 1e-22L * dot(v, v) || now < 1e-26L) break;
        w.push_back(p);
        Vec best = v, keep[4];
        Real least = 1e30L;
        int kept = 0;
        const int count = static_cast<int>(w.size());
        for (int mask = 1; mask < 1 << count; ++mask) {
            Vec q[5], point;
            int n = 0;
            for (int i = 0; i < count; ++i)
                if (mask >> i & 1) q[n++] = w[i];
            if (n > 4 || !inside_nearest(q, n, point)) continue;
            // Four points contain the origin, or are too flat to decide.
            if (n == 4 && dot(point, point) > 1e-26L) continue;
            if (dot(point, point) < least) {
                least = dot(point, point);
                best = point;
                kept = n;
                std::copy(q, q + n, keep);
            }
        }
        if (kept == 4) return gap = 0, Vec{};
        if (least >= dot(v, v)) break;
        v = best;
        w.assign(keep, keep + kept);
    }
    return v;
}

/// Return a bound of the distance of the body's points from its centre.
Real reach(const Body& o) {
    Real most = length({o.half[0], o.half[1], o.half[2]}) + o.radius + o.half_length;
    for (const Vec& p : o.points) most = std::max(most, length(p - o.c));
    return most;
}

struct Search {
    const Body &a, &b;
    Real steepest;  ///< Bound of the slope of s [m/rad].
    Real best = -1e30L;
    Vec n;
    void propose(Vec m) {
        const Real s = cores(a, b, m);
        if (s > best) best = s, n = m;
    }
    /// Find all local maxima on the circle perpendicular to e.
    void circle(Vec e) {
        const Vec u = unit(cross(e, std::fabs(e.x) < 0.6L ? Vec{1, 0, 0} : Vec{0, 1, 0}));
        const Vec v = cross(e, u);
        constexpr int kScan = 128;
        const auto at = [&](Real t) { return std::cos(t) * u + std::sin(t) * v; };
        static const std::vector<std::array<Real, 2>> kAngles = [] {
            std::vector<std::array<Real, 2>> t;
            for (int i = 0; i < kScan; ++i)
                t.push_back({std::cos(2 * M_PIl * i / kScan), std::sin(2 * M_PIl * i / kScan)});
            return t;
        }();
        Real scan[kScan];
        for (int i = 0; i < kScan; ++i)
            scan[i] = cores(a, b, kAngles[i][0] * u + kAngles[i][1] * v);
        const Real step = 2 * M_PIl / kScan;
        for (int i = 0; i < kScan; ++i) {
            const Real left = scan[(i + kScan - 1) % kScan], right = scan[(i + 1) % kScan];
            if (scan[i] < left || scan[i] < right) continue;
            // A maximum exceeds the scan by at most the slope's bound.
            if (scan[i] + step * steepest < best) continue;
            Real low = (i - 1) * step, high = (i + 1) * step;
            // Bisect by the sign of the slope: exact also at kinks, where golden section would stop
            // early.
            for (int k = 0; k < 62; ++k) {
                const Real t = (low + high) / 2;
                const Vec m = at(t), along = std::cos(t) * v - std::sin(t) * u;
                (dot(along, difference(a, b, m)) > 0 ? low : high) = t;
            }
            propose(at((low + high) / 2));
        }
    }
    /// Find maxima off the circles: between two rims, or a rim and a vertex.
    void sphere() {
        constexpr int kScan = 1500;
        static const std::vector<Vec> kWays = [] {
            std::vector<Vec> ways;
            for (int i = 0; i < kScan; ++i) {
                const Real z = 1 - (2 * i + 1) / Real(kScan), r = std::sqrt(1 - z * z);
                const Real t = i * 2.399963229728653322L;
                ways.push_back({r * std::cos(t), r * std::sin(t), z});
            }
            return ways;
        }();
        std::vector<std::pair<Real, int>> scan;
        for (int i = 0; i < kScan; ++i) scan.push_back({-cores(a, b, kWays[i]), i});
        std::partial_sort(scan.begin(), scan.begin() + 40, scan.end());
        std::vector<Vec> starts;
        for (int i = 0; i < 40 && starts.size() < 6; ++i) {
            const Vec m = kWays[scan[i].second];
            bool far = true;
            for (const Vec& s : starts) far = far && dot(s, m) < 0.98L;
            if (far) starts.push_back(m);
        }
        for (const Vec& start : starts) climb(start);
    }
    void climb(Vec m) {
        Real now = cores(a, b, m);
        Real step = 0.06L;
        for (int round = 0; round < 400 && step > 1e-11L; ++round) {
            const Vec u = unit(cross(m, std::fabs(m.x) < 0.6L ? Vec{1, 0, 0} : Vec{0, 1, 0}));
            const Vec v = cross(m, u);
            // Along the projected gradient first, then around.
            const Vec g = difference(a, b, m);
            Vec along = g - dot(g, m) * m;
            const Real slope = length(along);
            bool better = false;
            for (int k = 0; k < 9 && !better; ++k) {
                const Real t = k * M_PIl / 4;
                Vec way = std::cos(t) * u + std::sin(t) * v;
                if (k == 8) continue;
                if (k == 0 && slope > 0) way = (1 / slope) * along;
                const Vec next = unit(m + step * way);
                const Real s = cores(a, b, next);
                if (s > now) now = s, m = next, better = true;
            }
            if (!better) step /= 2;
        }
        propose(newton(m));
    }
    /// Return the slopes of s over the tangent plane at m, shifted by (x, y).
    std::array<Real, 2> slopes(Vec m, Vec u, Vec v, Real x, Real y) const {
        const Vec way = m + x * u + y * v;
        const Vec top = unit(way), g = difference(a, b, top);
        const Vec across = (1 / length(way)) * (g - dot(g, top) * top);
        return {dot(across, u), dot(across, v)};
    }
    /// A pattern search is slow along narrow ridges.
    Vec newton(Vec m) const {
        for (int i = 0; i < 12; ++i) {
            const Vec u = unit(cross(m, std::fabs(m.x) < 0.6L ? Vec{1, 0, 0} : Vec{0, 1, 0}));
            const Vec v = cross(m, u);
            const Real h = 1e-7L;
            const auto g = slopes(m, u, v, 0, 0);
            const auto right = slopes(m, u, v, h, 0), left = slopes(m, u, v, -h, 0);
            const auto up = slopes(m, u, v, 0, h), down = slopes(m, u, v, 0, -h);
            const Real xx = (right[0] - left[0]) / (2 * h), xy = (right[1] - left[1]) / (2 * h);
            const Real yy = (up[1] - down[1]) / (2 * h), det = xx * yy - xy * xy;
            if (!(det > 0)) return m;
            const Vec next = unit(m + (-(yy * g[0] - xy * g[1]) / det) * u +
                                  (-(xx * g[1] - xy * g[0]) / det) * v);
            if (!(cores(a, b, next) >= cores(a, b, m))) return m;
            m = next;
        }
        return m;
    }
};

}  // namespace

Real separation_along(const Body& a, const Body& b, Vec n) {
    return cores(a, b, n) - a.rounding - b.rounding;
}

Answer signed_distance(const Body& a, const Body& b) {
    Real gap = 0;
    const Vec v = nearest(a, b, gap);
    const Real distance = length(v), rounding = a.rounding + b.rounding;
    // The distance is between s along v and |v|. For very thin overlapping shapes the minimisation
    // may end early: both then differ, and all normals are searched as well.
    const bool apart = distance > 1e-12L;
    if (apart && distance - cores(a, b, (1 / distance) * v) < 1e-7L)
        return {distance - rounding, (1 / distance) * v,
                std::sqrt(gap) / distance + 1e-15L / distance};
    Search search{a, b, length(b.c - a.c) + reach(a) + reach(b), -1e30L, {}};
    if (apart) search.propose((1 / distance) * v);
    for (const Vec& n : a.faces) search.propose(n), search.propose(-1.0L * n);
    for (const Vec& n : b.faces) search.propose(n), search.propose(-1.0L * n);
    for (const Vec& e : a.edges)
        for (const Vec& f : b.edges) {
            const Vec m = cross(e, f);
            if (length(m) < 1e-9L) continue;
            search.propose(unit(m));
            search.propose(-1.0L * unit(m));
        }
    // Coincident points, or coincident parallel lines: any perpendicular normal is valid.
    if (a.faces.empty() && b.faces.empty()) {
        const Vec e = a.edges.empty() ? (b.edges.empty() ? Vec{0, 0, 1} : b.edges[0]) : a.edges[0];
        search.propose(unit(cross(e, std::fabs(e.x) < 0.6L ? Vec{1, 0, 0} : Vec{0, 1, 0})));
    }
    const bool curved = a.kind == ShapeKind::cylinder || b.kind == ShapeKind::cylinder;
    if (curved) {
        for (const Vec& e : a.edges) search.circle(e);
        for (const Vec& e : b.edges) search.circle(e);
    }
    if (a.kind == ShapeKind::cylinder && b.kind == ShapeKind::cylinder) search.sphere();
    return {search.best - rounding, search.n, 1e-9L};
}

}  // namespace hawser::reference
