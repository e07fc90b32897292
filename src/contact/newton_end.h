// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file newton_end.h
/// Ends of Newton's iterations that come before the step is solved, see newton.h: the best iterate
/// is taken, impulses are projected onto their cones, and momentum is balanced with them.

#include "context/context.h"
#include "context/newton_data.h"

namespace hawser::stepper {

/// Ended with time for one more factorisation.
[[nodiscard]] Status end_early(StepContext& ctx) noexcept;
/// Ended without: the law in the matrix is moved through the projected impulse.
void end_hastily(Model& model, Work& work, runtime::Pool& pool) noexcept;

/// Project the impulses of all contacts onto their friction cones; the laws in the matrix follow.
void project_all(Model& model) noexcept;

/// Velocities and impulses of contacts from where the last step ended.
void go_back_to_last(Model& model, base::Array<double>& contact_speed) noexcept;

/// No iterate is set aside.
void forget_best(Newton& newton) noexcept;
/// The iterate kept is the best so far, and the one at hand is worse: set it aside.
void set_best_aside(Newton& n, double merit) noexcept;

}  // namespace hawser::stepper
