// SPDX-License-Identifier: Apache-2.0
#include "collide/collider.h"
#include "collide/narrow/shape_data.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hawser::collide {
namespace {

Placement local_frame(const ShapeDef& def) {
    Placement p{};
    const Mat3 r = def.orientation.normalized().toRotationMatrix();
    for (int i = 0; i < 3; ++i) {
        p.x[i] = def.position[i];
        for (int j = 0; j < 3; ++j) p.r[3 * i + j] = r(i, j);
    }
    return p;
}

/// Return Shape::thickness of a shape other than a segment. Shapes that lines may touch are wider
/// than lines.
double contact_thickness(const Geometry& geometry) {
    switch (geometry.kind) {
        case ShapeKind::capsule:  // links of lines, which may lie across each other
        case ShapeKind::plane:
        case ShapeKind::heightfield:
        case ShapeKind::mesh:
            return HUGE_VAL;
        default:
            break;
    }
    const Bounds box = bounds(geometry, {{0, 0, 0}, {1, 0, 0, 0, 1, 0, 0, 0, 1}});
    double least = HUGE_VAL;
    for (int i = 0; i < 3; ++i) least = std::min(least, box.high[i] - box.low[i]);
    return least;
}

}  // namespace

std::int32_t Collider::add(const ShapeDef& def, const model::Bodies& bodies) {
    Shape s{};
    s.geometry = {def.kind,
                  def.radius,
                  def.half_length,
                  {def.half_size.x(), def.half_size.y(), def.half_size.z()},
                  nullptr};
    s.local = local_frame(def);
    s.body[0] = def.body.index;
    s.body[1] = def.body_b.index;
    s.owner[0] = s.owner[1] = s.line = -1;
    s.material = std::max(def.material.index, 0);
    s.group = def.group;
    s.touches = def.touches;
    s.margin = def.margin;
    s.held = held_segment_end(s, bodies);
    for (const std::int32_t b : s.body) s.moves = s.moves || (b >= 0 && bodies.dof(b) > 0);
    std::shared_ptr<const ShapeData> data = make_shape_data(def);
    s.geometry.data = data.get();
    s.thickness = s.segment() ? HUGE_VAL : contact_thickness(s.geometry);
    base::reserve_more(data_, 1);
    base::reserve_more(shapes_, 1);
    reserve_more();
    const std::int32_t place = slots.find_vacant([](std::int32_t) { return true; });
    if (place >= 0) {
        slots.take(place);
        data_[at(place)] = std::move(data);
        shapes_[at(place)] = s;
        new_.push_back(place);
        return place;
    }
    data_.push_back(std::move(data));
    shapes_.push_back(s);
    new_.push_back(slots.append());
    return new_.back();
}

}  // namespace hawser::collide
