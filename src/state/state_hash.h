// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file state_hash.h
/// Hash of the bits of a state.

#include "context/context.h"

namespace hawser::state {

/// Compute the hash of the state: see WorldState::hash.
[[nodiscard]] std::uint64_t state_hash(const context::Model& model,
                                       const context::State& state) noexcept;

}  // namespace hawser::state
