// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file vessels.h
/// Cases of `hawser validate vessels`: published ships at a step of 1/60 s against their equations
/// of motion integrated apart (Runge-Kutta, error below 1e-4).

#include "validate/robust.h"

#include <span>

namespace hawser::validate {

/// Return the cases that the name "vessels" selects; together at most a minute.
[[nodiscard]] std::span<const Case> vessel_cases();

// Cases in vessels_osv.cpp.
void case_vessel_osv(Report& report);
// Cases in vessels_trials.cpp.
void case_vessel_kvlcc2(Report& report);
void case_vessel_mariner(Report& report);
void case_vessel_s175(Report& report);
void case_vessel_esso(Report& report);
// Cases in vessels_propulsion.cpp.
void case_vessel_propulsion(Report& report);
// Cases in vessels_anchors.cpp.
void case_vessel_anchors(Report& report);
// Cases in vessels_stability.cpp.
void case_vessel_stability(Report& report);
// Cases in vessels_winches.cpp.
void case_vessel_winches(Report& report);

// Cases in vessels_capability.cpp.
void case_vessel_capability(Report& report);
// Cases in vessels_dp.cpp.
void case_vessel_dp(Report& report);

}  // namespace hawser::validate
