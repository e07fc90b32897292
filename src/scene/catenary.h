// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file catenary.h
/// Initial shape of a hanging cable: a chain of equal rigid elements at rest.
///
/// Cut a chain into n equal straight elements of length l, its weight lumped at the nodes
/// between them. At rest the horizontal pull H is the same in every element and the vertical
/// pull grows by the weight w of a node from one to the next, so the slope of element i is
/// t_i = t_0 + i k with k = w/H. Two unknowns (t_0, k) meet two end points:
/// l Σ 1/√(1+t_i²) = horizontal distance, l Σ t_i/√(1+t_i²) = height difference.
/// For n → ∞ this is the catenary of parameter a = l/k, which gives the starting point of
/// Newton's method. Unlike points on the smooth curve, the elements keep their length.

#include <hawser/math.h>

#include <optional>
#include <vector>

namespace hawser::scene {

/// The n + 1 nodes from `a` to `b`, hanging along `down`.
/// @return nothing when there is no such shape: length below the distance, or the end points
///         nearly on one vertical.
[[nodiscard]] std::optional<std::vector<Vec3>> hang(const Vec3& a, const Vec3& b, double length,
                                                    int n, const Vec3& down);

}  // namespace hawser::scene
