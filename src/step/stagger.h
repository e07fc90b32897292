// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file stagger.h
/// The staggered start: velocities are half a step before poses (step.h) from the start on.

#include "context/context.h"

namespace hawser::step {

/// Shift v₀ from time 0 to −h/2, which makes the scheme second order: v₋ = v₀ − (h/2) a. The
/// acceleration a at time 0 comes from a trial step (stagger.cpp). Also computes the first λ for
/// geometric stiffness.
Status stagger(context::StepContext& ctx) noexcept;

}  // namespace hawser::step
