// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file vessels.h
/// Cases of `hawser validate vessels`: published ships at a step of 1/60 s against their equations
/// of motion integrated separately (Runge-Kutta, error below 1e-4).

#include "validate/robust.h"

#include <span>

namespace hawser::validate {

/// Return the cases that the name "vessels" selects; together at most a minute.
[[nodiscard]] std::span<const Case> vessel_cases();

// Check the supply vessel (vessels_osv.cpp).
void case_vessel_osv(Report& report);
// Compare turning circles and zig-zags with the published equations (vessels_trials.cpp).
void case_vessel_kvlcc2(Report& report);
void case_vessel_mariner(Report& report);
void case_vessel_s175(Report& report);
void case_vessel_esso(Report& report);
// Check propellers, thrusters and shafts (vessels_propulsion.cpp).
void case_vessel_propulsion(Report& report);
// Check drag anchors (vessels_anchors.cpp).
void case_vessel_anchors(Report& report);
// Check the stability gauge (vessels_stability.cpp).
void case_vessel_stability(Report& report);
// Check overload protection and heave compensation of winches (vessels_winches.cpp).
void case_vessel_winches(Report& report);

// Compare DP capability numbers with the published solution (vessels_capability.cpp).
void case_vessel_capability(Report& report);
// Compare DP control with its reference (vessels_dp.cpp).
void case_vessel_dp(Report& report);

}  // namespace hawser::validate
