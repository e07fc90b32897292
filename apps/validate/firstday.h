// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file firstday.h
/// Cases of `hawser validate firstday`: first scenes of a user, at steps of 1/60 and 1/240 s.

#include "validate/robust.h"

#include <span>

namespace hawser::validate {

/// Return the cases of the group "firstday"; they take at most two minutes together.
[[nodiscard]] std::span<const Case> firstday_cases();

// Check chains and lines at their start (firstday_lines.cpp).
void case_first_chains(Report& report);
void case_first_lines(Report& report);
// Check hulls in waves and current (firstday_hulls.cpp).
void case_first_waves(Report& report);
void case_first_drag(Report& report);
void case_first_memory(Report& report);
// Check the warnings of `hawser check` (firstday_checks.cpp).
void case_first_warnings(Report& report);
// Check winches, routes and guides (firstday_winches.cpp).
void case_first_winches(Report& report);
void case_first_routes(Report& report);

}  // namespace hawser::validate
