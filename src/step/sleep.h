// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sleep.h
/// Islands at rest sleep: they are left out of the steps until something disturbs them.
///
/// A body is *at rest* while √(2T/m) < WorldDef::sleep_speed, T its kinetic energy, at the end of
/// steps that are certified (with method newton). An *island* is what hangs together by
/// interactions, what loads their friction, contacts and segments of wires between bodies that
/// move; fixed and kinematic bodies do not join islands. It falls asleep once all of its bodies
/// have been at rest for WorldDef::sleep_after, unless a kinematic body that moves belongs to one
/// of its interactions or contacts. The system is then analysed anew with the island's bodies as
/// fixed ones.
///
/// **Exact.** Nothing of the state changes while an island sleeps: poses, velocities (which are not
/// quite zero), λ, anchors and memories of friction stay bit by bit, so that the first step after
/// it wakes is the one that would have come next; only the order of elimination may differ, and
/// with it the rounding. No speed is taken away and none is invented.
///
/// **Waking.** An island wakes, whole and before the step is solved, when
/// - one of its shapes comes within the contact margin of a body that is awake, or of a kinematic
///   body that moves;
/// - a kinematic body of one of its interactions moves;
/// - an input changes what acts on one of its interactions or bodies, another applied force or a
///   velocity is set, or World::wake() asks for it.
/// A body that a system loads is never at rest.
/// A pose that is set, of a body that sleeps or is fixed or kinematic, wakes all, since contacts do
/// not tell any more what leant on it. What is added or removed wakes what it touches (edits.h).
///
/// Limits: what is slower than sleep_speed for sleep_after is at rest by definition, be it the
/// turning point of a very slow swing. Shapes of sleeping bodies still take part in collision
/// detection.

#include "context/context.h"

namespace hawser::stepper {

/// Before the step is solved: islands that are disturbed wake; contacts of the others are set
/// aside.
[[nodiscard]] Status wake_disturbed(StepContext& ctx) noexcept;

/// After a good step: count how long bodies have been at rest; islands fall asleep.
void fall_asleep(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
