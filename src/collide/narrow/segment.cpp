// SPDX-License-Identifier: Apache-2.0
#include "collide/narrow/segment.h"

#include "collide/narrow/epa.h"

namespace hawser::collide::narrow {
namespace {

constexpr double kTouchTolerance = 1e-10;  ///< Tolerance of touching, relative to the size.

bool over(const Convex& t, const V3& p) {
    for (int k = 0; k < 3; ++k)
        if (dot(cross(t.corner[(k + 1) % 3] - t.corner[k], p - t.corner[k]), t.face) < 0.0)
            return false;
    return true;
}

/// Return the vector from the nearest point of a solid cylinder to p, in its frame. @param rate
/// Output: second derivative of half its square along d.
V3 distance_to_cylinder(const V3& p, const V3& d, double radius, double half_length, double& rate) {
    V3 by{0, 0, 0};
    rate = 0.0;
    const double across = std::sqrt(p.x * p.x + p.y * p.y);
    if (across > radius) {
        const double ratio = radius / across, along = (p.x * d.x + p.y * d.y) / across;
        by.x = (1.0 - ratio) * p.x;
        by.y = (1.0 - ratio) * p.y;
        rate += (1.0 - ratio) * (d.x * d.x + d.y * d.y) + ratio * along * along;
    }
    if (std::fabs(p.z) > half_length) {
        by.z = p.z > 0.0 ? p.z - half_length : p.z + half_length;
        rate += d.z * d.z;
    }
    return by;
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
        // In a tie use the face: its normal is exact.
        if (distance < best - 1e-14 * size) {
            best = distance;
            out = {distance > 0.0 ? (1.0 / distance) * d : t.face, distance};
        }
    }
    return best > kTouchTolerance * size;
}

bool segment_cylinder(const Segment& a, const Convex& cylinder, Separation& out) {
    const V3 c = tmul(cylinder.r, a.c - cylinder.c), d = tmul(cylinder.r, a.d);
    // Half of the squared distance is convex along the segment. Its slope is zero at the nearest
    // point. Newton's method within a bracket.
    double low = -a.half, high = a.half, t = clamp(-dot(c, d), low, high), rate = 0.0;
    V3 by = distance_to_cylinder(c + t * d, d, cylinder.radius, cylinder.half_length, rate);
    for (int i = 0; i < 90; ++i) {
        const double slope = dot(by, d);
        if (slope == 0.0) break;
        (slope > 0.0 ? high : low) = t;
        double next = t - slope / rate;
        // Where the distance has kinks, the iteration may oscillate.
        if (i > 12 && i % 2 == 1) next = 0.5 * (low + high);
        if (!(next > low)) next = i > 0 && low > -a.half ? 0.5 * (low + high) : low;
        if (!(next < high)) next = i > 0 && high < a.half ? 0.5 * (low + high) : high;
        if (next == t) break;
        t = next;
        by = distance_to_cylinder(c + t * d, d, cylinder.radius, cylinder.half_length, rate);
    }
    const double distance = norm(by);
    if (!(distance > kTouchTolerance * (a.half + cylinder.size))) return false;
    out = {cylinder.r * ((-1.0 / distance) * by), distance};
    return true;
}

Separation separate_from_cylinder(const Convex& a, const Convex& cylinder) {
    Separation best = polish(a, cylinder, epa(a, cylinder), 0.0);
    const V3 z = axis(cylinder.r, 2);
    const auto propose = [&](V3 n) {
        const double length = norm(n);
        if (!(length > 1e-9 * cylinder.radius)) return;
        const Separation other = polish(a, cylinder, (1.0 / length) * n, 0.0);
        if (other.s > best.s + 1e-14 * cylinder.size) best = other;
    };
    const Segment s = segment_of(a);
    for (const double t : {-s.half, s.half}) {
        const V3 p = s.at(t) - cylinder.c;
        propose(dot(p, z) * z - p);
    }
    const V3 across = cylinder.radius * cross(z, s.d);
    propose(dot(across, s.c - cylinder.c) > 0.0 ? -across : across);
    return best;
}

}  // namespace hawser::collide::narrow
