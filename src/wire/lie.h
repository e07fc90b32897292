// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lie.h
/// A wire of nodes that partly lies on a level bottom.
///
/// Weights are ≥ 0, so the shape is convex and the part on the bottom is contiguous. The bottom
/// carries the remaining vertical pull at each node on it. The vertical pull of a lifted part
/// decreases from its end by the weight of each node, V = max(0, V_end − Σ w), and is 0 on the
/// bottom. So a lifted part follows from the horizontal pull H and the height of its end, which
/// grows with V_end. Two lifted parts and the part between them must span the distance of the ends,
/// which grows with H. This gives two nested roots of growing functions.
///
/// An end may lie slightly under the bottom, such as the end of a line on an anchor whose nodes lie
/// higher by the line's radius. Its element then rises to the bottom, pulled by H.
///
/// On the bottom, friction reduces the tension by μ w of each node, down to 0.

#include "wire/chain.h"

#include <optional>

namespace hawser::wire {

/// Find the shape between ends at heights `first` and `last` above the bottom, x apart. Negative
/// heights are smaller than the element at that end.
/// @param friction  Coefficient.
/// @return none if the wire does not reach the bottom or a weight is negative.
[[nodiscard]] std::optional<Plane> rest_between(const Chain& chain, double x, double first,
                                                double last, double friction);
/// Find the shape from an end at height `first` with the other end free; none as above.
[[nodiscard]] std::optional<Plane> rest_with_free_end(const Chain& chain, double first);

}  // namespace hawser::wire
