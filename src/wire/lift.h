// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lift.h
/// What a wire is again where it leaves a guide.

#include <hawser/interactions.h>

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

}  // namespace hawser::wire
