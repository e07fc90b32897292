// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lift.h
/// What a wire is again where it leaves a guide, and whether it runs off one.
///
/// ```
///     b ──── f ──── n ── part ──( )── part ──        n the lump next to the guide
/// ```
/// The lump before a free end b has nobody to give its mass to but b (edit/node_drum.cpp): it does
/// not run through, and less than an element of wire is left of it. It runs off with what hangs on
/// it.

#include <hawser/interactions.h>

#include <cstddef>

namespace hawser {
class World;
}

namespace hawser::wire {

class GuideSystem;

/// The element that both parts at a guide become, of the material that they have: at the rest
/// length that keeps the tension along the straight way between their ends, or, where the wire
/// keeps its rest length, at the sum of theirs.
[[nodiscard]] InteractionDef lifted_element(const World& world, const GuideSystem& guide,
                                            bool keeps_length);
/// Of a part at a drum or guide, or any other element of a wire, now [m].
[[nodiscard]] double rest_length(const World& world, InteractionId id);

/// @param part  Of a wire at a guide. @param side  0: the guide is at its last end, 1: at its
/// first.
/// @param mass_per_length  Of the wire [kg/m]. @param element_length  Of its elements [m].
/// @return whether nothing is beyond its lump, or one element to a free lump, which nothing holds
/// and which is no heavier than an element: an anchor stops at a guide.
[[nodiscard]] bool ends_free(const World& world, InteractionId part, std::size_t side,
                             double mass_per_length, double element_length) noexcept;

}  // namespace hawser::wire
