// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sleep.h
/// Islands at rest sleep: they are left out of the steps until something disturbs them.
///
/// A body is *at rest* while √(2T/m) < WorldDef::sleep_speed, T its kinetic energy, at the end of
/// steps that are certified (with method newton). An *island* is what hangs together by
/// interactions, contacts and segments of wires between bodies that move; fixed and kinematic
/// bodies do not join islands. It falls asleep once all of its bodies have been at rest for
/// WorldDef::sleep_after, unless a kinematic body that moves belongs to one of its interactions or
/// contacts. The system is then analysed anew with the island's bodies as fixed ones.
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
/// - an input of one of its interactions or bodies changes, an applied force, a pose or a velocity
///   is set, or World::wake() asks for it. A pose set of a fixed or kinematic body wakes all.
///
/// Limits: what is slower than sleep_speed for sleep_after is at rest by definition, be it the
/// turning point of a very slow swing. Shapes of sleeping bodies still take part in collision
/// detection.

#include "stepper/context.h"

namespace hawser::stepper {

/// Part of prepare(). @throws std::bad_alloc.
void reserve_sleep(StepContext& ctx);
/// Without analysing: part of prepare().
void wake_all(StepContext& ctx) noexcept;

/// StepStats::asleep, of flags that were restored.
void count_asleep(StepContext& ctx) noexcept;

/// A body, or what it holds to, is changed from outside the step.
void disturb(StepContext& ctx, std::int32_t body) noexcept;

/// Before the step is solved: islands that are disturbed wake; contacts of the others are set
/// aside. @return false where memory could not grow.
[[nodiscard]] bool wake_disturbed(StepContext& ctx) noexcept;

/// After a good step: count how long bodies have been at rest; islands fall asleep.
void fall_asleep(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
