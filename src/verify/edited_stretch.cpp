// SPDX-License-Identifier: Apache-2.0
#include "verify/edited_stretch.h"

#include "verify/interaction_forces.h"
#include "verify/line_path.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hawser::verify {

namespace {

std::size_t at_index(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Call f(element, its definition) for all unbroken elements of wires.
template <class F>
void each_element(const World& world, F&& f) {
    for (const WireId wire : world.wires().ids())
        for (const InteractionId id : world.wires().elements(wire))
            if (world.alive(id) && world.intact(id)) f(id, world.interaction_def(id));
}

/// Return the rest length of an element [m]. @param pose  Function (body) -> its pose.
/// @param driven  True if an input may set a parameter of the element.
template <class P>
double rest_length_at(const World& world, InteractionId id, bool driven, P&& pose) {
    const InteractionDef& def = world.interaction_def(id);
    // parameter() searches all inputs.
    const auto value = [&](const char* name) {
        return driven ? parameter(world, id, name) : def.get(name);
    };
    const double length = value("length");
    if (!kind_info(def.kind).is(kWoundUp)) return length;
    const double turned = pose(def.body[2]).position.x();
    return length + value("radius") * (turned - def.get("drum_zero"));
}

/// Return the interactions with a parameter that an input sets, sorted.
std::vector<InteractionId> driven_by_inputs(const World& world) {
    std::vector<InteractionId> out;
    for (const InputId i : world.inputs())
        if (const InteractionId id = world.input_def(i).interaction; id.valid()) out.push_back(id);
    std::sort(out.begin(), out.end());
    return out;
}

/// Return ½ g² EA/l₀ [J]. A tension-only line that is shorter than l₀ stores no energy.
double stretch_energy(const InteractionDef& def, double gap, double rest) {
    if (gap < 0.0 && def.get("tension_only") != 0.0) return 0.0;
    return rest > 0.0 ? 0.5 * gap * gap * def.get("EA") / rest : 0.0;
}

/// Return the elongation of an element between two states [m].
double elongation(const World& world, InteractionId id, std::span<const Pose> from,
                  std::span<const Pose> to) {
    const Attached first(world, id, from), second(world, id, to);
    const LineEnds was = line_ends(first), is = line_ends(second);
    double sum = (is.at[1] - is.at[0]).norm() - (was.at[1] - was.at[0]).norm();
    for (const int slot : {0, 1}) {
        const double radius = wheel_at(first.def(), slot);
        if (radius == 0.0) continue;
        const Vec3 n = second.axis(slot, 2);
        const Vec3 u = was.along - was.along.dot(n) * n, v = is.along - is.along.dot(n) * n;
        const double turn = std::atan2(u.cross(v).dot(n), u.dot(v));
        sum += (slot == 0 ? radius : -radius) * turn;
    }
    return sum;
}

std::vector<Pose> present_poses(const World& world, std::span<const Pose> known) {
    std::vector<Pose> out(known.begin(), known.end());
    for (const BodyId id : world.bodies()) out[at_index(id.index)] = world.pose(id);
    return out;
}

}  // namespace

double EditedStretch::elastic_energy(const World& world) {
    double sum = 0.0;
    const std::vector<InteractionId> driven = driven_by_inputs(world);
    const auto present = [&](BodyId body) { return world.pose(body); };
    each_element(world, [&](InteractionId id, const InteractionDef& def) {
        const double gap = world.violation(id)[0];
        if (gap < 0.0 && def.get("tension_only") != 0.0) return;
        const bool sets = std::binary_search(driven.begin(), driven.end(), id);
        sum += stretch_energy(def, gap, rest_length_at(world, id, sets, present));
    });
    return sum;
}

double EditedStretch::elastic_change(const World& world, std::span<const Pose> pose) const {
    std::vector<Pose> before(pose.begin(), pose.end());
    before.resize(at_index(world.body_count()));
    const std::vector<Pose> now = present_poses(world, before);
    for (const BodyId id : world.bodies()) {
        const BodyKind kind = world.body_def(id).kind;
        if (kind != BodyKind::lump && kind != BodyKind::scalar) continue;
        Pose& then = before[at_index(id.index)];
        then = now[at_index(id.index)];
        then.position -= world.settings().step * world.velocity(id).linear;
    }
    double sum = 0.0;
    each_element(world, [&](InteractionId id, const InteractionDef& def) {
        const auto of = [](const std::vector<Pose>& all) {
            return [&all](BodyId body) -> const Pose& { return all[at_index(body.index)]; };
        };
        const double rest_length_before = rest_length_at(world, id, true, of(before)),
                     rest_length_now = rest_length_at(world, id, true, of(now));
        const double gap = world.violation(id)[0] - elongation(world, id, before, now) +
                           (rest_length_now - rest_length_before);
        sum += stretch_energy(def, gap, rest_length_before);
    });
    return sum - before_;
}

}  // namespace hawser::verify
