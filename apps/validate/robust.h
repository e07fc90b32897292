// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file robust.h
/// Cases of `hawser validate robust`: motions at steps that do not resolve all of them.

#include "validate/report.h"

#include <span>

namespace hawser::validate {

/// A case of `hawser validate`.
struct Case {
    const char* id;
    const char* name;
    const char* text;
    void (*run)(Report&);
};

/// Return the cases of the group "robust".
[[nodiscard]] std::span<const Case> robust_cases();

// Check wires with under-resolved vibration (robust_wires.cpp).
void case_zigzag_wires(Report& report);
void case_long_wire(Report& report);
void case_wire_sway(Report& report);
void case_wires_come_taut(Report& report);
// Check the order of dampers in the step (robust_damping.cpp).
void case_damping_orders(Report& report);
// Check redundant joints and loops (robust_joints.cpp, robust_loops.cpp).
void case_repeated_joints(Report& report);
void case_overconstrained(Report& report);
void case_ships_on_chain(Report& report);
void case_long_motions(Report& report);
void case_governor(Report& report);

}  // namespace hawser::validate
