// SPDX-License-Identifier: Apache-2.0
#include "base/body_dof.h"
#include "base/dense.h"
#include "record/units.h"
#include "report/start/parts.h"
#include "report/start/start_forces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace hawser::report::start {

namespace {

/// Limits of under-resolved motion. First: h √(T/ρ)/l, for the transverse vibration of single
/// elements. Second: h² f r/I, for the rotation of a body about a joint.
constexpr double kMaxWireVibration = 2.0, kMaxJointVibration = 1.5;

/// Return the largest r·(r×)ᵀI⁻¹(r×)/r²: the angular response of the body to a force at this arm
/// [1/(kg m)].
double angular_response(const World& world, BodyId id, const Vec3& arm) {
    const BodyDef& def = world.body_def(id);
    if (def.kind != BodyKind::rigid || !(arm.norm() > 0.0)) return 0.0;
    Mat3 cross;
    cross << 0.0, -arm.z(), arm.y(), arm.z(), 0.0, -arm.x(), -arm.y(), arm.x(), 0.0;
    const Mat3 turning = cross.transpose() * def.inertia.inverse() * cross;
    return base::symmetric_eigenvalues(turning)[2] / arm.norm();
}

/// Number of cables that end at each body.
using CablesAt = std::vector<double>;

struct Fastest {
    double s = 0.0, force = 0.0;
    BodyId body{};
    InteractionId joint{};
};

Fastest fastest_at(const World& world, const StartForces& forces, InteractionId id) {
    const InteractionDef& def = world.interaction_def(id);
    const KindInfo& kind = kind_info(def.kind);
    Fastest worst;
    const std::string_view units = kind.row_units;
    if (!kind.uses_points || kind.bodies != 2 || units.size() < 2 || units[0] != 'm' ||
        units[1] != 'm')
        return worst;
    const double force = forces.push(id);
    const double h = world.settings().step;
    for (std::size_t b = 0; b < 2; ++b) {
        const double s = h * h * force * angular_response(world, def.body[b], def.point[b]);
        if (s > worst.s) worst = {s, force, def.body[b], id};
    }
    return worst;
}

void report_vibration(const World& world, std::vector<std::string> about, const std::string& what,
                      const Fastest& worst, Findings& out) {
    const double h = world.settings().step;
    out.add(
        false, FindingKind::joint_step, std::move(about), worst.s,
        fmt::format("{}: under the {} in {} the body {} oscillates within {:.2g} steps (h² f r/I = "
                    "{:.3g}); this oscillation is damped, not resolved; resolving it needs steps "
                    "of {:.2g} ms",
                    what, record::with_unit(worst.force, "N"),
                    record::name_in_quotes(record::interaction_label(world, worst.joint)),
                    record::name_in_quotes(record::body_label(world, worst.body)),
                    6.283 / std::sqrt(worst.s), worst.s,
                    1e3 * h * std::sqrt(kMaxJointVibration / worst.s)));
}

/// Check joints that are in no cable. Connected joints are reported once.
void check_other_joints(const World& world, const std::vector<Fastest>& fast, Findings& out) {
    std::vector<std::int32_t> set(fast.size());
    std::iota(set.begin(), set.end(), 0);
    const auto find = [&](std::int32_t i) {
        while (set[static_cast<std::size_t>(i)] != i) i = set[static_cast<std::size_t>(i)];
        return i;
    };
    std::map<std::int32_t, std::int32_t> first;  // Index for each body.
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(fast.size()); ++i) {
        const InteractionDef& def = world.interaction_def(fast[static_cast<std::size_t>(i)].joint);
        for (std::size_t b = 0; b < 2; ++b) {
            if (base::dof_of(world.body_def(def.body[b]).kind) == 0) continue;
            const std::int32_t other = find(first.emplace(def.body[b].index, i).first->second);
            const std::int32_t own = find(i);
            set[static_cast<std::size_t>(std::max(own, other))] = std::min(own, other);
        }
    }
    std::map<std::int32_t, std::vector<Fastest>> groups;
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(fast.size()); ++i)
        groups[find(i)].push_back(fast[static_cast<std::size_t>(i)]);
    for (const auto& [root, group] : groups) {
        const Fastest& worst = *std::max_element(
            group.begin(), group.end(), [](const auto& a, const auto& b) { return a.s < b.s; });
        std::vector<std::string> about;
        for (const Fastest& one : group)
            about.push_back(record::interaction_label(world, one.joint));
        report_vibration(world, about,
                         group.size() == 1 ? record::interaction_in_words(world, worst.joint)
                                           : fmt::format("{} joints from {} to {}", group.size(),
                                                         record::name_in_quotes(about.front()),
                                                         record::name_in_quotes(about.back())),
                         worst, out);
    }
}

