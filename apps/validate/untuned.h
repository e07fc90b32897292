// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file untuned.h
/// Cases of `hawser validate untuned`: mechanisms and wires at steps of 1/60 and 1/240 s, over
/// ranges of their parameters.

#include "validate/robust.h"

#include <span>

namespace hawser::validate {

/// Return the cases of the group "untuned"; they take at most three minutes together.
[[nodiscard]] std::span<const Case> untuned_cases();

// Cases in untuned_joints.cpp.
void case_compliant_joints(Report& report);

// Cases in untuned_stops.cpp.
void case_stops(Report& report);
void case_restitution(Report& report);
void case_frictionless(Report& report);

// Case in untuned_rotation.cpp.
void case_rotation(Report& report);

}  // namespace hawser::validate
