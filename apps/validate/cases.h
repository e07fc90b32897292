// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cases.h
/// Validation cases. Each opens its scenes, runs them and writes to the report.

#include "validate/report.h"

namespace hawser::validate {

// Check pendulums against closed forms (pendulum.cpp).
void case_pendulum_period(Report& report);
void case_pendulum_a01(Report& report);
// Check mechanisms with closed loops against reference solutions (mechanisms.cpp).
void case_n_four_bar(Report& report);
void case_andrews(Report& report);
void case_bricard(Report& report);
void case_slider_crank(Report& report);
// Check the rotation of free and supported rigid bodies (spin.cpp).
void case_dzhanibekov(Report& report);
void case_heavy_top(Report& report);
// Check cables at rest and their vibration (cables.cpp).
void case_catenary(Report& report);
void case_hanging_chain(Report& report);
void case_taut_string(Report& report);
// Check the conservation of momentum (momentum.cpp).
void case_momentum(Report& report);
// Check the bending and buckling of wires (beams.cpp).
void case_beams(Report& report);
void case_euler_column(Report& report);
// Check the friction of a wire round a cylinder (contact.cpp).
void case_capstan(Report& report);
// Check routes, contacts and limits of joints (routes.cpp and files of the case's name).
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
// Check the rolling resistance of balls (resistance.cpp).
void case_rolling_resistance(Report& report);
// Check winches and drums (winches.cpp).
void case_winches(Report& report);
// Add the checks of winches_limits.cpp and winches_joined.cpp to case_winches().
void report_winch_limits(Report& report);
void report_joined_wires(Report& report);
// Check the statics of cranes (cranes.cpp).
void case_cranes(Report& report);
// Check properties of the integration scheme (scheme.cpp).
void case_static_violation(Report& report);
void case_violation_decay(Report& report);
void case_linear_invariant(Report& report);
void case_linear_stability(Report& report);
void case_curvature_violation(Report& report);
void case_order(Report& report);
void case_energy_loss(Report& report);

}  // namespace hawser::validate
