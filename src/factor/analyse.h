// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file analyse.h
/// From a pattern and an order of elimination to the structure of its factorisation, from nothing;
/// repair.h follows a pattern that changes.

#include "factor/ordering.h"
#include "factor/pattern.h"
#include "factor/symbolic.h"

#include <cstdint>
#include <vector>

namespace hawser::factor {

/// Analyse a pattern for a given elimination order (made a postorder of its own tree).
[[nodiscard]] Symbolic analyse(const Pattern& pattern, Elimination plan);
/// Analyse a pattern for an elimination order without chains.
[[nodiscard]] Symbolic analyse(const Pattern& pattern, std::vector<std::int32_t> order);

}  // namespace hawser::factor
