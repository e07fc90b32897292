// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file closing.h
/// Poses that joints agree with, where a step could not complete them.
///
/// A joint whose swing the step does not resolve is linearised once (completion.h). Where bodies
/// turn far in a step it then ends open, by h² v⊥²/L, and what stands open would be closed by
/// forces over the next steps. So the poses are put right at once, with the factorisation at hand:
/// ```
///     K [δ; −μ] = [0; −g(x)/h],     x ← x ⊕ h δ,     until |g| ≤ kClosed,
/// ```
/// which moves bodies by as little as possible in the metric of M̃ and past what touches or pulls.
/// Velocities stay as the step left them, angular ones in their bodies' frames: nothing is thrown,
/// and kinetic energy stays. Each round is a substitution.
///
/// G is that of the step's start, which closes nothing any more where light bodies have turned by
/// half a radian and more. There, G and the factors are those of the poses reached, renewed until
/// the joints are closed, with moves halved that open more than they close (Newton's method with a
/// search along its direction).
///
/// *Limits.* Bodies a millionth as heavy as their neighbours, thrown by several lengths in a step,
/// may stay open: the judges see it. Gravity and springs work along δ without being counted: the
/// ledger of energy books it as unexplained.

namespace hawser::stepper {

struct StepContext;

/// After bodies have moved. Does nothing where joints are closed, or steps take cuts.
void close_joints(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