/// Return the largest pull at an end of a cable in its direction, divided by the number of cables
/// at that end.
double pull_at_ends(const World& world, const record::CableInfo& cable, const CablesAt& cables_at) {
    double pull = 0.0;
    const BodyId ends[2] = {cable.nodes.front(), cable.nodes.back()};
    const Vec3 along = world.pose(ends[1]).position - world.pose(ends[0]).position;
    if (!(along.norm() > 0.0)) return 0.0;
    for (int e = 0; e < 2; ++e) {
        const BodyDef& def = world.body_def(ends[e]);
        if (def.kind != BodyKind::rigid && def.kind != BodyKind::lump) continue;
        const double outward = (e == 0 ? -1.0 : 1.0) * def.force.dot(along.normalized());
        pull = std::max(pull, outward / cables_at[static_cast<std::size_t>(ends[e].index)]);
    }
    return pull;
}

/// True if the sea acts on the cable.
bool in_the_sea(const World& world, const std::string& cable) {
    const SeaDef* sea = find_sea(world);
    const WireId wire = world.wires().find(cable);
    return sea != nullptr && wire.valid() &&
           std::any_of(sea->lines.begin(), sea->lines.end(),
                       [&](const WaterLine& line) { return line.wire == wire; });
}

void check_wire(const World& world, const record::CableInfo& cable, const StartForces& forces,
                double at_ends, Findings& out) {
    const double h = world.settings().step;
    double worst = 0.0, tension = 0.0;
    const bool wet = in_the_sea(world, cable.name);
    for (std::size_t i = 0; i < cable.elements.size() && i + 1 < cable.nodes.size(); ++i) {
        const InteractionDef& def = world.interaction_def(cable.elements[i]);
        double mass = 0.0;
        int lumps = 0;
        for (const std::size_t n : {i, i + 1}) {
            const BodyDef& node = world.body_def(cable.nodes[n]);
            const bool inside = n > 0 && n + 1 < cable.nodes.size();
            if (!inside || node.kind != BodyKind::lump) continue;
            mass += node.mass;
            ++lumps;
        }
        if (lumps == 0) continue;
        mass /= lumps;
        const double length = def.get("length");
        // A step from rest neglects buoyancy: in the sea the start is at rest, or slack.
        const double at_start = start_tension(world, cable.elements[i]);
        const double step = wet && at_start > 0.0 ? 0.0 : forces.push(cable.elements[i]);
        const double pull = std::max({at_start, step, at_ends});
        const double ratio = h * std::sqrt(pull / (mass * length));  // ρ = m/l
        if (ratio <= worst) continue;
        worst = ratio;
        tension = pull;
    }
    if (worst < kMaxWireVibration) return;
    out.add(false, FindingKind::wire_step, {cable.name}, worst,
            fmt::format("the cable {} sways faster than the step: under {} a wave passes {:.3g} "
                        "elements in a step (h √(T/ρ)/l), where less than {:.2g} are followed; "
                        "that sway is damped, which steps of {:.2g} ms or {:.0f} elements would "
                        "follow",
                        record::name_in_quotes(cable.name), record::with_unit(tension, "N"), worst,
                        kMaxWireVibration, 1e3 * h * kMaxWireVibration / worst,
                        std::max(1.0, std::floor(static_cast<double>(cable.elements.size()) *
                                                 kMaxWireVibration / worst))));
}

}  // namespace

void check_steps(const record::SceneInfo& scene, const World& world, Findings& out) {
    const StartForces forces(world);
    if (!forces.known()) {
        out.add(false, FindingKind::unexamined, {}, 0.0,
                "the forces at the start could not be computed, so the resolution of the step is "
                "unknown: masses in this scene differ too much");
        return;
    }
    CablesAt cables_at(static_cast<std::size_t>(world.body_count()), 0.0);
    for (const record::CableInfo& cable : scene.cables)
        for (const BodyId end : {cable.nodes.front(), cable.nodes.back()})
            cables_at[static_cast<std::size_t>(end.index)] += 1.0;
    std::vector<bool> of_cable(static_cast<std::size_t>(world.interaction_count()), false);
    for (const record::CableInfo& cable : scene.cables) {
        Fastest worst;
        bool lumps = false;
        for (const InteractionId id : cable.elements) {
            of_cable[static_cast<std::size_t>(id.index)] = true;
            lumps |= kind_info(world.interaction_def(id).kind).is(kWireElement);
            const Fastest here = fastest_at(world, forces, id);
            if (here.s > worst.s) worst = here;
        }
        if (lumps) check_wire(world, cable, forces, pull_at_ends(world, cable, cables_at), out);
        if (worst.s > kMaxJointVibration)
            report_vibration(world, {cable.name}, "the cable " + record::name_in_quotes(cable.name),
                             worst, out);
    }
    std::vector<Fastest> others;
    for (const InteractionId id : world.interactions()) {
        if (of_cable[static_cast<std::size_t>(id.index)]) continue;
        const Fastest here = fastest_at(world, forces, id);
        if (here.s > kMaxJointVibration) others.push_back(here);
    }
    check_other_joints(world, others, out);
}

}  // namespace hawser::report::start
