// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file line_path.h
/// Find the points at which parts of lines leave their wheels, by iterating the ends around the
/// wheels until they are constant. This is independent of the solver's closed form.

#include "verify/attached.h"

namespace hawser::verify {

struct LineEnds {
    Vec3 at[2];  ///< Ends, world frame [m].
    Vec3 along;  ///< Unit vector from the first to the second.
};
/// Return the ends of an element of a wire, a rod, or a part of a line between turning points.
[[nodiscard]] LineEnds line_ends(const Attached& on);

/// Return the signed radius of the wheel at one end of an element or route part [m]; 0: no wheel.
[[nodiscard]] double wheel_at(const InteractionDef& def, int slot);

/// Return the angle by which a line turns between two consecutive parts, including whole turns
/// [rad]. @param defined  Angle at the definition of the parts. Later whole turns come from the
/// world.
[[nodiscard]] double turn_between(const World& world, InteractionId before, InteractionId behind,
                                  double defined, std::span<const Pose> pose);

}  // namespace hawser::verify
