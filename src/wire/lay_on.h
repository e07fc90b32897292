// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lay_on.h
/// Division of an element by a guide (hawser/guide.h), for guides and bollards.

#include <hawser/guide.h>

#include <array>

namespace hawser::wire {

/// Nodes at the ends of an element.
struct EndNodes {
    double mass = 0.0;  ///< Total mass of both [kg].
    int count = 0;
};
[[nodiscard]] EndNodes end_nodes(const World& world, const InteractionDef& element);
/// Return the mass that the nodes at both ends kept when an element between them was divided by a
/// guide [kg].
/// @param mass  Mass of the element [kg].
[[nodiscard]] double mass_kept_by_nodes(const EndNodes& before, const EndNodes& after, double mass);

/// Create slide, parts and friction of a guide. If one of them is rejected, nothing is created,
/// except if memory is exhausted.
/// @param def  Receives the default values.
/// @param speed  Speed of the wire along itself [m/s].
/// @param material  Lengths of the parts [m].
/// @param drawn  True: compare the side of the wheel with the drawn wire. Otherwise, on an open
/// guide, the parts have the rest length of their mass at def.mass_per_length; on other guides, the
/// length that preserves the tension.
/// @throws DefError
[[nodiscard]] Guide add_guide_parts(World& world, GuideDef& def, double speed,
                                    std::array<double, 2>& material, bool drawn = false);
/// Add an input that sets a friction force of a guide in addition to that of its angle of wrap.
InputId add_stop(World& world, const GuideDef& def, const Guide& guide);

}  // namespace hawser::wire
