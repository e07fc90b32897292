// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file prestep.h
/// Stage prestep: the systems of the world act (hawser/system.h), and their changes are accepted or
/// undone.

#include "context/context.h"

namespace hawser::step {

/// Run the systems: loads, inputs. No effect without systems.
[[nodiscard]] Status prestep(context::StepContext& ctx) noexcept;

/// Accept the changes of systems after a successful step.
void accept_systems(context::StepContext& ctx) noexcept;

/// Undo the changes of systems after a failed step.
void take_back_systems(context::StepContext& ctx) noexcept;

/// Return ½ vᵀA v of the added mass of loads in this step [J].
[[nodiscard]] double added_energy(const context::Model& model, context::State& state,
                                  runtime::Pool& pool, const double* v) noexcept;

}  // namespace hawser::step
