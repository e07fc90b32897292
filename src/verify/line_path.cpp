// SPDX-License-Identifier: Apache-2.0
#include "verify/line_path.h"

#include <algorithm>
#include <cmath>

namespace hawser::verify {

double wheel_at(const InteractionDef& def, int slot) {
    if (def.kind == InteractionKind::Span) return def.get(slot == 0 ? "wheel_0" : "wheel_1");
    if (def.kind != InteractionKind::EndSpan) return 0.0;
    const int place = def.get("radius") > 0.0 ? 0 : 1;
    return slot == place ? def.get("wheel") : 0.0;
}

namespace {

bool has_ends(const World& world, InteractionId id) {
    return id.valid() && world.interaction_def(id).kind != InteractionKind::BodySpan;
}

// Handle a line without tangent: seen along the axis of the first wheel, one end is within the
// other's circle or nearly so. The ends are then placed as if the difference of the signed radii
// were 0.999 of the distance of the centres.
// @return true in this case.
bool ends_without_tangent(const Attached& on, const double* radius, LineEnds& out) {
    const bool first = radius[0] != 0.0, both = first && radius[1] != 0.0;
    if (!first && radius[1] == 0.0) return false;
    const Vec3 n = on.axis(first ? 0 : 1, 2), d = out.at[1] - out.at[0], flat = d - d.dot(n) * n;
    // A second wheel with the opposite direction of its axis is passed on the other side.
    const double second = both && n.dot(on.axis(1, 2)) < 0.0 ? -radius[1] : radius[1];
    const double separation = second - radius[0];
    if (d.norm() < 1e-6 || std::abs(separation) <= 0.999 * flat.norm()) return false;
    const Vec3 ahead = flat.normalized(), left = n.cross(ahead);
    const double angle = std::asin(std::copysign(0.999, separation));
    const Vec3 u = std::cos(angle) * ahead - std::sin(angle) * left;
    out.at[0] += radius[0] * u.cross(n);
    out.at[1] += second * u.cross(n);
    out.along = (out.at[1] - out.at[0]).normalized();
    return true;
}

}  // namespace

// Return the ends of a line. A wheel of radius R > 0 is on the left of the passing line, seen
// against its axis: the end is at R u × n.
LineEnds line_ends(const Attached& on) {
    const double radius[2] = {wheel_at(on.def(), 0), wheel_at(on.def(), 1)};
    const Vec3 centre[2] = {on.point(0), on.point(1)};
    LineEnds out{{centre[0], centre[1]}, Vec3::UnitX()};
    if (ends_without_tangent(on, radius, out)) return out;
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
    if (wheel != 0.0) {  // project both onto the plane of the wheel
        const Vec3 n = first.axis(1, 2);
        u = (u - u.dot(n) * n).normalized();
        v = (v - v.dot(n) * n).normalized();
    }
    // Use the sine if the cosine is inaccurate.
    const double sine = std::asin(std::min(1.0, u.cross(v).norm()));
    const double angle = u.dot(v) > 0.7    ? sine
                         : u.dot(v) < -0.7 ? std::acos(-1.0) - sine
                                           : std::acos(u.dot(v));
    if (wheel == 0.0) return angle;
    const bool with = u.cross(v).dot(first.axis(1, 2)) * wheel >= 0.0;
    const double turn = 2.0 * std::acos(-1.0), now = with ? angle : -angle;
    const double about =
        defined + world.wires().wrapped(before)[1] + world.wires().wrapped(behind)[0];
    const double turns = std::round((about - now) / turn);
    return std::max(0.0, now + turns * turn);
}

}  // namespace hawser::verify
