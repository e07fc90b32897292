// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file touch.h
/// A taut wire whose first end lies a little under a level bottom and that touches it at its first
/// node alone: its element pulls that node down, so that the rest may lift more than all weight.

#include "wire/chain.h"

#include <optional>

namespace hawser::wire {

/// Between an end `sunk` under the bottom and one x away at height `last` over it, without
/// friction; none where the node would lift or others would lie as well.
[[nodiscard]] std::optional<Plane> touch_once(const Chain& chain, double x, double sunk,
                                              double last);
/// A shape seen from the other end.
[[nodiscard]] Plane reversed(const Plane& shape);

}  // namespace hawser::wire
