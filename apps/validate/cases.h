// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cases.h
/// Validation cases. Each opens its scenes, runs them and writes to the report.

#include "validate/report.h"

namespace hawser::validate {

// Cases in pendulum.cpp.
void case_pendulum_period(Report& report);
void case_pendulum_a01(Report& report);
// Cases in mechanisms.cpp.
void case_n_four_bar(Report& report);
void case_andrews(Report& report);
void case_bricard(Report& report);
void case_slider_crank(Report& report);
// Cases in spin.cpp.
void case_dzhanibekov(Report& report);
void case_heavy_top(Report& report);
// Cases in cables.cpp.
void case_catenary(Report& report);
void case_hanging_chain(Report& report);
void case_taut_string(Report& report);
// Cases in momentum.cpp.
void case_momentum(Report& report);
// Cases in beams.cpp.
void case_beams(Report& report);
void case_euler_column(Report& report);
// Cases in contact.cpp.
void case_capstan(Report& report);
// Cases in routes.cpp.
void check_posts(Report& report);  ///< Part of "capstan".
void case_tackle(Report& report);
void case_incline(Report& report);
void case_belt(Report& report);
void case_rolling_sphere(Report& report);
void case_bouncing_ball(Report& report);
void case_spinning_disk(Report& report);
void case_painleve(Report& report);
void case_stacks(Report& report);
void case_walls(Report& report);
void case_joint_friction(Report& report);
void case_bollard(Report& report);
void case_joint_limits(Report& report);
void case_motor_limits(Report& report);
// Cases in resistance.cpp.
void case_rolling_resistance(Report& report);
// Cases in winches.cpp.
void case_winches(Report& report);
// Parts of case_winches(), in winches_limits.cpp and winches_joined.cpp.
void report_winch_limits(Report& report);
void report_joined_wires(Report& report);
// Cases in cranes.cpp.
void case_cranes(Report& report);
// Cases in scheme.cpp.
void case_static_violation(Report& report);
void case_violation_decay(Report& report);
void case_linear_invariant(Report& report);
void case_linear_stability(Report& report);
void case_curvature_violation(Report& report);
void case_order(Report& report);
void case_energy_loss(Report& report);

}  // namespace hawser::validate
