// SPDX-License-Identifier: Apache-2.0
#include "access/copies.h"

namespace hawser::stepper {

std::int32_t body_count(const StepContext& ctx) noexcept {
    return ctx.model.cuts.bodies >= 0 ? ctx.model.cuts.bodies : ctx.model.bodies.count();
}

std::int32_t interaction_count(const StepContext& ctx) noexcept {
    return ctx.model.cuts.interactions >= 0 ? ctx.model.cuts.interactions
                                            : ctx.model.interactions.count();
}

std::int32_t original(const StepContext& ctx, std::int32_t id) noexcept {
    const std::int32_t n = interaction_count(ctx);
    return id < n ? id : ctx.model.cuts.of[at(id - n)];
}

std::int32_t user_rows(const StepContext& ctx) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    const std::int32_t count = interaction_count(ctx);
    return count < in.count() ? in.row_begin[at(count)] : in.row_count;
}

std::int32_t speaker(const StepContext& ctx, std::int32_t id) noexcept {
    const std::int32_t copy = id - interaction_count(ctx);
    if (copy < 0) return id;
    const std::int32_t of = ctx.model.cuts.of[at(copy)];
    return copy == 0 || ctx.model.cuts.of[at(copy - 1)] != of ? of : -1;
}

}  // namespace hawser::stepper
