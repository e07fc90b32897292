// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file pattern_parts.h
/// Parts and separators of a block pattern: for an order of elimination with a forced top.

#include "factor/pattern.h"
#include "factor/symbolic.h"

#include <cstdint>
#include <vector>

namespace hawser::assembly {

/// By node of the pattern: its part, or graph::kSeparator. No edge of the pattern joins two parts.
/// Positive nodes are shared out by graph::Partitioner; a negative one goes with those of its
/// positive neighbours that are in a part, and between parts if none is.
/// @param known  Analysis of this pattern, whose exact flops then balance; null: by the model.
/// @throws std::bad_alloc.
[[nodiscard]] std::vector<std::int32_t> pattern_parts(const factor::Pattern& pattern,
                                                      const factor::Symbolic* known, int parts);

}  // namespace hawser::assembly
