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
/// Velocities stay as the step left them: nothing is thrown. Each round is a substitution.
///
/// *Limits.* G is that of the step's start: beyond about a radian a step rounds need not converge,
/// and then the poses of the step stay. Gravity and springs work along δ without being counted: the
/// ledger of energy books it as unexplained, and the judges see it.

namespace hawser::stepper {

struct StepContext;

/// After bodies have moved. Does nothing where joints are closed, or steps take cuts.
void close_joints(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
