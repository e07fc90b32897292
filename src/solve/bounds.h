// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file bounds.h
/// Rows whose force is bounded: lines that only pull, ranges, motors, friction in joints.
///
/// The first row of such an interaction, with r = c − G v − Σλ, obeys λ = P(λ + r/(W + Σ)) for any
/// W > 0, P the projection onto the impulses [low, high] that it may have:
/// ```
///     low = −∞   high = 0     a line: λ < 0 is tension
///     0 or −∞    0 or ∞       a range, by the end that its joint is beyond
///     h F_min    h F_max      a motor
///    −B          B            friction, B = h F + Σ factor ‖λ of what loads it‖
/// ```
/// Inside, r = 0: the row is solved for. At an end it is *idle*: its equation is left out and λ is
/// `held` there. Which of the two holds follows, as for contacts, from the sign of λ + r/(W + Σ), W
/// its share of G M⁻¹ Gᵀ, so that one Newton method finds both: each iteration solves with the
/// statuses of the last, and those that the solution contradicts change. A status changes the
/// matrix; a bound that moves with a load changes the right-hand side only. An idle row may ask for
/// the other end of its range: a motor that is told to turn back.
///
/// **Power.** A motor with a limit of power P drives with λ w₊ ≤ h P, w₊ the speed of its row after
/// the step. That bound follows the solution like the bounds of friction do (impulse_range.cpp).
///
/// **Loads.** The bound of friction lags an iteration behind its load; loads that friction itself
/// makes up by a share s would take log(1e-6)/log(s) iterations, each the cost of a substitution: a
/// line round a bollard has s = tanh(μδ/2), for three turns at μ = 0.3 that is 2,000 of them. While
/// no status changes λ is affine in the bounds, so that Anderson's acceleration ends after as many
/// iterations as there are bounds that depend on each other, and one (nonsmooth/anderson.h).

#include "context/context.h"
#include "solve/impulse_range.h"

namespace hawser::stepper {

/// Room for the rows there are. @throws std::bad_alloc.
void reserve_bounds(const Model& model, Newton& newton);

/// Before rows are assembled: impulses of idle rows, which bounds may have moved. @param time  That
/// the bounds of forces act for [s]: the step, or 0 in an impact.
void hold_bounds(Model& model, Newton& newton, double time) noexcept;

/// λ and r where an iteration's full step ends.
void take_bounds(Model& model, Newton& newton) noexcept;
/// A share t of the way is where the next one begins.
void keep_bounds(Newton& newton, double t) noexcept;
/// Σ (W + Σ) (λ − P)² a share t of the way [J].
[[nodiscard]] double bounds_merit(const Model& model, const Newton& newton, double t) noexcept;

/// Part of rows in the slope of the convex phase, a share t of the way [J] (convex_phase.h).
[[nodiscard]] double bounds_slope(const Model& model, const Newton& newton, double t) noexcept;

inline constexpr std::int32_t kAnyRows = 0x7fffffff;

/// Largest relative distance of friction at its bound from where its loads have moved that: the
/// part of joints in the residual of a step.
[[nodiscard]] double bounds_map(const Model& model, const Newton& newton) noexcept;

/// Switch rows by where the next iteration begins; idle ones go with their bound. @param floor
/// Impulse that does not count [N s]. @param most  Rows that may switch, the first ones; 0: only
/// count. @return rows that ask to be active, or idle.
std::int32_t switch_bounds(Model& model, Work& work, double floor, std::int32_t most) noexcept;

/// Shows of idle rows what acts on the bodies: after a step back to an iterate, or to a place
/// between two, λ of a row that was switched since is still what it had before.
void show_held(Model& model) noexcept;

/// Rows that ask to switch where λ, v₊ are as they stand. Nothing is moved. @param floor  Impulse
/// that does not count [N s].
[[nodiscard]] std::int32_t asking_rows(Model& model, Work& work, double floor) noexcept;

/// asking_rows() > 0 with no floor, without a trace.
[[nodiscard]] bool any_asks(const Model& model, const Newton& newton,
                            const assembly::View& v) noexcept;

/// After the step: anchors of friction that slid follow.
void move_anchors(Model& model) noexcept;

}  // namespace hawser::stepper
