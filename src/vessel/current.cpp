// SPDX-License-Identifier: Apache-2.0
/// Loads of a current by its heading (hawser/vessel_hull.h).
#include "vessel/hull_forces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hawser {

CurrentPoint current_coefficients(const CurrentLoad& load, double angle) noexcept {
    const auto& points = load.points;
    const double a = std::abs(angle), side = angle < 0.0 ? -1.0 : 1.0;
    CurrentPoint out{.angle = angle};
    if (points.empty()) return out;
    std::size_t i = 1;
    while (i + 1 < points.size() && a > points[i].angle) ++i;
    const CurrentPoint& from = points[i - 1];
    const CurrentPoint& to = points[std::min(i, points.size() - 1)];
    const double width = to.angle - from.angle;
    const double x = width > 0.0 ? std::clamp((a - from.angle) / width, 0.0, 1.0) : 0.0;
    out.x = from.x + x * (to.x - from.x);
    out.y = side * (from.y + x * (to.y - from.y));
    out.n = side * (from.n + x * (to.n - from.n));
    return out;
}

namespace vessel {

Wrench current_force(const CurrentLoad& def, const Flow& flow) noexcept {
    Wrench out = Wrench::Zero();
    if (def.points.empty()) return out;
    // The ship moves towards the side from which the water comes.
    const CurrentPoint c = current_coefficients(def, std::atan2(flow.v(), flow.u()));
    const double q =
        0.5 * flow.density * (flow.u() * flow.u() + flow.v() * flow.v()) * def.length * def.draught;
    out[0] = q * c.x;
    out[1] = q * c.y;
    out[5] = q * def.length * c.n;
    return out;
}

}  // namespace vessel
}  // namespace hawser
