// SPDX-License-Identifier: Apache-2.0
#include "collide/geometry.h"

#include "collide/narrow/convex.h"
#include "collide/narrow/pairs.h"
#include "collide/narrow/shape_data.h"

#include <algorithm>
#include <utility>

namespace hawser::collide {
namespace {

using narrow::component;

/// The function for the same pair given the other way round.
template <Collide kFunction>
void swapped(const Geometry& a, const Placement& pa, const Geometry& b, const Placement& pb,
             double margin, Manifold& out) noexcept {
    kFunction(b, pb, a, pa, margin, out);
    for (int i = 0; i < out.count; ++i) {
        ManifoldPoint& p = out.point[i];
        for (int k = 0; k < 3; ++k) {
            std::swap(p.on[0][k], p.on[1][k]);
            p.normal[k] = -p.normal[k];
        }
    }
}

constexpr int kKinds = 8;
struct Table {
    Collide at[kKinds][kKinds] = {};

    template <Collide kFunction>
    void set(ShapeKind a, ShapeKind b) {
        at[static_cast<int>(b)][static_cast<int>(a)] = swapped<kFunction>;
        at[static_cast<int>(a)][static_cast<int>(b)] = kFunction;
    }
    Table() {
        using enum ShapeKind;
        for (auto& row : at)
            for (Collide& entry : row) entry = narrow::nothing;
        set<narrow::sphere_sphere>(sphere, sphere);
        set<narrow::sphere_capsule>(sphere, capsule);
        set<narrow::sphere_box>(sphere, box);
        set<narrow::sphere_cylinder>(sphere, cylinder);
        set<narrow::sphere_plane>(sphere, plane);
        set<narrow::capsule_capsule>(capsule, capsule);
        set<narrow::capsule_box>(capsule, box);
        set<narrow::capsule_plane>(capsule, plane);
        set<narrow::box_box>(box, box);
        for (const ShapeKind kind : {box, cylinder, hull}) set<narrow::convex_plane>(kind, plane);
        for (const ShapeKind kind : {capsule, box, cylinder})
            set<narrow::convex_convex>(kind, cylinder);
        for (const ShapeKind kind : {sphere, capsule, box, cylinder, hull})
            set<narrow::convex_convex>(kind, hull);
        for (const ShapeKind kind : {sphere, capsule, box, cylinder, hull}) {
            set<narrow::convex_mesh>(kind, mesh);
            set<narrow::convex_heightfield>(kind, heightfield);
        }
    }
};

}  // namespace

Collide collide_function(ShapeKind a, ShapeKind b) noexcept {
    static const Table table;
    return table.at[static_cast<int>(a)][static_cast<int>(b)];
}

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
        const double x = component(centre, k);
        out.low[k] = x - reach[k];
        out.high[k] = x + reach[k];
    }
    return out;
}

}  // namespace hawser::collide
