// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file integrate.h
/// Stage integrate: the solution becomes the state. Poses, velocities, forces, line breaks, energy,
/// time.

#include "context/context.h"

namespace hawser::step {

/// Integrate a step that has been solved and checked. Cannot fail.
void integrate(context::StepContext& ctx) noexcept;

}  // namespace hawser::step
