// SPDX-License-Identifier: Apache-2.0
#include "verify/line_path.h"

#include <algorithm>
#include <cmath>

namespace hawser::verify {
namespace {

/// Signed radius of the wheel at an end [m].
double wheel_at(const InteractionDef& def, int slot) {
    if (def.kind == InteractionKind::Span) return def.get(slot == 0 ? "wheel_0" : "wheel_1");
    if (def.kind != InteractionKind::EndSpan) return 0.0;
    const int place = def.get("radius") > 0.0 ? 0 : 1;
    return slot == place ? def.get("wheel") : 0.0;
}

bool has_ends(const World& world, InteractionId id) {
    return id.valid() && world.interaction_def(id).kind != InteractionKind::BodySpan;
}

}  // namespace

// A wheel of radius R > 0 lies to the left of what passes it, seen against its axis: the end is at
// R u × n.
LineEnds line_ends(const Attached& on) {
    const double radius[2] = {wheel_at(on.def(), 0), wheel_at(on.def(), 1)};
    const Vec3 centre[2] = {on.point(0), on.point(1)};
    LineEnds out{{centre[0], centre[1]}, Vec3::UnitX()};
    for (int i = 0; i < 200; ++i) {
        const Vec3 d = out.at[1] - out.at[0];
        if (d.norm() < 1e-12) {
            out.along = Vec3::UnitX();
            break;
        }
        out.along = d.normalized();
        double moved = 0.0;
        for (int k = 0; k < 2; ++k) {
            if (radius[k] == 0.0) continue;
            const Vec3 n = on.axis(k, 2);
            const Vec3 flat = (out.along - out.along.dot(n) * n).normalized();
            const Vec3 next = centre[k] + radius[k] * flat.cross(n);
            moved = std::max(moved, (next - out.at[k]).norm());
            out.at[k] = next;
        }
        if (moved < 1e-14) break;
    }
    return out;
}

double turn_between(const World& world, InteractionId before, InteractionId behind, double defined,
                    std::span<const Pose> pose) {
    if (!has_ends(world, before) || !has_ends(world, behind)) return defined;
    const Attached first(world, before, pose), second(world, behind, pose);
    Vec3 u = line_ends(first).along, v = line_ends(second).along;
    const double wheel = wheel_at(first.def(), 1);
    if (wheel != 0.0) {  // what of both lies in the plane of the wheel
        const Vec3 n = first.axis(1, 2);
        u = (u - u.dot(n) * n).normalized();
        v = (v - v.dot(n) * n).normalized();
    }
    // From the sine where the cosine tells nothing.
    const double sine = std::asin(std::min(1.0, u.cross(v).norm()));
    const double angle = u.dot(v) > 0.7    ? sine
                         : u.dot(v) < -0.7 ? std::acos(-1.0) - sine
                                           : std::acos(u.dot(v));
    if (wheel == 0.0) return angle;
    const bool with = u.cross(v).dot(first.axis(1, 2)) * wheel >= 0.0;
    const double turn = 2.0 * std::acos(-1.0), now = with ? angle : -angle;
    const double turns = std::round((defined - now) / turn);
    return std::max(0.0, now + turns * turn);
}

}  // namespace hawser::verify
