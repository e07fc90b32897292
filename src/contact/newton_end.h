// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file newton_end.h
/// Ends of Newton's iterations before the step is solved, see newton.h. The best iterate is used,
/// impulses are projected onto their cones, and momentum is balanced with them.

#include "context/context.h"
#include "context/newton_data.h"

namespace hawser::contact {

/// End the iterations with time for one more factorisation.
[[nodiscard]] Status end_with_lagged_laws(context::StepContext& ctx) noexcept;
/// End them without: the law in the matrix is shifted through the projected impulse.
void end_at_best_iterate(context::Model& model, context::Work& work, runtime::Pool& pool) noexcept;

/// Project the impulses of all contacts onto their friction cones; the laws in the matrix follow.
void project_all(context::Model& model) noexcept;

/// Set velocities and impulses of contacts to the end of the last step.
void restore_last_step(context::Model& model, base::Array<double>& contact_speed) noexcept;

/// Discard the stored best iterate.
void forget_best(context::Newton& newton) noexcept;
/// Store the previous iterate as the best one, because the current one is worse.
void save_if_best(context::Newton& n, double merit) noexcept;

}  // namespace hawser::contact
