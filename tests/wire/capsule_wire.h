// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file capsule_wire.h
/// Wire for tests of capsules that extend to the attachments: 76 mm, 23 kg/m.

#include <hawser/hawser.h>

#include <string>
#include <utility>

namespace hawser::test {

inline constexpr double kCapsuleMass = 23.0, kCapsuleEA = 2.33e8;  // [kg/m], [N]
inline constexpr double kCapsuleRadius = 0.038;                    // [m]

/// Return a wire without ends, of elements with their own mass.
inline WireDef capsule_wire(std::string name) {
    WireDef def{.name = std::move(name), .EA = kCapsuleEA, .mass_per_length = kCapsuleMass};
    def.radius = kCapsuleRadius;
    def.consistent_mass = true;
    def.end_capsules = true;
    return def;
}

}  // namespace hawser::test
