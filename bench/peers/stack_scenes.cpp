// SPDX-License-Identifier: Apache-2.0
// Light boxes under a heavy one.
#include "scene_parts.h"

namespace hawser::bench {
namespace {

Scene stack(double top) {
    constexpr int kBoxes = 10;
    Scene s;
    s.duration = 10.0;
    for (int i = 0; i < kBoxes; ++i) {
        const Vec3 half = Vec3::Constant(0.5);
        Body b = box(i + 1 < kBoxes ? 1.0 : top, half, Vec3(0.0, 0.0, 0.5 + i));
        b.shape = {BodyShape::Kind::box, 0.0, 0.0, half};
        s.top = add(s, b);
    }
    // Ten layers on four points deflect by 10 m g / (4 k) = 0.25 mm.
    s.touching = Touching{.bodies = true, .friction = 0.5, .stiffness = 1e5 * top};
    s.wanted.moved = 1e-3;
    s.layouts = {{"free bodies", {}}};
    return s;
}

}  // namespace

Scene box_stack() {
    Scene s = stack(1e3);
    s.name = "box_stack";
    s.code = "S4";
    return s;
}

Scene box_stack_1e6() {
    Scene s = stack(1e6);
    s.name = "box_stack_1e6";
    s.code = "S4-1e6";
    return s;
}

}  // namespace hawser::bench
