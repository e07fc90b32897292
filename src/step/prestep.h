// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file prestep.h
/// Stage prestep: the systems of the world act (hawser/system.h), and what they do is kept or taken
/// back.

#include "context/context.h"

namespace hawser::stepper {

/// Systems act: loads, inputs. Without systems it does nothing.
[[nodiscard]] Status prestep(StepContext& ctx) noexcept;

/// After a good step: what they did stays.
void accept_systems(StepContext& ctx) noexcept;

/// After a step that failed, wherever it did: what they did is taken back.
void take_back_systems(StepContext& ctx) noexcept;

/// ½ vᵀA v of the added mass that systems load bodies with in this step [J].
[[nodiscard]] double added_energy(const Model& model, State& state, runtime::Pool& pool,
                                  const double* v) noexcept;

}  // namespace hawser::stepper
