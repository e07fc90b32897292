// SPDX-License-Identifier: Apache-2.0
#include "context/copies.h"

namespace hawser::context {

bool has_cuts(const Model& model) noexcept { return !model.cuts.list.empty(); }

std::int32_t body_count(const Model& model) noexcept {
    return model.cuts.bodies >= 0 ? model.cuts.bodies : model.bodies.count();
}

std::int32_t interaction_count(const Model& model) noexcept {
    return model.cuts.interactions >= 0 ? model.cuts.interactions : model.interactions.count();
}

std::int32_t original(const Model& model, std::int32_t id) noexcept {
    const std::int32_t n = interaction_count(model);
    return id < n ? id : model.cuts.of[at(id - n)];
}

std::int32_t user_rows(const Model& model) noexcept {
    const model::Interactions& in = model.interactions;
    const std::int32_t count = interaction_count(model);
    return count < in.count() ? in.row_begin[at(count)] : in.row_count;
}

std::int32_t reporting_interaction(const Model& model, std::int32_t id) noexcept {
    const std::int32_t copy = id - interaction_count(model);
    if (copy < 0) return id;
    const std::int32_t of = model.cuts.of[at(copy)];
    return copy == 0 || model.cuts.of[at(copy - 1)] != of ? of : -1;
}

}  // namespace hawser::context
