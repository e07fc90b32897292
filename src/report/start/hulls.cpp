// SPDX-License-Identifier: Apache-2.0
#include "base/held_together.h"
#include "record/units.h"
#include "report/start/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <vector>

namespace hawser::report::start {
namespace {

/// Allowed relative difference between a hull's displacement and the carried mass.
constexpr double kDisplacementOff = 0.01;

struct Carried {
    BodyId body{};  ///< Body of its first hull.
    int hulls = 0;
    bool is_checked = true;  ///< True if it floats freely and its statics do not come from a table.
    double weight = 0.0;     ///< Mass plus the downward pull of lines over gravity [kg].
    double water = 0.0;      ///< Displaced mass of water [kg].
    bool alone = true;       ///< True if the weight is the mass of that body alone.
};

using Floats = std::map<std::size_t, Carried>;

Floats floating_groups(const World& world, const SeaDef& sea, const base::LinkedGroups& afloat,
                       double level) {
    Floats out;
    for (const WaterHull& hull : sea.hulls) {
        Carried& c = out[afloat.group(hull.body)];
        if (c.hulls++ == 0) c.body = hull.body;
        c.is_checked = c.is_checked && !hull.linear.on;
        if (!hull.linear.on)
            c.water += sea.density * hull_statics(hull.mesh, world.pose(hull.body), level).volume;
    }
    return out;
}

/// Add the weight that each floating group carries: masses, and forces of lines and of the scene.
void add_carried_weight(const World& world, const base::LinkedGroups& afloat, double gravity,
                        Floats& floats) {
    for (const BodyId id : world.bodies()) {
        const auto found = floats.find(afloat.group(id));
        if (found == floats.end()) continue;
        Carried& c = found->second;
        const BodyDef& def = world.body_def(id);
        if (def.kind == BodyKind::fixed || def.kind == BodyKind::kinematic) c.is_checked = false;
        if (def.kind == BodyKind::scalar) continue;
        if (def.gravity) c.weight += def.mass;
        c.weight -= def.force.z() / gravity;
        c.alone = c.alone && id == c.body && def.gravity && def.force.z() == 0.0;
    }
    for (const InteractionId id : world.interactions()) {
        const double tension = start_tension(world, id);
        if (!(tension > 0.0)) continue;
        const InteractionDef& def = world.interaction_def(id);
        const RowsView view = world.solver().rows(id);
        for (std::size_t b = 0; b < static_cast<std::size_t>(kind_info(def.kind).bodies); ++b) {
            if (world.body_def(def.body[b]).kind == BodyKind::scalar) continue;
            const auto found = floats.find(afloat.group(def.body[b]));
            if (found == floats.end()) continue;
            found->second.weight += tension * view.jacobian[b][0][2] / gravity;
            found->second.alone = false;
        }
    }
}

/// Add the displacement of small bodies in the water that belong to a floating group.
void add_small_displacements(const World& world, const SeaDef& sea,
                             const base::LinkedGroups& afloat, double level, Floats& floats) {
    for (const WaterBody& small : sea.bodies) {
        const auto found = floats.find(afloat.group(small.body));
        if (found == floats.end() || world.pose(small.body).position.z() > level) continue;
        found->second.water += sea.density * small.volume;
    }
}

/// True if a kind is a hydrostatic spring.
bool floats_by_itself(const KindInfo& kind) {
    return std::any_of(kind.params.begin(), kind.params.end(), [](const ParamInfo& param) {
        return std::string_view(param.name) == "heave_stiffness";
    });
}

/// Warn about hydrostatic springs on a body that already floats by its hull.
void check_hydrostatics(const World& world, const Floats& floats, const base::LinkedGroups& afloat,
                        Findings& out) {
    for (const InteractionId id : world.interactions()) {
        const InteractionDef& def = world.interaction_def(id);
        if (!floats_by_itself(kind_info(def.kind))) continue;
        if (floats.find(afloat.group(def.body[0])) == floats.end()) continue;
        const std::string name = record::body_label(world, def.body[0]);
        const std::string spring = record::interaction_label(world, id);
        out.add(false, FindingKind::displacement, {name, spring}, 2.0,
                fmt::format("{} has a hull in the sea and the hydrostatic {}: both make it float; "
                            "leave out one of them",
                            record::name_in_quotes(name), record::name_in_quotes(spring)));
    }
}

/// Return the volume that a rod displaces [m³].
double displaced_volume(const WaterRod& rod) {
    return rod.water.area() * (rod.to - rod.from).norm();
}

/// Warn once for each body about water that both its hull and its rods displace.
void check_rods(const World& world, const SeaDef& sea, Findings& out) {
    std::vector<BodyId> reported;
    for (const WaterHull& hull : sea.hulls) {
        if (std::find(reported.begin(), reported.end(), hull.body) != reported.end()) continue;
        reported.push_back(hull.body);
        double volume = 0.0;
        for (const WaterRod& rod : sea.rods)
            if (rod.body == hull.body) volume += displaced_volume(rod);
        if (!(volume > 0.0)) continue;
        const std::string name = record::body_label(world, hull.body);
        const double water = sea.density * volume;
        out.add(false, FindingKind::displacement, {name}, world.body_def(hull.body).mass / water,
                fmt::format("{} has a hull, and rods that displace up to {} of water: the part "
                            "inside the hull counts twice; give such rods displaced_area 0",
                            record::name_in_quotes(name), record::with_unit(water, "kg")));
    }
}

}  // namespace

void check_hulls(const World& world, Findings& out) {
    const SeaDef* sea = find_sea(world);
    if (sea == nullptr || sea->hulls.empty()) return;
    check_rods(world, *sea, out);
    const double gravity = world.settings().gravity.norm();
    const double level = still_water(world);
    const base::LinkedGroups afloat(world);
    Floats floats = floating_groups(world, *sea, afloat, level);
    add_carried_weight(world, afloat, gravity, floats);
    add_small_displacements(world, *sea, afloat, level, floats);
    check_hydrostatics(world, floats, afloat, out);
    for (const auto& [group, c] : floats) {
        if (!c.is_checked) continue;
        if (c.water > 0.0 && std::abs(c.water - c.weight) <= kDisplacementOff * std::abs(c.weight))
            continue;
        const std::string name = record::body_label(world, c.body);
        out.add(false, FindingKind::displacement, {name}, c.weight / c.water,
                fmt::format(
                    "the {} of {} {} {} of water where it starts, and {} is {}: it {}; see "
                    "hawser inspect --hydrostatics",
                    c.hulls == 1 ? "hull" : "hulls", record::name_in_quotes(name),
                    c.hulls == 1 ? "displaces" : "displace", record::with_unit(c.water, "kg"),
                    c.alone ? "its mass" : "the mass that it carries, including lines,",
                    record::with_unit(c.weight, "kg"), c.water < c.weight ? "sinks in" : "rises"));
    }
}

}  // namespace hawser::report::start
