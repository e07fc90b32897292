// SPDX-License-Identifier: Apache-2.0
/// Make the system of a vessel from its definition.
#include <hawser/sea.h>
#include <hawser/world.h>

#include "vessel/checks.h"
#include "vessel/control_lines.h"
#include "vessel/vessel_system.h"

#include <memory>
#include <string_view>
#include <vector>

namespace hawser {

System* define(World& world, const VesselDef& def) {
    vessel::check_vessel(world, def);
    const BodyDef body = world.body_def(def.body);
    return &world.add_system(std::make_unique<vessel::VesselSystem>(
        def, body.mass, body.inertia, vessel::Surface(world, def), vessel::fed_lines(world, def)));
}

namespace {

/// Call f(def) for each vessel until f returns true. A const world has no list of its systems, so
/// vessels are found by the names of their signals.
template <class F>
void over_vessels(const World& world, F&& f) {
    std::string_view last;
    for (const SystemSignal& s : world.system_signals()) {
        if (s.system == last) continue;
        last = s.system;
        const auto* found = dynamic_cast<const vessel::VesselSystem*>(world.find_system(last));
        if (found != nullptr && f(found->def())) return;
    }
}

}  // namespace

std::vector<const VesselDef*> vessels_of(const World& world) {
    std::vector<const VesselDef*> out;
    over_vessels(world, [&](const VesselDef& def) {
        out.push_back(&def);
        return false;
    });
    return out;
}

const VesselDef* find_vessel(const World& world, BodyId body) noexcept {
    const VesselDef* out = nullptr;
    over_vessels(world, [&](const VesselDef& def) {
        if (def.body == body) out = &def;
        return out != nullptr;
    });
    return out;
}

}  // namespace hawser
