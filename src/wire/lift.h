// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lift.h
/// The element of a wire that leaves a guide, and the test whether it runs off the guide.
///
/// ```
///     b ──── f ──── n ── part ──( )── part ──        n the node next to the guide
/// ```
/// The node before a free end b can transfer its mass only to b (edit/node_drum.cpp). It therefore
/// does not run through the guide. When less than an element of wire remains, the end b runs off
/// the guide with everything attached to it.

#include <hawser/interactions.h>

#include <cstddef>

namespace hawser {
class World;
}

namespace hawser::wire {

class GuideSystem;

/// Return the element that replaces both parts at a guide, with their material.
/// @param keeps_length  True: its rest length is the sum of theirs. False: it keeps the tension
///        along the straight line between the ends.
[[nodiscard]] InteractionDef lifted_element(const World& world, const GuideSystem& guide,
                                            bool keeps_length);
/// Return the current rest length of a part at a drum or guide, or of another element of a wire
/// [m].
[[nodiscard]] double rest_length(const World& world, InteractionId id);

/// Return true if the wire can run off the guide at the node of a part: the wire ends there, or has
/// one more element to a free node. The last node must be unattached and at most as heavy as an
/// element, because an anchor stops at a guide.
/// @param part  Part of a wire at a guide.
/// @param side  0: the guide is at its last end, 1: at its first.
/// @param mass_per_length  Mass per length of the wire [kg/m].
/// @param element_length  Length of its elements [m].
[[nodiscard]] bool ends_free(const World& world, InteractionId part, std::size_t side,
                             double mass_per_length, double element_length) noexcept;

}  // namespace hawser::wire
