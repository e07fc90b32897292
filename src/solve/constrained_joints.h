// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file constrained_joints.h
/// Oscillation of light bodies that other joints hold.
///
/// A joint with the force f at the arm r of a body with the inertia I oscillates with s = h² f r/I,
/// if the body turns freely about its centre of mass. Other joints may hold the body: a light rod
/// between a pivot and a heavy bob turns only with the bob. The effective inertia Ĩ follows from a
/// unit torque on the body in the matrix of the step, whose geometric terms κ are subtracted:
/// ```
///     K [u; −λ] = [e; 0],   Ĩ = 1/max(e·u) − κ ≥ I       e: unit torques across the arm
/// ```
/// The ratio I/Ĩ, rounded up to a power of 2^(1/4), multiplies the oscillation number of the joint
/// (model::Interactions::coarse). It is measured again every 16 steps.

#include "context/context.h"

namespace hawser::solve {

/// Measure the joints whose oscillation the step would not resolve if their bodies turned freely.
/// Their codes are valid from the next step on. Needs the factorisation and the impulses of the
/// step.
void measure_constrained_joints(context::StepContext& ctx) noexcept;

}  // namespace hawser::solve
