// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file bounds.h
/// Rows with a bounded force: lines that only pull, ranges, motors, friction in joints.
///
/// The first row of such an interaction, with r = c − G v − Σλ, obeys λ = P(λ + r/(W + Σ)) for any
/// W > 0. P is the projection onto its allowed impulses [low, high]:
/// ```
///     low = −∞   high = 0     a line: λ < 0 is tension
///     0 or −∞    0 or ∞       a range, by the end that its joint is beyond
///     h F_min    h F_max      a motor
///    −B          B            friction, B = h F + Σ factor ‖λ of what loads it‖
/// ```
/// Inside its bounds a row is active: r = 0 is one of the equations. At a bound it is *inactive*:
/// its equation is omitted, and λ is fixed at `held`. As for contacts, the sign of λ + r/(W + Σ)
/// decides between the two, with W its part of G M⁻¹ Gᵀ. Each iteration of Newton's method solves
/// with the statuses of the last one, then changes the statuses that the solution contradicts. A
/// changed status changes the matrix. A bound that moves with a load changes only the right-hand
/// side. An inactive row may move to the other end of its range, such as a reversed motor.
///
/// *Power.* A motor with a power limit P obeys λ w₊ ≤ h P. Here w₊ is the speed of its row after
/// the step. This bound follows the solution as the bounds of friction do (impulse_range.cpp).
///
/// *Loads.* The bound of friction follows its load one iteration late. If friction itself causes a
/// fraction s of its load, convergence takes log(1e-6)/log(s) iterations, each at the cost of a
/// substitution. Example: a line round a bollard has s = tanh(μδ/2); three turns at μ = 0.3 need
/// 2,000 iterations. While no status changes, λ is affine in the bounds. Anderson's acceleration
/// then ends after one iteration more than the number of coupled bounds (nonsmooth/anderson.h).

#include "context/context.h"
#include "solve/impulse_range.h"

namespace hawser::solve {

/// Reserve memory for the bounded rows of the model.
/// @throws std::bad_alloc.
void reserve_bounds(const context::Model& model, context::Newton& newton);

/// Set the impulses of inactive rows from bounds that may have moved, before rows are assembled.
/// @param time  Time for which bounds of forces act [s]: the step, or 0 in an impact.
void hold_bounds(context::Model& model, context::Newton& newton, double time) noexcept;

/// Read λ and the residual r of all bounded rows at the end of an iteration, for a full step.
void take_bounds(context::Model& model, context::Newton& newton) noexcept;
/// Set the start of the next iteration: the point at the fraction t from the last iterate to the
/// solution.
void keep_bounds(context::Newton& newton, double t) noexcept;
/// Return Σ (W + Σ) (λ − P)² over bounded rows, at the fraction t of the way from the last iterate
/// to the solution [J].
[[nodiscard]] double bounds_merit(const context::Model& model, const context::Newton& newton,
                                  double t) noexcept;

/// Return the contribution of bounded rows to the slope of the convex phase, at the fraction t of
/// the way [J] (convex_phase.h).
[[nodiscard]] double bounds_slope(const context::Model& model, const context::Newton& newton,
                                  double t) noexcept;

inline constexpr std::int32_t kAnyRows = 0x7fffffff;

/// Return the largest relative difference between the impulse of a friction at its bound and the
/// bound for its present loads. It is the contribution of joints to the residual of a step.
[[nodiscard]] double bounds_map(const context::Model& model,
                                const context::Newton& newton) noexcept;

/// Switch rows whose status does not match, for the next iteration, and set inactive rows to their
/// moved bound.
/// @param floor  Impulse below which differences are ignored [N s].
/// @param most  Number of rows that may switch, in the order of rows; 0: only count.
/// @return the number of rows whose status does not match.
std::int32_t switch_bounds(context::Model& model, context::Work& work, double floor,
                           std::int32_t most) noexcept;

/// Set λ of inactive rows to the impulse that acts on the bodies. Call after the solver has
/// returned to an earlier iterate, because λ of rows that have switched since is out of date.
void show_held(context::Model& model) noexcept;

/// Count the rows that should become active or inactive at the current λ and v₊. Nothing is
/// changed.
/// @param floor  Impulse below which differences are ignored [N s].
[[nodiscard]] std::int32_t asking_rows(context::Model& model, context::Work& work,
                                       double floor) noexcept;

/// True if any bounded row should become active or inactive, that is, if asking_rows() with a floor
/// of 0 would return more than 0.
[[nodiscard]] bool any_row_requests_switch(const context::Model& model,
                                           const context::Newton& newton,
                                           const assembly::View& v) noexcept;

/// Move the friction anchors of joints that have slid. Call after the step.
void move_anchors(context::Model& model) noexcept;

}  // namespace hawser::solve
