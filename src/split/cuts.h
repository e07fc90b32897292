// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cuts.h
/// Splits: interactions between parts that each part solves for on its own.
///
/// A cut interaction is left out of the system. In its place stand *copies*, one for each side: the
/// same rows, in which the bodies of the other sides are *images*, bodies without freedom that are
/// where those bodies are and move at a velocity v̄ that a predictor gives.
/// ```
///    a ── b ══ c ── d          a ── b ══ c̄      b̄ ══ c ── d
///       cut: ══                one island        another one
/// ```
/// So a matrix of independent parts comes about without code of its own in the analysis, the
/// factorisation, the friction solver or the schedule. After the solve a cut has as many
/// multipliers as sides; readers see their mean. docs/methods.md, 10 has the theory.
///
/// Images and copies stand behind all other bodies and interactions: the model of the user is the
/// front of the arrays.

#include <hawser/def.h>
#include <hawser/stats.h>

#include "context/context.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace hawser::stepper {

/// Whether an interaction is one that can be cut: no drive, friction, range or winch, nor what
/// loads friction.
[[nodiscard]] bool can_cut(const StepContext& ctx, std::int32_t id) noexcept;

/// Whether there are images and copies, or would be after prepare().
[[nodiscard]] bool may_have_cuts(const StepContext& ctx) noexcept;

/// Images and copies for the groups and couplings there are. @throws std::bad_alloc.
void make_cuts(StepContext& ctx);
/// Take them away, as must be done before bodies or interactions are added.
void drop_cuts(StepContext& ctx);
/// Whether groups are made here.
[[nodiscard]] bool makes_groups(const StepContext& ctx) noexcept;

}  // namespace hawser::stepper
