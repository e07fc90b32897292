// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wires.h
/// Cases of `hawser validate wires`: wires against closed forms.

#include "validate/robust.h"

#include <span>

namespace hawser::validate {

/// Return the cases of the group "wires".
[[nodiscard]] std::span<const Case> wire_cases();

// Cases in wires_catenary.cpp.
void case_wire_catenary(Report& report);
void case_wire_touchdown(Report& report);
// Cases in payout.cpp.
void case_payout(Report& report);
// Cases in payout_roller.cpp.
void check_roller(Report& report);  ///< Part of "payout".
// Cases in tow_payout.cpp.
void case_tow_payout(Report& report);
// Cases in wires_events.cpp.
void case_wire_events(Report& report);
// Cases in wires_crossing.cpp.
void case_wire_cross_parting(Report& report);
// Cases in wires_waves.cpp.
void case_wire_parting(Report& report);
void case_wire_pulse(Report& report);
// Cases in wires_resolution.cpp.
void case_wire_resolution(Report& report);

}  // namespace hawser::validate
