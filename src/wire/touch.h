// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file touch.h
/// A taut wire whose first end lies slightly below a level bottom, and of which only the first node
/// touches the bottom. The first element pulls this node down, so the pull at the other end may
/// exceed the weight of the wire.

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
