// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file load_impulses.h
/// What loads of systems (hawser/system.h) did to bodies in the last step, computed anew from what
/// a World shows: the loads, velocities before and after, masses.

#include <hawser/hawser.h>

#include <vector>

namespace hawser::verify {

/// Impulse at the centre of mass [N s] and angular impulse [N m s], world frame; scalar: x().
struct LoadImpulse {
    BodyId body{};
    Vec3 linear{0, 0, 0}, angular{0, 0, 0};
};

/// @param pose, before  Of all bodies, where the step began.
[[nodiscard]] std::vector<LoadImpulse> load_impulses(const World& world,
                                                     const std::vector<Pose>& pose,
                                                     const std::vector<Twist>& before);

}  // namespace hawser::verify
