// SPDX-License-Identifier: Apache-2.0
#include "record/units.h"
#include "report/start/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace hawser::report::start {
namespace {

/// Share of its mass by which a hull's displacement may be off.
constexpr double kDisplacementOff = 0.01;

/// What a rod displaces by itself [m³].
double volume_of(const WaterRod& rod) {
    const double d = rod.water.diameter, given = rod.water.volume;
    const double area = std::isnan(given) ? 0.25 * std::numbers::pi * d * d : given;
    return area * (rod.to - rod.from).norm();
}

/// Water that a hull and rods of one body both displace, once a body.
void check_rods(const World& world, const SeaDef& sea, Findings& out) {
    std::vector<BodyId> told;
    for (const WaterHull& hull : sea.hulls) {
        if (std::find(told.begin(), told.end(), hull.body) != told.end()) continue;
        told.push_back(hull.body);
        double volume = 0.0;
        for (const WaterRod& rod : sea.rods)
            if (rod.body == hull.body) volume += volume_of(rod);
        if (!(volume > 0.0)) continue;
        const std::string name = record::body_label(world, hull.body);
        const double water = sea.density * volume;
        out.add(false, FindingKind::displacement, {name}, world.body_def(hull.body).mass / water,
                fmt::format("{} has a hull, and rods that displace up to {} of water beside: what "
                            "lies inside the hull counts twice; give such rods displaced_area 0",
                            record::name_in_quotes(name), record::with_unit(water, "kg")));
    }
}

}  // namespace

void check_hulls(const World& world, Findings& out) {
    const SeaDef* sea = find_sea(world);
    if (sea == nullptr) return;
    check_rods(world, *sea, out);
    const double level = Sea(*sea, world.settings().gravity.norm()).tide(world.time());
    for (const WaterHull& hull : sea->hulls) {
        const BodyDef& def = world.body_def(hull.body);
        // What does not move floats anywhere, and what has no weight floats on nothing.
        if (def.kind != BodyKind::rigid || !def.gravity || hull.linear.on) continue;
        const double water =
            sea->density * hull_statics(hull.mesh, world.pose(hull.body), level).volume;
        const double ratio = def.mass / water;
        if (water > 0.0 && std::abs(water - def.mass) <= kDisplacementOff * def.mass) continue;
        const std::string name = record::body_label(world, hull.body);
        out.add(false, FindingKind::displacement, {name}, ratio,
                fmt::format("the hull of {} displaces {} of water where it starts, and its mass is "
                            "{}: it {}; see hawser inspect --hydrostatics",
                            record::name_in_quotes(name), record::with_unit(water, "kg"),
                            record::with_unit(def.mass, "kg"),
                            water < def.mass ? "sinks in" : "rises"));
    }
}

}  // namespace hawser::report::start
