// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file body_fields.h
/// Table of the members of BodyDef, except its name and kind.
///
/// To add a key of bodies, add a member of BodyDef with its default, and a row at the end of the
/// table. Scenes, the JSON Schema, the reference page, checks, recordings and copies need no
/// further code. The code that uses the member reads World::body_def(), or stores it in
/// model/bodies.h.

#include <hawser/def.h>
#include <hawser/fields.h>

#include <array>
#include <cstddef>

namespace hawser {

/// Return the bit of a kind of bodies, for FieldInfo::without.
[[nodiscard]] constexpr unsigned bit_of(BodyKind kind) noexcept {
    return 1U << static_cast<unsigned>(kind);
}
/// Kinds without orientation, and kinds on which forces have no effect.
inline constexpr unsigned kWithoutTurning = bit_of(BodyKind::lump) | bit_of(BodyKind::scalar);
inline constexpr unsigned kWithoutForces = bit_of(BodyKind::fixed) | bit_of(BodyKind::kinematic);

// Beyond these limits, products of entries overflow or lose all digits.
inline constexpr double kMaxBodyLength = 1e7;    ///< Largest coordinate or size [m].
inline constexpr double kMaxBodySpeed = 1e5;     ///< Largest speed [m/s, rad/s].
inline constexpr double kMaxBodyMass = 1e15;     ///< Largest mass [kg].
inline constexpr double kMaxBodyDamping = 1e18;  ///< Largest drag coefficient [N s/m, N m s].

/// Table of the members, in the order of recordings. Recordings store members from
/// kFirstNamedBodyField on by name, and only if they differ from the default, so that older
/// recordings remain readable.
inline constexpr auto kBodyFields = std::to_array<FieldInfo<BodyDef>>(
    {{"position", &BodyDef::position, "m", "[0, 0, 0]",
      "Centre of mass; of a scalar body the coordinate is x (m or rad).", -kMaxBodyLength,
      kMaxBodyLength, "a position", kOwnReader},
     {"orientation", &BodyDef::orientation, "1", "[1, 0, 0, 0]",
      "Quaternion [w, x, y, z] from the body's frame to the world.", -1e6, 1e6,
      "an orientation [w, x, y, z]", kOwnReader, kWithoutTurning},
     {"velocity", &BodyDef::velocity, "m/s", "[0, 0, 0]",
      "Velocity of the centre of mass at time 0; the x component for a scalar body.",
      -kMaxBodySpeed, kMaxBodySpeed, "a velocity", kOwnReader, bit_of(BodyKind::fixed)},
     {"angular_velocity", &BodyDef::angular_velocity, "rad/s", "[0, 0, 0]",
      "Angular velocity at time 0, in the world frame.", -kMaxBodySpeed, kMaxBodySpeed,
      "an angular velocity", kOwnReader, kWithoutTurning | bit_of(BodyKind::fixed)},
     {"mass", &BodyDef::mass, "kg", "",
      "Needed by rigid, lump and scalar bodies; of a drum kg or kg m^2.", 0.0, kMaxBodyMass,
      "a mass", kMayBeMissing | kAboveLeast},
     {"inertia", &BodyDef::inertia, "kg m^2", "",
      "About the centre of mass in the body's frame, symmetric and positive definite. A rigid body "
      "needs this or box, cylinder or sphere.",
      -1e30, 1e30, "an inertia", kMayBeMissing | kOwnReader, kWithoutTurning},
     {"force", &BodyDef::force, "N", "[0, 0, 0]", "Constant force, world frame.", -1e300, 1e300,
      "a force", kOwnReader, kWithoutForces},
     {"torque", &BodyDef::torque, "N m", "[0, 0, 0]", "Constant torque, world frame.", -1e300,
      1e300, "a torque", kOwnReader, kWithoutTurning | kWithoutForces},
     {"linear_damping", &BodyDef::linear_damping, "N s/m", "0",
      "Drag along the axes of the body; one number for all three.", 0.0, kMaxBodyDamping,
      "a damping coefficient", kPerAxis},
     {"angular_damping", &BodyDef::angular_damping, "N m s", "0",
      "Drag about the axes of the body; one number for all three.", 0.0, kMaxBodyDamping,
      "a damping coefficient", kPerAxis, kWithoutTurning},
     {"gravity", &BodyDef::gravity, "", "true (scalar: false)",
      "False: weightless, such as a ship afloat."},
     {"half_size", &BodyDef::half_size, "m", "of the box", "Box drawn in pictures.",
      -kMaxBodyLength, kMaxBodyLength, "a length", kOwnReader},
     {"group", &BodyDef::group, "", "\"\"",
      "Group that it belongs to: settings.coupling says how groups couple.", 0.0, 0.0, "a group",
      kOwnReader}});
/// Index of the first row that recordings store by name.
inline constexpr std::size_t kFirstNamedBodyField = 13;

}  // namespace hawser
