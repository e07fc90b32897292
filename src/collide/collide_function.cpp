// SPDX-License-Identifier: Apache-2.0
#include "collide/collide_function.h"

#include "collide/narrow/pairs.h"

#include <utility>

namespace hawser::collide {
namespace {

/// Collide the same pair in reversed order.
template <Collide kFunction>
void collide_swapped(const Geometry& a, const Placement& pa, const Geometry& b, const Placement& pb,
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
        at[static_cast<int>(b)][static_cast<int>(a)] = collide_swapped<kFunction>;
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

}  // namespace hawser::collide
