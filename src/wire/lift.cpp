// SPDX-License-Identifier: Apache-2.0
#include "wire/lift.h"

#include <hawser/world.h>

#include "wire/guide_system.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hawser::wire {

InteractionDef lifted_element(const World& world, const GuideSystem& guide, bool keeps_length) {
    const InteractionDef& a = world.interaction_def(guide.ids().before);
    const InteractionDef& b = world.interaction_def(guide.ids().behind);
    const double rest =
        rest_length(world, guide.ids().before) + rest_length(world, guide.ids().behind);
    const auto way = [&](InteractionId id) {
        const std::array<Vec3, 2> ends = world.ends(id);
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

}  // namespace hawser::wire
