// SPDX-License-Identifier: Apache-2.0
#include "record/input_range.h"

#include <fmt/format.h>

#include <string>

namespace hawser::record {
namespace {

void check_within(std::string_view name, double value, double min, double max,
                  const std::string& unit) {
    if (value >= min && value <= max) return;
    const std::string of = unit.empty() || unit == "1" ? "" : " " + unit;
    throw DefError(
        fmt::format("the input \"{}\": {:.6g}{} is outside its range, {:.6g} to {:.6g}{}", name,
                    value, of, min, max, of));
}

std::string unit_of(const World& world, const InputDef& def) {
    if (!def.unit.empty()) return def.unit;
    if (!def.interaction.valid()) return def.component < 3 ? "N" : "N m";
    for (const ParamInfo& p : kind_info(world.interaction_def(def.interaction).kind).params)
        if (def.param == p.name) return p.unit;
    return {};
}

}  // namespace

void check_input_range(const scene::Scene& scene, std::string_view name, double value) {
    const World& world = scene.world;
    if (const InputId id = world.find_input(name); id.valid()) {
        const InputDef& def = world.input_def(id);
        return check_within(name, value, def.min, def.max, unit_of(world, def));
    }
    double factor = 1.0;
    std::string_view signal = name;
    for (const scene::SignalInput& lever : scene.signal_inputs) {
        if (lever.name != name) continue;
        check_within(name, value, lever.min, lever.max, lever.unit);
        signal = lever.signal;
        factor = lever.factor;
        break;
    }
    for (const SystemSignal& s : world.system_signals())
        if (s.input && s.system + "." + s.name == signal)
            check_within(name, factor * value, s.min, s.max, s.unit);
}

}  // namespace hawser::record
