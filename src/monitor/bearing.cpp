// SPDX-License-Identifier: Apache-2.0
#include "monitor/bearing.h"

#include "base/index.h"
#include "context/view.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hawser::monitor {

Finding strain_finding(context::Model& model, const context::State& state,
                       context::MonitorState& memory) noexcept {
    constexpr double kMaxElongationRatio =
        1.25;  // Includes the motion of half a step, and damping.
    const assembly::View v = context::row_view(model);
    Finding out{.value = 0.0,
                .doubtful = 0.0,
                .wrong = 0.0,
                .time = state.time,
                .interaction = {},
                .body = {}};
    double longest = 0.0;
    for (std::size_t i = 0; i < model.system.breakable.size(); ++i) {
        const std::int32_t id = model.system.breakable[i], row = v.row_begin[id];
        const double length = v.rest_length[id];
        if (v.parted[id] != 0 || !(length > 0.0)) continue;
        const double soft = v.epsilon[row] / length;  // strain per newton
        const double bears = soft * model.system.breaking_load[i];
        const double stretched = v.g[row] / length, pulled = -soft * v.lambda[row] / v.h;
        longest = std::max(longest, stretched / (kMaxElongationRatio * bears));
        const double most = std::max(stretched, pulled);
        const double fraction = most / std::max(limit::kMostStrain, limit::kMostBreaking * bears);
        if (fraction <= out.wrong) continue;
        out.wrong = fraction;
        out.value = -most;
        out.interaction = model.interactions.id(id);
    }
    const double lasting_strain = std::min({longest, memory.overlong[0], memory.overlong[1]});
    memory.overlong = {longest, memory.overlong[0]};
    out.doubtful = std::max(lasting_strain, out.wrong);
    return out;
}

Finding wound_finding(const context::Model& model, const context::State& state,
                      context::MonitorState& memory) noexcept {
    // Fraction of the element length up to which its law continues.
    constexpr double kLawEndFraction = 0.01;
    Finding out{.value = 0.0,
                .doubtful = 0.0,
                .wrong = 0.0,
                .time = state.time,
                .interaction = {},
                .body = {}};
    const model::Interactions& in = model.interactions;
    for (const std::int32_t id : in.winches) {
        const InteractionDef& d = in.def[at(id)];
        if (in.parted[at(id)] != 0) continue;
        const double length = in.length_at_drum_or_slide(id, model.bodies);
        const double fraction = -length / (kLawEndFraction * d.params[0]);
        if (fraction <= out.wrong) continue;
        out.wrong = fraction;
        out.value = length;
        out.interaction = in.id(id);
    }
    const double now = out.wrong;
    out.doubtful = out.wrong = std::min({now, memory.wound[0], memory.wound[1]});
    memory.wound = {now, memory.wound[0]};
    return out;
}

}  // namespace hawser::monitor
