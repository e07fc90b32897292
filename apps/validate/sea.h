// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sea.h
/// Cases of `hawser validate sea`: water against closed forms.

#include "validate/robust.h"

#include <span>

namespace hawser::validate {

/// Return the cases of the group "sea".
[[nodiscard]] std::span<const Case> sea_cases();
[[nodiscard]] std::span<const Case> long_sea_cases();  ///< Not part of the group "sea".

// Check the kinematics and statistics of waves (sea_waves.cpp).
void case_sea_waves(Report& report);
void case_sea_statistics(Report& report);
// Check the hydrostatics and wave loads of hulls (sea_hulls.cpp).
void case_sea_box(Report& report);
void case_sea_periods(Report& report);
void case_sea_froude_krylov(Report& report);
// Check drag on rods and bodies (sea_drag.cpp).
void case_sea_drag(Report& report);
// Check the stability of sea loads at coarse steps (sea_stability.cpp).
void case_sea_stability(Report& report);
void case_sea_stability_hour(Report& report);
// Check the decay of a floating sphere (sea_sphere.cpp).
void case_sea_sphere(Report& report);
// Compare a semi-submersible with results of WAMIT (sea_rao.cpp).
void case_sea_rao(Report& report);

/// Return the cases that need external data; they run by name only.
[[nodiscard]] std::span<const Case> data_cases();

}  // namespace hawser::validate
