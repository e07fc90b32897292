// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hang.h
/// A wire of nodes that hangs between two points, or from one.
///
/// At rest the horizontal pull H is equal in all elements. The vertical pull increases by the
/// weight of each node, V_i = V_0 + Σ w. An element with the pull (H, V), T = √(H² + V²), has its
/// direction and the length l + cT. The whole shape therefore follows from H and V_0, and the
/// position of the last end is the gradient of
///     Φ(H, V_0) = Σ (l T_i + c T_i²/2) + terms linear in them.
/// This function is strictly convex for c > 0, so each position of the last end has exactly one (H,
/// V_0). The function has kinks at which an element has no tension. The element is then slack, with
/// any chord up to l.

#include "wire/chain.h"

namespace hawser::wire {

/// Return the shape of a chain that hangs between the origin and (x, z), x ≥ 0.
[[nodiscard]] Plane hang_between(const Chain& chain, double x, double z);
/// Return the shape of a chain that hangs straight down from the origin, or up if it floats. Its
/// last node carries half an element.
[[nodiscard]] Plane hang_down(const Chain& chain);

}  // namespace hawser::wire
