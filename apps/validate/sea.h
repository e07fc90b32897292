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

// Cases in sea_waves.cpp.
void case_sea_waves(Report& report);
void case_sea_statistics(Report& report);
// Cases in sea_hulls.cpp.
void case_sea_box(Report& report);
void case_sea_periods(Report& report);
void case_sea_froude_krylov(Report& report);
// Cases in sea_drag.cpp.
void case_sea_drag(Report& report);
// Cases in sea_stability.cpp.
void case_sea_stability(Report& report);
void case_sea_stability_hour(Report& report);
// Cases in sea_sphere.cpp.
void case_sea_sphere(Report& report);
// Cases in sea_rao.cpp.
void case_sea_rao(Report& report);

/// Return the cases that need external data; they run by name only.
[[nodiscard]] std::span<const Case> data_cases();

}  // namespace hawser::validate
