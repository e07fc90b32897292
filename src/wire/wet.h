// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wet.h
/// Half elements that cut the surface of still water, and forces of bending.

#include "wire/chain.h"

namespace hawser::wire {

/// Slope of a half element.
struct HalfForm {
    double lift = 0.0;    ///< Buoyancy, wholly wet [N].
    double below = 0.0;   ///< From the node down to its lowest point [m].
    double spread = 1.0;  ///< From its lowest to its highest point [m].
};
/// Of a half element of diameter d from a node at z to its middle.
[[nodiscard]] HalfForm form_of(double z, double middle, double diameter);
/// Share that is wet where the surface is `depth` above the lowest point.
[[nodiscard]] double wet_share_of(double depth, double spread);

/// Compute the wet shares of half elements: of an element from z to its middle z_m of diameter d
/// the share of [min − d/2, max + d/2] below the water.
[[nodiscard]] WetHalves wet_halves(const Chain& chain, const Plane& shape, double water);

/// True if some node resists bending.
[[nodiscard]] bool bends(const Chain& chain) noexcept;

/// Forces of bending on the nodes [N].
[[nodiscard]] std::vector<Vec3> bending_forces(const Chain& chain, const std::vector<Vec3>& nodes);

}  // namespace hawser::wire
