// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wet.h
/// Half elements that cut the surface of still water, and bending forces.

#include "wire/chain.h"

namespace hawser::wire {

/// Slope of a half element.
struct HalfForm {
    double lift = 0.0;    ///< Buoyancy when fully wet [N].
    double below = 0.0;   ///< Depth of its lowest point below the node [m].
    double spread = 1.0;  ///< Height between its lowest and highest point [m].
};
/// Return the vertical extent and the buoyancy of a half element.
/// @param z  Height of its node [m].
/// @param middle  Height of the middle of the element [m].
[[nodiscard]] HalfForm half_element_form(double z, double middle, double diameter);
/// Return the submerged fraction of a half element of vertical extent `spread`, if the surface is
/// `depth` above its lowest point.
[[nodiscard]] double wet_fraction(double depth, double spread);

/// Compute the wet fractions of half elements. For an element of diameter d from z to its middle
/// z_m this is the part of [min − d/2, max + d/2] below the water.
[[nodiscard]] WetHalves wet_halves(const Chain& chain, const Plane& shape, double water);

/// True if a node of the chain resists bending.
[[nodiscard]] bool resists_bending(const Chain& chain) noexcept;

/// Return the bending forces on the nodes [N].
[[nodiscard]] std::vector<Vec3> bending_forces(const Chain& chain, const std::vector<Vec3>& nodes);

}  // namespace hawser::wire
