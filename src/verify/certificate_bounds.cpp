// SPDX-License-Identifier: Apache-2.0
/// Check rows with bounded forces: the largest excess and its row.
#include "verify/certificate.h"
#include "verify/interaction_forces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::verify {

std::string object_label(const char* what, const std::string& name, std::int32_t index) {
    return name.empty() ? fmt::format("{} {}", what, index) : fmt::format("\"{}\"", name);
}

double Verifier::bound_excess(const World& world) {
    double excess = 0.0;
    worst_excess_ = {};
    for (const InteractionId id : interactions_) {
        const ForceRange range = force_range(world, id, pose_);
        if (!range.bounded) continue;
        const double force = world.force(id)[0];
        const double bound = std::clamp(force, range.low, range.high);
        // With contacts, a force below the floor does not activate a row.
        const InteractionDef& def = world.interaction_def(id);
        const bool scalar = std::any_of(def.body.begin(), def.body.end(), [&](BodyId b) {
            return b.valid() && world.body_def(b).kind == BodyKind::scalar;
        });
        const double floor = scalar ? std::min(rounding_floor_, scalar_floor_) : rounding_floor_;
        const double beyond = step_ * std::abs(force - bound) - floor;
        if (beyond <= 0.0) continue;
        const double fraction = beyond / std::max(step_ * std::abs(bound), floor);
        if (fraction <= excess) continue;
        excess = fraction;
        worst_excess_ = {.row = id, .force = force, .bound = bound};
        if (std::isnan(fraction)) break;  // NaN: no larger excess is possible.
    }
    return excess;
}

std::string Verifier::describe_worst_bound(const World& world) const {
    const InteractionDef& def = world.interaction_def(worst_excess_.row);
    const char* unit = kind_info(def.kind).row_units[0] == 'm' ? "N" : "N m";
    return fmt::format("{} gives {:.6g} {}, beyond its bound of {:.6g} {}",
                       object_label("interaction", def.name, worst_excess_.row.index),
                       worst_excess_.force, unit, worst_excess_.bound, unit);
}

}  // namespace hawser::verify
