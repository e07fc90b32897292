// SPDX-License-Identifier: Apache-2.0
#include "edit/node_stretch.h"

#include "base/index.h"
#include "context/context.h"
#include "edit/edits.h"
#include "edit/node_pieces.h"

#include <algorithm>
#include <cmath>

namespace hawser::edit {

double nearer_to_zero(double a, double b) noexcept {
    if (!(a * b > 0.0)) return 0.0;
    return std::fabs(a) < std::fabs(b) ? a : b;
}

double rest_length_for_energy(double length, double stiffness, double energy) noexcept {
    const double q = std::max(0.0, energy) / stiffness;
    // The smaller root of l₀² − 2(l + q) l₀ + l² = 0; the product of both is l².
    return length * length / (length + q + std::sqrt(q * (2.0 * length + q)));
}

double exerted_force(const context::StepContext& ctx, std::int32_t id) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    const double pull = -in.lambda[at(in.row_begin[at(id)])] / ctx.model.def.step;
    return (in.flags[at(id)] & model::kOneSided) ? std::max(0.0, pull) : pull;
}

double energy_by_length(const context::StepContext& ctx, std::int32_t id) noexcept {
    if (!is_wound(ctx, id)) return energy_of_interaction(ctx, id);
    const model::Interactions& in = ctx.model.interactions;
    if (!ctx.state.started || in.parted[at(id)] != 0) return 0.0;
    const model::RowState s = in.row_state(id, ctx.model.bodies);
    const double longer = s.g[0] - 0.5 * ctx.model.def.step * (s.rate[0] + s.carried[0]);
    if ((in.flags[at(id)] & model::kOneSided) && longer < 0.0) return 0.0;
    return 0.5 * longer * longer / in.epsilon[at(in.row_begin[at(id)])];
}

void limit_stretch(context::StepContext& ctx, std::int32_t id, double most) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    const auto row = at(in.row_begin[at(id)]);
    constexpr double kEqual = 1.0 + 1e-9;
    const double pull = exerted_force(ctx, id);
    // The energy refers to the rest length half a step before the poses: once corrects to second
    // order.
    constexpr int kTimes = 3;
    for (int i = 0; i < kTimes; ++i) {
        const double energy = energy_by_length(ctx, id);
        if (!(energy > kEqual * most)) return;
        const double rest = in.rest_length[at(id)];
        const double length = rest + std::sqrt(2.0 * energy * in.epsilon[row]);
        const double now = rest_length_for_energy(length, stiffness_of(ctx, id), most);
        const double mass = mass_of_element(ctx, id);
        set_element(ctx, id, now, mass, pull);
        set_element(ctx, id, now, mass, std::max(0.0, std::min(pull, force_of(ctx, id))));
    }
}

}  // namespace hawser::edit
