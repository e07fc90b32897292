// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file stagger.h
/// The staggered start: velocities live half a step before poses (step.h), and begin there.

#include "context/context.h"

namespace hawser::stepper {

/// Take v₀ from time 0 to −h/2, which makes the scheme second order: v₋ = v₀ − (h/2) a, with
/// the acceleration a at time 0 from a trial step (stagger.cpp). Also gives the first λ for
/// geometric stiffness.
Status stagger(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
