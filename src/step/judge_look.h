// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file judge_look.h
/// What judges look at: energies and extremes of a state, summed over chunks in their order.

#include "context/context.h"
#include "context/judge_data.h"

namespace hawser::stepper {

/// When velocities are those of the poses, or of half a step before them.
enum class At { pose, half_step };

/// Energies and extremes of the state, whose rows have been evaluated; they do not depend on
/// threads.
[[nodiscard]] JudgePart look(Model& model, State& state, runtime::Pool& pool, At when) noexcept;

/// Violations of the rows of springs at the poses as they are, into `gaps`, by row.
void read_spring_gaps(Model& model, const State& state, double* gaps) noexcept;

/// How much more springs hold half a step before the poses, reckoned back by the velocities, since
/// poses have moved by all of what they were closed by instead of half [J].
/// @param before  Of read_spring_gaps() before the poses were closed.
[[nodiscard]] double held_by_closing(Model& model, const State& state,
                                     const double* before) noexcept;

}  // namespace hawser::stepper
