// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file copies.h
/// Bodies and interactions of the user among all. Splits put images and copies behind them
/// (split/cuts.h); without splits they are all there are.

#include "context/context.h"

namespace hawser::stepper {

/// Whether interactions are cut, be it in force or not.
[[nodiscard]] bool has_cuts(const Model& model) noexcept;

/// Bodies and interactions without images and copies.
[[nodiscard]] std::int32_t body_count(const Model& model) noexcept;

[[nodiscard]] std::int32_t interaction_count(const Model& model) noexcept;

/// Rows without those of copies; those of empty places count.
[[nodiscard]] std::int32_t user_rows(const Model& model) noexcept;

/// The interaction that reports events of this one: itself; of the first copy its original, of the
/// others none (−1).
[[nodiscard]] std::int32_t speaker(const Model& model, std::int32_t id) noexcept;

/// The interaction that a copy stands for; else itself.
[[nodiscard]] std::int32_t original(const Model& model, std::int32_t id) noexcept;

/// Bodies of an interaction, by slot.
[[nodiscard]] inline std::span<const std::int32_t> bodies_of(const model::Interactions& in,
                                                             std::int32_t id) noexcept {
    return {&in.body[kMaxInteractionBodies * at(id)], in.bodies[at(id)]};
}

}  // namespace hawser::stepper
