// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file judge.h
/// Whether what steps come to can be: each state is judged in the step after it, by figures that
/// this one has at hand. The limits and their reasons are in docs/limits.md.
///
/// Energy. Created is what kinetic, gravity and elastic energy together gained beyond the work of
/// forces and drives, friction and contacts: half-way between poses, where velocities live, and at
/// the poses, with the mean of the velocities before and after; and half-way with springs that hold
/// what their force says, as one that the step does not resolve is left longer or shorter than it
/// pulls by the turning of its direction. Each comes and goes where motion is fast; the smallest
/// rise is taken. What drag and rows took may hide more: unexplained is
/// the gain with that added, counted by rows linearised once a step, and so judged less closely.
/// All of these are sums over the steps, so that a look every few steps misses nothing. What rows
/// take is an explanation as long as it is more than nothing: joints do no work, and two that
/// contradict each other put in energy as if they took less than nothing. A further sum therefore
/// adds what rows gave beyond what they had taken within about a second, which may be held in an
/// overlap or in an element that comes taut. Judged is how far each rises above its lowest value,
/// and the unexplained falls below its highest, over what was exchanged: kinetic energy and half
/// the changes of all that is in the sums. Both forget within kMemory. A result is doubtful by
/// what three looks running have in common, as energy of a moment comes and goes where something
/// whips round within two steps; a step is refused by means over kMean.
///
/// Limits. A rise in one place and a loss in another at the same time are not told apart.

#include <hawser/limits.h>
#include <hawser/stats.h>

#include "assembly/view.h"
#include "context/context.h"

#include <array>
#include <cstdint>
#include <vector>

namespace hawser::stepper {

/// Energy at the start, from velocities as given.
void begin_judge(StepContext& ctx) noexcept;
/// Velocities have gone from the start to half a step before, by which the start is as far away
/// along the way that forces pushed: what rests and is pushed up against its weight is higher
/// there, and no step tells of that work. @param power  Of forces at the velocities as given [W].
void judge_from_half_a_step_before(StepContext& ctx, double power) noexcept;
/// Of applied forces and loads of systems at the velocities at hand [W].
[[nodiscard]] double power_of_forces(StepContext& ctx) noexcept;
/// Judge the state before the step being taken, whose rows have been evaluated.
[[nodiscard]] Status judge(StepContext& ctx) noexcept;
/// The verdict with the present state.
[[nodiscard]] Verdict verdict(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
