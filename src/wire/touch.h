// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file touch.h
/// A taut wire with its first end slightly under a level bottom and only its first node on it. The
/// first element pulls that node down, so the rest may lift more than the total weight.

#include "wire/chain.h"

#include <optional>

namespace hawser::wire {

/// Find the shape of a chain of which only one node touches the bottom, without friction. One end
/// is `sunk` below the bottom, the other end at the distance x and the height `last` above the
/// bottom.
/// @return none if the node would lift or other nodes would lie.
[[nodiscard]] std::optional<Plane> touch_once(const Chain& chain, double x, double sunk,
                                              double last);
/// Return the shape with its nodes in reversed order.
[[nodiscard]] Plane reversed(const Plane& shape);

}  // namespace hawser::wire
