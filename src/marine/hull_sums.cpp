// SPDX-License-Identifier: Apache-2.0
#include "marine/hull_sums.h"

#include <algorithm>
#include <cmath>

namespace hawser::marine {

void HullSums::add(const HullSums& other) noexcept {
    force += other.force;
    torque += other.torque;
    volume += other.volume;
    moment += other.moment;
    plane += other.plane;
    x += other.x;
    y += other.y;
    xx += other.xx;
    yy += other.yy;
    xy += other.xy;
}

void HullSums::add_wet(const HullCorner& a, const HullCorner& b, const HullCorner& c) noexcept {
    const Vec3 normal = 0.5 * (b.x - a.x).cross(c.x - a.x);  // times the area
    const double p = a.pressure + b.pressure + c.pressure;
    force -= normal * (p / 3.0);
    const Vec3 arm = (p + a.pressure) * a.x + (p + b.pressure) * b.x + (p + c.pressure) * c.x;
    torque -= arm.cross(normal) / 12.0;
    const HullCorner* const corner[] = {&a, &b, &c, &a};
    const double third = -normal.z() / 3.0;  // third of the area of its columns' ground
    for (int k = 0; k < 3; ++k) {
        const Vec3 m = 0.5 * (corner[k]->x + corner[k + 1]->x);
        const double s = 0.5 * (corner[k]->depth + corner[k + 1]->depth), v = third * s;
        volume += v;
        moment += v * Vec3(m.x(), m.y(), m.z() + 0.5 * s);
        plane += third;
        x += third * m.x();
        y += third * m.y();
        xx += third * m.x() * m.x();
        yy += third * m.y() * m.y();
        xy += third * m.x() * m.y();
    }
}

void HullSums::add_triangle(const HullCorner& a, const HullCorner& b,
                            const HullCorner& c) noexcept {
    const HullCorner* const corner[] = {&a, &b, &c};
    HullCorner part[4];
    int count = 0;
    for (int k = 0; k < 3; ++k) {
        const HullCorner &from = *corner[k], &to = *corner[(k + 1) % 3];
        const bool wet = from.depth > 0.0;
        if (wet) part[count++] = from;
        if (wet == (to.depth > 0.0)) continue;
        // Start from the wet corner, so that both triangles of a side are cut at the same point.
        const HullCorner &low = wet ? from : to, &high = wet ? to : from;
        const double fraction = low.depth / (low.depth - high.depth);
        part[count++].x = low.x + fraction * (high.x - low.x);
    }
    for (int k = 2; k < count; ++k) add_wet(part[0], part[k - 1], part[k]);
}

void plane_stiffness(const HullSums& s, double (&out)[6]) noexcept {
    std::fill(std::begin(out), std::end(out), 0.0);
    // A waterplane of rounding size counts as none.
    const double size = std::cbrt(std::max(s.volume, 0.0));
    if (!(s.plane > 1e-9 * size * size)) return;
    const double x = s.x / s.plane, y = s.y / s.plane;
    // Moments about the centre of the waterplane, which must not be negative,
    const double ixx = std::max(s.xx - s.plane * x * x, 0.0);
    const double iyy = std::max(s.yy - s.plane * y * y, 0.0);
    constexpr double kMaxProductRatio = 1.0 - 1e-12;
    const double most = kMaxProductRatio * std::sqrt(ixx * iyy);
    const double ixy = std::clamp(s.xy - s.plane * x * y, -most, most);
    // and then about the reference.
    out[0] = s.plane;
    out[1] = s.plane * y;
    out[2] = s.plane * y * y + iyy;
    out[3] = -s.plane * x;
    out[4] = -s.plane * x * y - ixy;
    out[5] = s.plane * x * x + ixx;
}

}  // namespace hawser::marine
