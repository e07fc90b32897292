// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sleep.h
/// Sleep of islands at rest: steps omit them until they are disturbed.
///
/// A body is *at rest* if √(2T/m) < WorldDef::sleep_speed, T its kinetic energy, at the end of
/// certified steps (with method newton). An *island* consists of bodies with degrees of freedom
/// that are connected by interactions, loads of their friction, contacts and segments of wires.
/// Fixed and kinematic bodies do not join islands. An island falls asleep once all of its bodies
/// have been at rest for WorldDef::sleep_after. It stays awake while a moving kinematic body
/// belongs to one of its interactions or contacts. The system is then analysed with the bodies of
/// the island as fixed ones.
///
/// Exactness. The state does not change while an island sleeps. Poses, velocities (which are not
/// exactly zero), λ, anchors and friction memory keep their bits. The first step after waking
/// continues exactly from the state at falling asleep. Only the order of elimination may differ,
/// and with it the rounding. No velocity is removed or added.
///
/// Waking. An island wakes as a whole and before the step is solved in these cases.
/// 1. One of its shapes comes within the contact margin of an active body, or of a moving
///    kinematic body.
/// 2. A kinematic body of one of its interactions moves.
/// 3. An input changes that acts on one of its interactions or bodies. A new applied force or
///    velocity, and World::wake(), have the same effect.
/// A body that a system loads is never at rest. A new pose of a sleeping, fixed or kinematic body
/// wakes all islands, because contacts no longer identify the bodies that it supported. Additions
/// and removals wake the bodies in contact (edits.h).
///
/// Limits: motion slower than sleep_speed for sleep_after counts as rest, even at the turning point
/// of a very slow oscillation. Shapes of sleeping bodies still take part in collision detection.

#include "context/context.h"

namespace hawser::step {

/// Wake disturbed islands, and move the contacts of the sleeping ones behind the active contacts.
/// Call before the step is solved.
[[nodiscard]] Status wake_disturbed(context::StepContext& ctx) noexcept;

/// Update the number of steps at rest of each body, and let islands fall asleep. Call after a
/// successful step.
void fall_asleep(context::StepContext& ctx) noexcept;

}  // namespace hawser::step
