// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file judge_bearing.h
/// Checks in every step that lines are such as a material can be (judge.h): before an element parts
/// in the step, since what has parted is not looked at any more.

#include "context/context.h"
#include "context/judge_data.h"

namespace hawser::stepper {

/// Strain of elements with a breaking load, by their tension in this step and by their length at
/// its start. Wrong beyond kMostStrain and kMostBreaking times the strain at the breaking load;
/// doubtful where an element is for three steps a quarter longer than it bears and does not part.
/// Finding::value is minus the strain.
[[nodiscard]] Finding strain_finding(Model& model, const State& state, JudgeState& memory) noexcept;

/// Wound elements of less than no length for three steps: a slide took in more than there is. The
/// element of a drum does not come there (kLeastOfDrumElement). Finding::value is the length [m].
[[nodiscard]] Finding wound_finding(const Model& model, const State& state,
                                    JudgeState& memory) noexcept;

}  // namespace hawser::stepper
