// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file joints.h
/// Which joints hold at the end of a step, and their equations: see completion.h for what is made
/// of them.

#include "context/context.h"

namespace hawser::stepper {

/// Swing number up to which joints are completed.
inline constexpr double kResolvedSwing = 1.5;
/// s of a joint under its impulse, h² f max(r/I). @param lambdas  By row.
[[nodiscard]] double swing_number(const Model& model, std::int32_t id,
                                  const double* lambdas) noexcept;

/// Find the joints of a system that has just been analysed. @throws std::bad_alloc.
void find_joints(Model& model, JointWork& joints);

/// A step begins: nothing is refused yet.
void begin_completion(Model& model) noexcept;

/// Which joints this step completes, by their forces in the last one; marks their records.
void choose_completed(Model& model, const State& state, runtime::Pool& pool) noexcept;

/// c of completed rows of a strip about packed velocities u, see Kernels::complete_rows.
/// @return how much changed.
assembly::Turning complete_strip(const Model& model, const assembly::View& v, int strip,
                                 const double* u, bool first) noexcept;

/// What the equations of completed joints and spins are about v₊ as it stands, kept apart from
/// those in force. @return how much right-hand sides would change.
assembly::Turning renew_completed(StepContext& ctx) noexcept;

/// Their equations are those that renew_completed() has found.
void adopt_completed(StepContext& ctx) noexcept;

/// A step has been taken: counters go on.
void finish_completion(Model& model) noexcept;

}  // namespace hawser::stepper
