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
/// Return the mass that nodes kept of their halves of an element that was laid over a guide between
/// two of them [kg].
/// @param mass  Mass of the element [kg].
[[nodiscard]] double mass_kept_by_nodes(const EndNodes& before, const EndNodes& after, double mass);

/// Create slide, parts and friction of a guide, all or nothing, except if memory is exhausted.
/// @param def  Receives the values that were left to defaults.
/// @param speed  Speed of the wire along itself [m/s].
/// @param material  Lengths of the parts [m].
/// @param drawn  True: compare the side of the wheel with the drawn wire. Otherwise, on an open
/// guide, the parts have the rest length of their mass at def.mass_per_length; on other guides, the
/// length that preserves the tension.
/// @throws DefError
[[nodiscard]] Guide add_guide_parts(World& world, GuideDef& def, double speed,
                                    std::array<double, 2>& material, bool drawn = false);
/// Add the input of its friction force in addition to that of the angle.
InputId add_stop(World& world, const GuideDef& def, const Guide& guide);

}  // namespace hawser::wire
