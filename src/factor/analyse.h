// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file analyse.h
/// Build the structure of a factorisation from a pattern and an order of elimination, without an
/// earlier analysis. repair.h updates the structure when the pattern changes.

#include "factor/ordering.h"
#include "factor/pattern.h"
#include "factor/symbolic.h"

#include <cstdint>
#include <vector>

namespace hawser::factor {

/// Analyse a pattern for a given elimination order. The order is first replaced by a postorder of
/// its elimination tree.
[[nodiscard]] Symbolic analyse(const Pattern& pattern, Elimination plan);
/// Analyse a pattern for an elimination order without chains.
[[nodiscard]] Symbolic analyse(const Pattern& pattern, std::vector<std::int32_t> order);

}  // namespace hawser::factor
