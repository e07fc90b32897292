// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file state_hash.h
/// Hash of the bits of a state.

#include "context/context.h"

namespace hawser::stepper {

/// Compute the hash of the state: see WorldState::hash.
[[nodiscard]] std::uint64_t state_hash(const Model& model, const State& state) noexcept;

}  // namespace hawser::stepper
