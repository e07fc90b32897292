// SPDX-License-Identifier: Apache-2.0
#include "report/start/parts.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace hawser::report::start {
namespace {

/// Return the names of the line types for use in water in a scene's text; empty if the text is no
/// scene.
std::vector<std::string> water_line_types(const std::string& text) {
    std::vector<std::string> out;
    const auto scene = nlohmann::json::parse(text, nullptr, false);
    if (!scene.is_object() || !scene.contains("line_types")) return out;
    for (const auto& [name, type] : scene["line_types"].items())
        if (type.is_object() && type.contains("cd_normal")) out.push_back(name);
    return out;
}

/// True if a list of line types, separated by " + ", contains a name.
bool has(const std::string& line_types, const std::string& name) {
    return (" + " + line_types + " + ").find(" + " + name + " + ") != std::string::npos;
}

bool of_links(const World& world, const record::CableInfo& cable) {
    return std::none_of(cable.elements.begin(), cable.elements.end(), [&](InteractionId id) {
        return kind_info(world.interaction_def(id).kind).is(kPulls);
    });
}

}  // namespace

void check_dry_lines(const record::SceneInfo& scene, const World& world, Findings& out) {
    if (find_sea(world) == nullptr) return;
    const std::vector<std::string> wet = water_line_types(scene.text);
    for (const record::CableInfo& cable : scene.cables) {
        if (cable.elements.empty() || !of_links(world, cable)) continue;
        if (std::none_of(wet.begin(), wet.end(),
                         [&](const std::string& name) { return has(cable.line_type, name); }))
            continue;
        out.add(false, FindingKind::dry, {cable.name}, cable.length,
                fmt::format("the cable {} is made of links, which are in air, although its line "
                            "type has \"cd_normal\"; leave out \"as\" for one in the water",
                            record::name_in_quotes(cable.name)));
    }
}

}  // namespace hawser::report::start
