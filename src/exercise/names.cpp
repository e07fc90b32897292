// SPDX-License-Identifier: Apache-2.0
#include "exercise/names.h"

#include <hawser/hawser.h>

#include <algorithm>
#include <limits>

namespace hawser::exercise {

std::vector<std::string> input_names(const scene::Scene& scene) {
    std::vector<std::string> out;
    for (const InputId id : scene.world.inputs()) out.push_back(scene.world.input_def(id).name);
    for (const scene::SignalInput& input : scene.signal_inputs) out.push_back(input.name);
    for (const SystemSignal& s : scene.world.system_signals())
        if (s.input) out.push_back(s.system + "." + s.name);
    return out;
}

std::vector<std::string> output_names(const World& world) {
    std::vector<std::string> out;
    for (const OutputId id : world.output_ids()) out.push_back(world.output_def(id).name);
    return out;
}

std::pair<std::string, double> resolve_target(const scene::Scene& scene, std::string_view input,
                                              double value) {
    if (!scene.world.find_input(input).valid())
        for (const scene::SignalInput& s : scene.signal_inputs)
            if (s.name == input) return {s.signal, s.factor * std::clamp(value, s.min, s.max)};
    return {std::string(input), value};
}

double present_value(const World& world, const std::string& input) {
    if (const InputId id = world.find_input(input); id.valid()) return world.input(id);
    return world.system_signal(input);
}

bool is_winch(const World& world, const std::string& name) {
    const auto has = [&](const char* signal) {
        return std::any_of(
            world.system_signals().begin(), world.system_signals().end(),
            [&](const SystemSignal& s) { return s.input && s.system == name && s.name == signal; });
    };
    return has("mode") && has("brake") && has("speed");
}

std::vector<std::string> fault_params(FaultKind kind, const World& world,
                                      InteractionId interaction) {
    const KindInfo& info = kind_info(world.interaction_def(interaction).kind);
    if (kind == FaultKind::motor_loses_force)
        return info.is(kMotorKind) ? std::vector<std::string>{"force_min", "force_max"}
                                   : std::vector<std::string>{};
    if (!info.is(kFrictionKind)) return {};
    for (const ParamInfo& param : info.params)
        if (const std::string name = param.name; name == "force" || name == "torque") return {name};
    return {};
}

InputId driving_input(const World& world, InteractionId interaction, const std::string& param) {
    for (const InputId id : world.inputs()) {
        const InputDef& def = world.input_def(id);
        if (def.interaction == interaction && def.param == param) return id;
    }
    return {};
}

std::vector<FaultyInput> faulty_inputs(const Fault& fault, const World& world) {
    std::vector<FaultyInput> out;
    if (is_winch(world, fault.target)) {
        const bool motor = fault.kind == FaultKind::motor_loses_force;
        out.push_back({fault.target + (motor ? ".mode" : ".brake"), motor});
        return out;
    }
    const InteractionId id = world.find_interaction(fault.target);
    if (!id.valid()) return out;
    for (const std::string& param : fault_params(fault.kind, world, id))
        if (const InputId input = driving_input(world, id, param); input.valid())
            out.push_back({world.input_def(input).name, false});
    return out;
}

}  // namespace hawser::exercise
