// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file validate_robust.h
/// Cases of `hawser validate robust`: motions at steps that do not resolve all of them.

#include "validate_report.h"

#include <span>

namespace hawser::cli {

/// A case of `hawser validate`.
struct Case {
    const char* id;
    const char* name;
    const char* text;
    void (*run)(Report&);
};

/// Those that "robust" stands for.
[[nodiscard]] std::span<const Case> robust_cases();

// validate_robust_wires.cpp
void case_zigzag_wires(Report& report);
void case_long_wire(Report& report);
void case_wire_sway(Report& report);
void case_wires_come_taut(Report& report);
// validate_robust_damping.cpp
void case_damping_orders(Report& report);
// validate_robust_joints.cpp, validate_robust_loops.cpp
void case_repeated_joints(Report& report);
void case_overconstrained(Report& report);
void case_ships_on_chain(Report& report);
void case_long_motions(Report& report);
void case_governor(Report& report);

}  // namespace hawser::cli
