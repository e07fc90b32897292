// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file judge_energy.h
/// The ledger of judges: sums of energy, how far they rise and fall, and what was exchanged
/// (judge.h).

#include "context/judge_data.h"

namespace hawser::stepper {

/// How far a sum is above its least value, and below its highest [J].
struct Swing {
    double rise = 0.0, fall = 0.0;
};

/// Energy that came or went without reason: at this moment, and in the mean.
struct Unexplained {
    ByAccount<Swing> now{}, mean{};
    /// This moment against the extremes of the mean: an extreme that did not last counts by its
    /// share of kMean.
    ByAccount<Swing> lasting{};
    double posed = 0.0;  ///< What JudgeState::posed was before [J].
};

/// The sums begin: energy at the start.
void begin_energy(const JudgePart& p, const Works& works, JudgeState& state) noexcept;

/// `state` goes on to this look. @param time  Since the last one [s].
[[nodiscard]] Unexplained follow_energy(const JudgePart& p, const Works& works, double time,
                                        JudgeState& state) noexcept;

}  // namespace hawser::stepper
