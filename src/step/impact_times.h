// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file impact_times.h
/// Times of impacts within a step.
///
/// A contact may have an impact if it is about to close faster than gravity alone would close it. A
/// trial of the step without these contacts gives the change of velocity h a of smooth forces. With
/// the gap d and the normal speeds u₋ before the step and u₊ after the trial, the gap at time t is
/// ```
///   d(t) = d + ½ (u₋ + u₊) t + ½ (u₊ − u₋) t²/h,    0 ≤ t ≤ h
/// ```
/// which is exact for constant forces. Its first root is the time of the impact. Bodies that joints
/// and closed contacts connect have the time of their first impact.

#include "context/context.h"

namespace hawser::step {

/// Return the approach speed below which impacts are inelastic [m/s].
[[nodiscard]] double impact_threshold(const context::Model& model) noexcept;

/// Return the coefficient of restitution of a contact.
[[nodiscard]] double restitution(const context::State& state, std::size_t contact) noexcept;

/// Mark the contacts that may have an impact in this step. @return true if there are any. On
/// failure `status` is not ok.
[[nodiscard]] bool mark_candidates(context::StepContext& ctx, Status& status) noexcept;

/// Set the times of impacts from a trial of the step, and mark their contacts. The trial changes
/// contacts and rows. @return true if there are impacts. On failure `status` is not ok.
[[nodiscard]] bool find_times(context::StepContext& ctx, Status& status) noexcept;

/// Return the time of the impact of a body, 0 if it has none [s].
[[nodiscard]] inline double impact_time(const context::ImpactWork& work,
                                        std::size_t body) noexcept {
    return work.time[body] > 0.0 ? work.time[body] : 0.0;
}

}  // namespace hawser::step
