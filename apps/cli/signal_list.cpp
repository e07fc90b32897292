// SPDX-License-Identifier: Apache-2.0
#include "signal_list.h"

#include "record/scene_info.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <iterator>

namespace hawser::cli {

namespace {

constexpr std::array<const char*, 6> kForceComponents = {"force_x",  "force_y",  "force_z",
                                                         "torque_x", "torque_y", "torque_z"};

std::string unit_of(const World& world, const InputDef& input) {
    if (!input.unit.empty()) return input.unit;
    if (!input.interaction.valid()) return input.component < 3 ? "N" : "N m";
    for (const ParamInfo& p : kind_info(world.interaction_def(input.interaction).kind).params)
        if (input.param == p.name) return p.unit;
    return "1";
}

std::string target_words(const World& world, const InputDef& input) {
    if (input.interaction.valid())
        return fmt::format("{} of {}", input.param,
                           record::interaction_label(world, input.interaction));
    return fmt::format("{} of {}{}", kForceComponents[static_cast<std::size_t>(input.component)],
                       record::body_label(world, input.body), input.local ? ", in its frame" : "");
}

}  // namespace

std::string signal_lines(const World& world) {
    std::string text;
    const auto out = std::back_inserter(text);
    for (const InputId id : world.inputs()) {
        const InputDef& input = world.input_def(id);
        fmt::format_to(out, "  input            {} [{}] {:.6g} … {:.6g}: {}\n", input.name,
                       unit_of(world, input), input.min, input.max, target_words(world, input));
    }
    for (const OutputId id : world.output_ids()) {
        const OutputDef& output = world.output_def(id);
        fmt::format_to(out, "  output           {} [{}]: {} {}\n", output.name, output.unit,
                       output_kind_info(output.kind).name, output.component);
    }
    return text;
}

nlohmann::ordered_json signal_report(const World& world) {
    using List = nlohmann::ordered_json;
    List inputs = List::array(), outputs = List::array();
    for (const InputId id : world.inputs()) {
        const InputDef& input = world.input_def(id);
        inputs.push_back({{"name", input.name},
                          {"unit", unit_of(world, input)},
                          {"min", input.min},
                          {"max", input.max},
                          {"value", world.input(id)},
                          {"sets", target_words(world, input)}});
    }
    for (const OutputId id : world.output_ids()) {
        const OutputDef& output = world.output_def(id);
        outputs.push_back({{"name", output.name},
                           {"unit", output.unit},
                           {"kind", output_kind_info(output.kind).name},
                           {"component", output.component}});
    }
    return {{"inputs", std::move(inputs)}, {"outputs", std::move(outputs)}};
}

}  // namespace hawser::cli
