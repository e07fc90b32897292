// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file firstday.h
/// Cases of `hawser validate firstday`: first scenes of a user, at steps of 1/60 and 1/240 s.

#include "validate/robust.h"

#include <span>

namespace hawser::validate {

/// Return the cases of the group "firstday"; they take at most two minutes together.
[[nodiscard]] std::span<const Case> firstday_cases();

// Cases in firstday_lines.cpp.
void case_first_chains(Report& report);
void case_first_lines(Report& report);
// Cases in firstday_hulls.cpp.
void case_first_waves(Report& report);
void case_first_drag(Report& report);
void case_first_memory(Report& report);
// Cases in firstday_checks.cpp.
void case_first_warnings(Report& report);
// Cases in firstday_winches.cpp.
void case_first_winches(Report& report);
void case_first_routes(Report& report);

}  // namespace hawser::validate
