// SPDX-License-Identifier: Apache-2.0
#include "session/control_ranges.h"

namespace hawser::session {

std::vector<record::ControlRange> control_ranges(const scene::Scene& scene, std::size_t places) {
    const World& world = scene.world;
    std::vector<record::ControlRange> ranges(places);
    for (const InputId id : world.inputs()) {
        const InputDef& def = world.input_def(id);
        record::ControlRange& range = ranges[static_cast<std::size_t>(id.index)];
        range = {-1e30, 1e30, def.component < 3 ? "N" : "N m"};
        if (!def.interaction.valid()) continue;
        for (const ParamInfo& p : kind_info(world.interaction_def(def.interaction).kind).params)
            if (def.param == p.name) range = {p.min, p.max, p.unit};
    }
    for (const scene::SignalInput& input : scene.signal_inputs)
        ranges.push_back({input.min, input.max, input.unit});
    for (const SystemSignal& s : world.system_signals())
        if (s.input) ranges.push_back({s.min, s.max, s.unit});
    return ranges;
}

}  // namespace hawser::session
