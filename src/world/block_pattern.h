// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file block_pattern.h
/// Conversion of public patterns to those of src/factor.

#include "factor/pattern.h"

#include <hawser/factor.h>

#include <cstdint>
#include <span>

namespace hawser::world {

/// Convert a pattern.
/// @throws std::invalid_argument if it is malformed.
[[nodiscard]] factor::Pattern factor_pattern_of(const BlockPattern& pattern);

/// Check an elimination order.
/// @throws std::invalid_argument if it is not a permutation of the nodes.
void check_order(const BlockPattern& pattern, std::span<const std::int32_t> order);

}  // namespace hawser::world
