// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file closing.h
/// Position projection of joints that a step could not complete.
///
/// A joint whose oscillation the step does not resolve is linearised once (completion.h). If bodies
/// turn far in a step, it ends open by h² v⊥²/L. Forces would close the gap over the next steps.
/// Instead the poses are corrected at once, with the present factorisation:
/// ```
///     K [δ; −μ] = [0; −g(x)/h],     x ← x ⊕ h δ,     until |g| ≤ kClosed.
/// ```
/// This moves bodies by as little as possible in the metric of M̃, regardless of contacts and
/// tensions. Velocities stay unchanged, angular ones in the frames of their bodies. The kinetic
/// energy therefore stays unchanged. Each iteration is a substitution.
///
/// G is taken at the start of the step. If light bodies have turned by half a radian or more, it no
/// longer closes the gaps. Then G and the factors are computed at the poses reached, and renewed
/// until the joints are closed. Moves that increase the gaps are halved (Newton's method with a
/// line search).
///
/// Limits. Joints of bodies a millionth as heavy as their neighbours may stay open if a step moves
/// these bodies by several lengths. The monitors report it. The work of gravity and springs along δ
/// is not counted: the energy balance shows it as unexplained.

namespace hawser::context {
struct StepContext;
}  // namespace hawser::context

namespace hawser::step {

/// Close joints after bodies have moved. No effect if joints are closed, or the world has cuts.
void close_joints(context::StepContext& ctx) noexcept;

}  // namespace hawser::step
