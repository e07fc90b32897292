// SPDX-License-Identifier: Apache-2.0
#include "wire/lift.h"

#include <hawser/world.h>

#include "wire/guide_system.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hawser::wire {
namespace {

/// True if only elements a and b, bends and broken interactions act on a node.
bool holds_only(const World& world, BodyId lump, InteractionId a, InteractionId b) noexcept {
    for (const InteractionId id : world.interactions()) {
        if (id == a || id == b) continue;
        const InteractionDef& d = world.interaction_def(id);
        const KindInfo& kind = kind_info(d.kind);
        const auto end = d.body.begin() + kind.bodies;
        if (std::find(d.body.begin(), end, lump) == end) continue;
        if (!kind.is(kBendsWire) && world.intact(id)) return false;
    }
    return true;
}

/// Return the next element of the wire on a side of a guide, away from the guide; invalid if there
/// is none or it has broken.
InteractionId next_element(const World& world, InteractionId element, std::size_t side) {
    const auto elements = world.wires().elements(world.wires().of(element));
    const auto at = std::find(elements.begin(), elements.end(), element);
    if (at == elements.end() || at == (side == 0 ? elements.begin() : elements.end() - 1))
        return {};
    const InteractionId next = side == 0 ? *(at - 1) : *(at + 1);
    return world.alive(next) && world.intact(next) ? next : InteractionId{};
}

}  // namespace

InteractionDef lifted_element(const World& world, const GuideSystem& guide, bool keeps_length) {
    const InteractionDef& a = world.interaction_def(guide.ids().before);
    const InteractionDef& b = world.interaction_def(guide.ids().behind);
    const double rest =
        rest_length(world, guide.ids().before) + rest_length(world, guide.ids().behind);
    const auto way = [&](InteractionId id) {
        const std::array<Vec3, 2> ends = world.wires().ends(id);
        return (ends[1] - ends[0]).norm();
    };
    const Vec3 first = world.world_point(a.body[0], a.point[0]),
               last = world.world_point(b.body[1], b.point[1]);
    const double path = way(guide.ids().before) + way(guide.ids().behind) +
                        std::abs(guide.def().radius) * std::min(0.0, guide.angle());
    InteractionDef element;
    element.kind = InteractionKind::Stretch;
    element.name = a.name;
    element.body = {a.body[0], b.body[1]};
    element.point = {a.point[0], b.point[1], Vec3::Zero(), Vec3::Zero()};
    const double length = keeps_length ? rest : rest * (last - first).norm() / path;
    element.set("length", length).set("EA", a.get("EA"));
    element.set("mass", guide.def().mass_per_length * (guide.material()[0] + guide.material()[1]));
    element.set("tension_only", a.get("tension_only"));
    if (const double load = a.get("breaking_load"); !std::isnan(load))
        element.set("breaking_load", load);
    element.damping_time[0] = a.damping_time[0] * length / a.get("length");
    return element;
}

double rest_length(const World& world, InteractionId id) {
    const InteractionDef& d = world.interaction_def(id);
    const double length = d.get("length");
    if (!kind_info(d.kind).is(kWoundUp)) return length;
    return length + d.get("radius") * (world.pose(d.body[2]).position.x() - d.get("drum_zero"));
}

bool ends_free(const World& world, InteractionId part, std::size_t side, double mass_per_length,
               double element_length) noexcept {
    const auto free = [&](BodyId body, InteractionId a, InteractionId b) {
        const BodyDef& d = world.body_def(body);
        return d.kind == BodyKind::lump && d.mass <= mass_per_length * element_length &&
               holds_only(world, body, a, b);
    };
    if (!world.wires().of(part).valid()) return false;
    const BodyId lump = world.interaction_def(part).body[side];
    const InteractionId next = next_element(world, part, side);
    if (!next.valid()) return free(lump, part, {});
    const InteractionDef& d = world.interaction_def(next);
    if (kind_info(d.kind).is(kWoundUp) || next_element(world, next, side).valid()) return false;
    return world.body_def(lump).kind == BodyKind::lump && holds_only(world, lump, part, next) &&
           free(d.body[side], next, {});
}

}  // namespace hawser::wire
