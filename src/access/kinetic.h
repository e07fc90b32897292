// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file kinetic.h
/// Kinetic energy of bodies.

#include "model/bodies.h"

#include <cstdint>

namespace hawser::stepper {

/// ½ vᵀ M v [J], M without damping and geometric stiffness. @param velocity  Packed.
[[nodiscard]] double kinetic_energy(const model::Bodies& bodies, const double* velocity) noexcept;

/// Kinetic energy of one body that moves [J].
[[nodiscard]] double kinetic_energy_of(const model::Bodies& bodies, std::int32_t body,
                                       const double* velocity) noexcept;

}  // namespace hawser::stepper
