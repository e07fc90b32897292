// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file block_pattern.h
/// Public patterns as src/factor has them.

#include "factor/pattern.h"

#include <hawser/factor.h>

#include <cstdint>
#include <span>

namespace hawser::world {

/// @throws std::invalid_argument where the pattern is malformed.
[[nodiscard]] factor::Pattern graph_of(const BlockPattern& pattern);

/// @throws std::invalid_argument where it is not a permutation of the nodes.
void check_order(const BlockPattern& pattern, std::span<const std::int32_t> order);

}  // namespace hawser::world
