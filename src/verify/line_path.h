// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file line_path.h
/// Where parts of lines leave what they run over, found by letting their ends go round wheels until
/// they stay; nothing of the solver's closed form.

#include "verify/attached.h"

namespace hawser::verify {

struct LineEnds {
    Vec3 at[2];  ///< World frame [m].
    Vec3 along;  ///< Unit vector from the first to the second.
};
/// Of an element of a wire, a rod, or a part of a line between places.
[[nodiscard]] LineEnds line_ends(const Attached& on);

/// Angle by which a line turns between two parts that follow each other, whole turns included
/// [rad]. @param defined  What it was when the parts were defined; whole turns that it has made
/// since are taken from the world.
[[nodiscard]] double turn_between(const World& world, InteractionId before, InteractionId behind,
                                  double defined, std::span<const Pose> pose);

}  // namespace hawser::verify
