// SPDX-License-Identifier: Apache-2.0
#include "collide/narrow/segment.h"

namespace hawser::collide::narrow {
namespace {

constexpr double kTouching = 1e-10;  ///< Of the size.

bool over(const Convex& t, const V3& p) {
    for (int k = 0; k < 3; ++k)
        if (dot(cross(t.corner[(k + 1) % 3] - t.corner[k], p - t.corner[k]), t.face) < 0.0)
            return false;
    return true;
}

/// How a point lies to a cylinder, in its frame: what it is over the surface by, as a vector.
V3 excess(const V3& p, double radius, double half_length) {
    const double across = std::sqrt(p.x * p.x + p.y * p.y);
    const double k = across > radius ? 1.0 - radius / across : 0.0;
    const double z = p.z > half_length ? p.z - half_length
                                       : (p.z < -half_length ? p.z + half_length : 0.0);
    return {k * p.x, k * p.y, z};
}

}  // namespace

bool segment_triangle(const Segment& a, const Convex& t, Separation& out) {
    const double size = a.half + t.size;
    const V3 ends[2] = {a.at(-a.half), a.at(a.half)};
    double height[2];
    for (int i = 0; i < 2; ++i) height[i] = dot(t.face, ends[i] - t.corner[0]);
    double best = 1e300;
    if (height[0] * height[1] <= 0.0) {
        const double run = height[0] - height[1];
        const double f = run != 0.0 ? height[0] / run : 0.5;
        if (over(t, ends[0] + f * (ends[1] - ends[0]))) return false;
    }
    for (int i = 0; i < (a.half > 0.0 ? 2 : 1); ++i)
        if (std::fabs(height[i]) < best && over(t, ends[i])) {
            best = std::fabs(height[i]);
            out = {height[i] > 0.0 ? -t.face : t.face, best};
        }
    for (int k = 0; k < 3; ++k) {
        const V3 &p = t.corner[k], &q = t.corner[(k + 1) % 3];
        const V3 along = q - p;
        const double length = norm(along);
        const Segment edge{0.5 * (p + q), (1.0 / length) * along, 0.5 * length};
        double s = 0.0, u = 0.0;
        nearest(a, edge, s, u);
        const V3 d = edge.at(u) - a.at(s);
        const double distance = norm(d);
        // A face wins ties: its normal is exact.
        if (distance < best - 1e-14 * size) {
            best = distance;
            out = {distance > 0.0 ? (1.0 / distance) * d : t.face, distance};
        }
    }
    return best > kTouching * size;
}

bool segment_cylinder(const Segment& a, const Convex& cylinder, Separation& out) {
    const V3 c = tmul(cylinder.r, a.c - cylinder.c), d = tmul(cylinder.r, a.d);
    const auto over_by = [&](double t) {
        return excess(c + t * d, cylinder.radius, cylinder.half_length);
    };
    // Half the square of the distance is convex along the segment; this is its slope.
    const auto slope = [&](double t) { return dot(over_by(t), d); };
    double low = -a.half, high = a.half, t = low;
    if (a.half > 0.0) {
        double at_low = slope(low), at_high = slope(high);
        if (at_low >= 0.0) {
            t = low;
        } else if (at_high <= 0.0) {
            t = high;
        } else {
            // False position (Illinois), with a bisection when it is slow.
            int kept = 0;
            for (int i = 0; i < 60 && high - low > 1e-15 * a.half; ++i) {
                t = low + (high - low) * at_low / (at_low - at_high);
                if (i % 4 == 3 || !(t > low) || !(t < high)) t = 0.5 * (low + high);
                const double y = slope(t);
                if (y == 0.0) break;
                if (y < 0.0) {
                    low = t;
                    at_low = y;
                    if (kept == 1) at_high *= 0.5;
                    kept = 1;
                } else {
                    high = t;
                    at_high = y;
                    if (kept == -1) at_low *= 0.5;
                    kept = -1;
                }
            }
        }
    }
    const V3 by = over_by(t);
    const double distance = norm(by);
    if (!(distance > kTouching * (a.half + cylinder.size))) return false;
    out = {cylinder.r * ((-1.0 / distance) * by), distance};
    return true;
}

}  // namespace hawser::collide::narrow
