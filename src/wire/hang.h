// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hang.h
/// A wire of lumps that hangs between two points, or from one.
///
/// At rest the horizontal pull H is the same in all elements, and the vertical one grows by the
/// weight of each node, V_i = V_0 + Σ w. An element whose pull is (H, V), T = √(H² + V²), lies
/// along it with the length l + cT. So the whole shape follows from H and V_0, and the place of the
/// last end is the gradient of
///     Φ(H, V_0) = Σ (l T_i + c T_i²/2) + terms linear in them,
/// which is strictly convex for c > 0: for every place of the last end there is one and only one
/// (H, V_0). Φ has kinks where an element does not pull: it is then slack, of any chord up to l.

#include "wire/chain.h"

namespace hawser::wire {

/// Between the origin and (x, z), x ≥ 0.
[[nodiscard]] Plane hang_between(const Chain& chain, double x, double z);
/// From the origin straight down (up where it floats); its last node carries half an element.
[[nodiscard]] Plane hang_down(const Chain& chain);

}  // namespace hawser::wire
