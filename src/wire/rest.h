// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file rest.h
/// Static balance of a wire of nodes with bending stiffness, partly in still water, on a seabed.
///
/// The nodes minimise the potential energy in the vertical plane of the ends:
/// ```
///     E = Σ (l' − l)²/2c + Σ (EI/l̄)(1 − cos φ) + Σ w z − Σ b ∫ wet dz − Σ f x,   z ≥ bottom
/// ```
/// The sums run over elements longer than l, nodes that bend by φ, weights, buoyancy b of half
/// elements and friction f of nodes on the bottom. The wet fraction of a half element falls from 1
/// to 0 while it leaves the water (sea.h). The slopes of half elements and f follow in outer
/// iterations. Newton's method with projection on the seabed finds the minimum (D. P. Bertsekas,
/// "Projected Newton methods for optimization problems with simple constraints", 1982). Its band
/// matrix has eleven diagonals and is shifted where it is indefinite.

#include "wire/chain.h"

#include <optional>

namespace hawser::wire {

/// Bounds of a wire in its plane, with heights from its first end.
struct Surroundings {
    bool free = false;             ///< True: the last node moves and has half an element.
    std::optional<double> water;   ///< Height of still water [m].
    std::optional<double> bottom;  ///< Height of the seabed for nodes [m].
    double friction = 0.0;         ///< Friction coefficient of the seabed [1].
};

/// Find the balance from a shape near it. The weights of the chain become those of the result.
/// @return none if Newton's method did not reach `tolerance` [N].
[[nodiscard]] std::optional<Plane> equilibrium_near(Chain& chain, const Plane& start,
                                                    const Surroundings& around, double tolerance);

}  // namespace hawser::wire
