// SPDX-License-Identifier: Apache-2.0
#include "observe/scene_info.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::observe {

double element_tension(const World& world, InteractionId element) {
    const std::span<const double> force = world.force(element);
    if (force.empty()) return 0.0;
    switch (world.interaction_def(element).kind) {
        case InteractionKind::Stretch:
        case InteractionKind::WinchStretch:
        case InteractionKind::Distance:
            return -force[0];
        default:
            break;
    }
    double sum = 0.0;
    for (const double f : force.first(std::min<std::size_t>(3, force.size()))) sum += f * f;
    return std::sqrt(sum);
}

std::string body_label(const World& world, BodyId body) {
    if (!body.valid()) return "-";
    const std::string& name = world.body_def(body).name;
    return name.empty() ? fmt::format("body {}", body.index) : name;
}

std::string interaction_label(const World& world, InteractionId interaction) {
    if (!interaction.valid()) return "-";
    const InteractionDef& def = world.interaction_def(interaction);
    return def.name.empty() ? fmt::format("{} {}", kind_info(def.kind).name, interaction.index)
                            : def.name;
}

}  // namespace hawser::observe
