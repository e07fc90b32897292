// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file kinetic.h
/// Kinetic energy of bodies.

#include "assembly/view.h"
#include "model/bodies.h"

#include <cstdint>

namespace hawser::stepper {

/// ½ vᵀ M v [J], M without damping and geometric stiffness. @param velocity  Packed.
[[nodiscard]] double kinetic_energy(const model::Bodies& bodies, const double* velocity) noexcept;

/// Kinetic energy of one body that moves [J].
[[nodiscard]] double kinetic_energy_of(const model::Bodies& bodies, std::int32_t body,
                                       const double* velocity) noexcept;

/// By how much an element that moves as a straight piece has less than the lumps at its ends [J]:
/// ½ μ |v₁ − v₀|², see View::pair_mass. @param velocity  Packed.
[[nodiscard]] double pair_energy(const assembly::View& view, std::int32_t id,
                                 const double* velocity) noexcept;

}  // namespace hawser::stepper
