// SPDX-License-Identifier: Apache-2.0
#include "report/start/parts.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace hawser::report::start {
namespace {

/// Names of guides without an upper roller in a scene's text; none where it is no scene.
std::vector<std::string> open_guides(const std::string& text) {
    std::vector<std::string> out;
    const auto scene = nlohmann::json::parse(text, nullptr, false);
    if (!scene.is_object() || !scene.contains("guides")) return out;
    for (const auto& guide : scene["guides"])
        if (guide.is_object() && guide.contains("name") && guide.value("closed", true) == false)
            out.push_back(guide["name"]);
    return out;
}

}  // namespace

void check_guides(const record::SceneInfo& scene, const World& world, Findings& out) {
    constexpr double kLetGo = -2e-3;  // [rad], as the guide itself has it
    for (const std::string& name : open_guides(scene.text)) {
        const InteractionId friction = world.find_interaction(name + "/friction");
        if (!world.alive(friction)) continue;
        const double angle = world.interaction_def(friction).get("angle");
        if (!(angle < kLetGo)) continue;
        out.add(false, FindingKind::guide, {name}, angle,
                fmt::format("the cable on guide {} turns by {:.3g} rad, so that the guide would "
                            "have to pull it: the cable starts lifted off; give the other sign of "
                            "\"radius\", or \"closed\": true",
                            record::name_in_quotes(name), angle));
    }
}

}  // namespace hawser::report::start
