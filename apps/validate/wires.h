// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wires.h
/// Cases of `hawser validate wires`: wires against closed forms.

#include "validate/robust.h"

#include <span>

namespace hawser::validate {

/// Return the cases of the group "wires".
[[nodiscard]] std::span<const Case> wire_cases();

// Compare wires at rest with the catenary (wires_catenary.cpp).
void case_wire_catenary(Report& report);
void case_wire_touchdown(Report& report);
// Check nodes that a winch inserts and removes (payout.cpp).
void case_payout(Report& report);
// Check a wire over a roller while it is paid out (payout_roller.cpp).
void check_roller(Report& report);  ///< Part of "payout".
// Check a tow wire that is paid out (tow_payout.cpp).
void case_tow_payout(Report& report);
// Check the conservation laws of cuts and node edits (wires_events.cpp).
void case_wire_events(Report& report);
// Check that wires do not pass through each other (wires_crossing.cpp).
void case_wire_cross_parting(Report& report);
// Check the recoil of a broken wire and the speed of a pulse (wires_waves.cpp).
void case_wire_parting(Report& report);
void case_wire_pulse(Report& report);
// Check the adaptation of element lengths (wires_resolution.cpp).
void case_wire_resolution(Report& report);

}  // namespace hawser::validate
