// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file pattern_parts.h
/// Parts and separators of a block pattern, for an order of elimination with a prescribed top.

#include "factor/pattern.h"
#include "factor/symbolic.h"

#include <cstdint>
#include <vector>

namespace hawser::assembly {

/// Return the part of each node of the pattern, or graph::kSeparator. No edge of the pattern joins
/// two parts. graph::Partitioner distributes the positive nodes. A negative node gets the part of
/// its positive neighbours; if all of them are separators, it is a separator as well. @param known
/// Analysis of this pattern, whose exact flops are then balanced; null: use the model. @throws
/// std::bad_alloc.
[[nodiscard]] std::vector<std::int32_t> pattern_parts(const factor::Pattern& pattern,
                                                      const factor::Symbolic* known, int parts);

}  // namespace hawser::assembly
