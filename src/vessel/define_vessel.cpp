// SPDX-License-Identifier: Apache-2.0
/// From the definition of a vessel to its system.
#include <hawser/sea.h>
#include <hawser/world.h>

#include "vessel/checks.h"
#include "vessel/vessel_system.h"

#include <memory>

namespace hawser {

System* define(World& world, const VesselDef& def) {
    vessel::check_vessel(world, def);
    const BodyDef body = world.body_def(def.body);
    return &world.add_system(std::make_unique<vessel::VesselSystem>(def, body.mass, body.inertia));
}

const VesselDef* find_vessel(const World& world, BodyId body) noexcept {
    // Systems have no list for a const world: their names are those of the signals.
    std::string_view last;
    for (const SystemSignal& s : world.system_signals()) {
        if (s.system == last) continue;
        last = s.system;
        const auto* found = dynamic_cast<const vessel::VesselSystem*>(world.find_system(last));
        if (found != nullptr && found->def().body == body) return &found->def();
    }
    return nullptr;
}

}  // namespace hawser
