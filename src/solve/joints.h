// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file joints.h
/// Which joints hold at the end of a step, and their equations: see completion.h for what is made
/// of them.

#include "base/index.h"
#include "context/completion_data.h"
#include "context/context.h"

#include <cstdint>

namespace hawser::stepper {

/// Swing number up to which joints are completed.
inline constexpr double kResolvedSwing = 1.5;
/// |p|² of a joint's impulse [N² s²]. @param lambdas  By row.
[[nodiscard]] inline double squared_impulse(const JointPlace& joint,
                                            const double* lambdas) noexcept {
    const double* p = lambdas + joint.row;
    if (joint.rows == 3) return p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
    double square = 0.0;
    for (int r = 0; r < joint.rows; ++r) square += p[r] * p[r];
    return square;
}
/// s² of a joint under its impulse, s = h |p| max(r/I). @param k  Its place among the joints.
[[nodiscard]] inline double squared_swing(const Model& model, std::int32_t k,
                                          const double* lambdas) noexcept {
    const Completion& c = model.completion;
    const double rate = model.def.step * model.interactions.swing[at(c.joints[at(k)])];
    return rate * rate * squared_impulse(c.places[at(k)], lambdas);
}

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
