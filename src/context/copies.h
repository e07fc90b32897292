// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file copies.h
/// Separate the bodies and interactions of the user from ghost bodies and copies. Splits append
/// ghost bodies and copies behind them (split/cuts.h); without splits there are none.

#include "context/context.h"

namespace hawser::context {

/// True if some interactions have copies, even if no cut is in force.
[[nodiscard]] bool has_cuts(const Model& model) noexcept;

/// Return the number of bodies or interactions without ghost bodies and copies.
[[nodiscard]] std::int32_t body_count(const Model& model) noexcept;

[[nodiscard]] std::int32_t interaction_count(const Model& model) noexcept;

/// Return the number of rows without those of copies. Rows of empty slots count.
[[nodiscard]] std::int32_t user_rows(const Model& model) noexcept;

/// Return the interaction that reports events of this one. It is the interaction itself; the
/// original for the first copy; −1 for other copies.
[[nodiscard]] std::int32_t reporting_interaction(const Model& model, std::int32_t id) noexcept;

/// Return the original of a copy, or the interaction itself if it is not a copy.
[[nodiscard]] std::int32_t original(const Model& model, std::int32_t id) noexcept;

/// Return the bodies of an interaction, by slot.
[[nodiscard]] inline std::span<const std::int32_t> bodies_of(const model::Interactions& in,
                                                             std::int32_t id) noexcept {
    return {&in.body[kMaxInteractionBodies * at(id)], in.bodies[at(id)]};
}

}  // namespace hawser::context
