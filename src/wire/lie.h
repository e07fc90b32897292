// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lie.h
/// A wire of lumps of which a part lies on a level bottom.
///
/// Weights are 0 or more, so that the shape is convex and what lies is one piece. Where a node
/// lies, the bottom carries what its elements do not: the vertical pull of a lifted part falls from
/// its end by the weight of each node until it would be negative, V = max(0, V_end − Σ w), and is 0
/// in all that lies. So a lifted part follows from the horizontal pull H and the height of its end:
/// its height grows with V_end. Two lifted parts and what lies between them have to span the
/// distance of the ends, which grows with H: two nested roots, each of a function that grows.
///
/// An end may lie a little under the bottom, as that of a line on an anchor whose nodes lie the
/// line's radius higher: its element then rises to the bottom, pulled by H.
///
/// Along what lies friction takes μ w of each node from the tension, to no less than 0.

#include "wire/chain.h"

#include <optional>

namespace hawser::wire {

/// Between an end at height `first` over the bottom and one at height `last`, x apart; none where
/// the wire does not reach the bottom, or weighs less than nothing somewhere. Negative heights are
/// smaller than the element at that end.
/// @param friction  Coefficient.
[[nodiscard]] std::optional<Plane> lie_between(const Chain& chain, double x, double first,
                                               double last, double friction);
/// From an end at height `first`, the other one free; none as above.
[[nodiscard]] std::optional<Plane> lie_free(const Chain& chain, double first);

}  // namespace hawser::wire
