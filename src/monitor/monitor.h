// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file monitor.h
/// Monitors of the plausibility of states. Each state is checked in the step after it, with data of
/// that step. The limits and their reasons are in docs/limits.md.
///
/// Created energy is the gain of kinetic, gravity and elastic energy beyond the work of forces,
/// drives, friction and contacts. It is computed in three ways.
/// 1. At the midpoint between poses, where velocities are defined.
/// 2. At the poses, with the mean of the velocities before and after.
/// 3. At the midpoint, with the energy of springs from their force. The length of an
/// unresolved
///    spring does not match its force, because its direction turns.
/// Each has momentary changes if motion is fast; the smallest rise is used.
///
/// Unexplained energy adds the losses of drag and rows, which may hide a gain. It is counted by
/// rows linearised once a step, and therefore has a wider limit. All of these are sums over the
/// steps, so that sampling every few steps misses nothing.
///
/// Losses of rows are an explanation only if they are positive. Joints do no work; two inconsistent
/// ones add energy, as a negative loss. A further sum therefore adds the energy that rows returned
/// beyond their losses within about a second. That energy may be stored in an overlap or in an
/// element that tightens.
///
/// The monitors check the rise of each sum above its minimum, and the fall of the unexplained
/// energy below its maximum. Both are relative to the exchanged energy: kinetic energy plus half of
/// the changes of all terms. Minima and exchange decay within kMemory. A result is suspect by the
/// part that three consecutive samples have in common, because a whip within two steps changes
/// energy only briefly. A step fails by means over kMean.
///
/// Limits. A gain at one location and a simultaneous loss at another are not distinguished.

#include <hawser/limits.h>
#include <hawser/stats.h>

#include "assembly/view.h"
#include "context/context.h"

#include <array>
#include <cstdint>
#include <vector>

namespace hawser::monitor {

/// Compute the energy at the start, from the given velocities.
void begin_monitors(context::StepContext& ctx) noexcept;
/// Check the state before the present step, whose rows have been evaluated.
[[nodiscard]] Status run_monitors(context::StepContext& ctx) noexcept;
/// Return the result of the monitors for the present state.
[[nodiscard]] Verdict verdict(context::StepContext& ctx) noexcept;

}  // namespace hawser::monitor
