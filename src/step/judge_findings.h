// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file judge_findings.h
/// What each judge finds in a state (judge.h): how much, over its limits, where. Figures come from
/// a look at the state (judge_look.h); what lasts from one look to the next is in `memory`.

#include "context/context.h"
#include "context/judge_data.h"
#include "step/judge_energy.h"

namespace hawser::stepper {

/// Works since the start, in the order of WorkBy.
[[nodiscard]] Works works(const State& state) noexcept;

/// Energy out of nothing, or gone. @param time  Since the last look [s].
[[nodiscard]] Finding energy_finding(const Model& model, const State& state, const JudgePart& p,
                                     JudgeState& memory, double time) noexcept;
/// A joint that stands open.
[[nodiscard]] Finding open_finding(const Model& model, const State& state, const JudgePart& p,
                                   JudgeState& memory, double time) noexcept;
/// A range that does not hold. What strikes its end goes beyond by its way in a step, and comes
/// back by 4/9 of that a step: six looks running leave 5 % of it.
[[nodiscard]] Finding range_finding(const Model& model, const State& state, const JudgePart& p,
                                    JudgeState& memory) noexcept;
/// Bodies that lie in each other, for six looks running. The thinner one is named.
[[nodiscard]] Finding depth_finding(const Model& model, const State& state, const JudgePart& p,
                                    JudgeState& memory) noexcept;
/// Equations that are left unsolved.
[[nodiscard]] Finding solved_finding(const StepContext& ctx, JudgeState& state,
                                     double time) noexcept;
/// A line that comes taut is off its law for a moment, one that rings is at every look.
[[nodiscard]] Finding stretch_finding(const Model& model, const State& state, const JudgePart& p,
                                      JudgeState& memory) noexcept;
/// A body or an element that turns by much in a step.
[[nodiscard]] Finding turn_finding(const Model& model, const State& state,
                                   const JudgePart& p) noexcept;

}  // namespace hawser::stepper
