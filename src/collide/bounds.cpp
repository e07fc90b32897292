// SPDX-License-Identifier: Apache-2.0
#include "collide/bounds.h"

#include "base/small.h"
#include "collide/narrow/convex.h"
#include "collide/narrow/shape_data.h"

#include <algorithm>
#include <cmath>

namespace hawser::collide {

Bounds bounds(const Geometry& shape, const Placement& placed) noexcept {
    Bounds out{};
    const generic::M3 r = generic::load9(placed.r);
    double reach[3] = {0, 0, 0};
    generic::V3 centre = generic::load3(placed.x);
    const auto spread = [&](const generic::V3& half) {
        for (int k = 0; k < 3; ++k)
            reach[k] = std::fabs(r.a[3 * k]) * half.x + std::fabs(r.a[3 * k + 1]) * half.y +
                       std::fabs(r.a[3 * k + 2]) * half.z;
    };
    switch (shape.kind) {
        case ShapeKind::sphere:
            std::fill(reach, reach + 3, shape.radius);
            break;
        case ShapeKind::capsule:
            spread({0, 0, shape.half_length});
            for (double& x : reach) x += shape.radius;
            break;
        case ShapeKind::box:
            spread(generic::load3(shape.half_size));
            break;
        case ShapeKind::cylinder:
            for (int k = 0; k < 3; ++k) {
                const double z = r.a[3 * k + 2];
                reach[k] = shape.half_length * std::fabs(z) +
                           shape.radius * std::sqrt(std::max(0.0, 1.0 - z * z));
            }
            break;
        case ShapeKind::plane:
            std::fill(reach, reach + 3, 1e30);
            break;
        default:
            if (!shape.data) break;
            const generic::V3 low = generic::load3(shape.data->low),
                              high = generic::load3(shape.data->high);
            centre = centre + r * (0.5 * (low + high));
            spread(0.5 * (high - low));
    }
    for (int k = 0; k < 3; ++k) {
        const double x = narrow::component(centre, k);
        out.low[k] = x - reach[k];
        out.high[k] = x + reach[k];
    }
    return out;
}

}  // namespace hawser::collide
