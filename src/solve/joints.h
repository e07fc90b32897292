// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file joints.h
/// Selection of joints that hold at the end of a step, and their equations. completion.h describes
/// their use.

#include "base/index.h"
#include "context/completion_data.h"
#include "context/context.h"

#include <cstdint>

namespace hawser::solve {

/// Oscillation number up to which joints are completed.
inline constexpr double kResolvedVibration = 1.5;
/// Return |p|² of a joint's impulse [N² s²].
/// @param lambdas  By row.
[[nodiscard]] inline double squared_impulse(const context::JointSlot& joint,
                                            const double* lambdas) noexcept {
    const double* p = lambdas + joint.row;
    if (joint.rows == 3) return p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
    double square = 0.0;
    for (int r = 0; r < joint.rows; ++r) square += p[r] * p[r];
    return square;
}
/// Return the square of s = h |p| max(r/I), the vibration ratio (hω)² of a joint with the impulse
/// p.
/// @param k  Index of the joint.
[[nodiscard]] inline double squared_vibration(const context::Model& model, std::int32_t k,
                                              const double* lambdas) noexcept {
    const context::Completion& c = model.completion;
    const double rate = model.def.step * model.interactions.vibration[at(c.joints[at(k)])];
    return rate * rate * squared_impulse(c.joint_slots[at(k)], lambdas);
}

/// Find the joints of a system that has just been analysed.
/// @throws std::bad_alloc.
void find_joints(context::Model& model, context::JointWork& joints);

/// Begin a step: clear the marks of rejected joints.
void begin_completion(context::Model& model) noexcept;

/// Choose the joints for the end-of-step constraint iterations of this step by their forces in the
/// last step, and mark their records.
void choose_completed(context::Model& model, const context::State& state,
                      runtime::Pool& pool) noexcept;

/// Linearise the completed rows of a row block about packed velocities u and compute their
/// right-hand side c, see Kernels::complete_rows.
/// @return the change of c.
assembly::Turning complete_block(const context::Model& model, const assembly::View& v, int strip,
                                 const double* u, bool first) noexcept;

/// Linearise completed joints and spins about the current v₊ and compute their new right-hand
/// sides, without applying them.
/// @return the change of the right-hand sides.
context::IterationChange renew_completed(context::StepContext& ctx) noexcept;

/// Make the right-hand sides that renew_completed() has computed the current ones.
void adopt_completed(context::StepContext& ctx) noexcept;

/// Store the number of coming steps in which each joint is linearised only once. Call after a
/// successful step.
void finish_completion(context::Model& model) noexcept;

}  // namespace hawser::solve
