// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file load_impulses.h
/// Compute the impulses of system loads (hawser/system.h) on bodies in the last step. They come
/// from the public data of a World: the loads, velocities before and after, masses.

#include <hawser/hawser.h>

#include <vector>

namespace hawser::verify {

/// Impulse at the centre of mass [N s] and angular impulse [N m s], world frame; scalar: x().
struct LoadImpulse {
    BodyId body{};
    Vec3 linear{0, 0, 0}, angular{0, 0, 0};
    double resistance = 0.0;  ///< Impulse per velocity after the step: largest entry [kg, kg m²].
};

/// Return the impulses of the loads of systems in a step. @param pose, before  Poses and velocities
/// of all bodies at the start of the step.
[[nodiscard]] std::vector<LoadImpulse> load_impulses(const World& world,
                                                     const std::vector<Pose>& pose,
                                                     const std::vector<Twist>& before);

}  // namespace hawser::verify
