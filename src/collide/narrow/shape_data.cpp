// SPDX-License-Identifier: Apache-2.0
#include "collide/narrow/shape_data.h"

#include <hawser/def.h>

#include <algorithm>
#include <cmath>

namespace hawser::collide {
namespace narrow {

void throw_shape_error(const ShapeDef& def, const std::string& what) {
    throw DefError((def.name.empty() ? "shape" : "shape '" + def.name + "'") + ": " + what);
}

}  // namespace narrow

std::unique_ptr<ShapeData> make_shape_data(const ShapeDef& def) {
    if (def.kind != ShapeKind::hull && def.kind != ShapeKind::mesh &&
        def.kind != ShapeKind::heightfield)
        return nullptr;
    for (std::size_t i = 0; i < def.vertices.size(); ++i)
        if (!def.vertices[i].allFinite())
            narrow::throw_shape_error(def, "vertices[" + std::to_string(i) + "] is not finite");
    auto out = std::make_unique<ShapeData>();
    out->kind = def.kind;
    if (def.kind == ShapeKind::hull) narrow::make_hull(def, *out);
    if (def.kind == ShapeKind::mesh) narrow::make_mesh(def, *out);
    if (def.kind == ShapeKind::heightfield) narrow::make_heightfield(def, *out);
    if (def.kind == ShapeKind::heightfield) return out;
    for (int k = 0; k < 3; ++k) {
        out->low[k] = 1e300;
        out->high[k] = -1e300;
    }
    for (const generic::V3& v : out->vertices) {
        const double x[3] = {v.x, v.y, v.z};
        for (int k = 0; k < 3; ++k) {
            out->low[k] = std::min(out->low[k], x[k]);
            out->high[k] = std::max(out->high[k], x[k]);
        }
    }
    return out;
}

}  // namespace hawser::collide
