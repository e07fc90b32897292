// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file stern.h
/// Propeller and rudder of coefficient sets (hawser/vessel_hull.h). All forms are finite at rest:
/// with the velocity u_P of the propeller's inflow, 8 K_T/(π J²) u_P² = 8 T/(π ρ D²).

#include <hawser/vessel_hull.h>

#include "vessel/flow.h"

namespace hawser::vessel {

[[nodiscard]] Wrench stern_force(const MmgStern& def, const Flow& flow) noexcept;
[[nodiscard]] Wrench stern_force(const SonNomotoStern& def, const Flow& flow) noexcept;

}  // namespace hawser::vessel
