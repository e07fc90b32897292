// SPDX-License-Identifier: Apache-2.0
#include "record/units.h"
#include "report/start/parts.h"

#include <fmt/format.h>

#include <cmath>

namespace hawser::report::start {
namespace {

/// Share of its mass by which a hull's displacement may be off.
constexpr double kDisplacementOff = 0.01;

}  // namespace

void check_hulls(const World& world, Findings& out) {
    const SeaDef* sea = find_sea(world);
    if (sea == nullptr) return;
    const double level = still_water(world);
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
