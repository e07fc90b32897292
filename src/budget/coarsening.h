// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file coarsening.h
/// Coarsening of wires so that steps meet their budget (docs/theory/deadlines.md). It is the first
/// measure of degradation.
///
/// The demand x of a step is its time or work over the limit; it exceeds 1 if iterations were cut.
/// The estimate of x is its mean plus twice its deviation, as for rates (deadline.h). If the
/// estimate exceeds 1, wires become coarser by one level. Nodes are removed one at a time. Another
/// level follows only if the mean exceeds 1 and no longer decreases; for short peaks, iterations
/// are cut. If the mean stays below kLowerLevelFraction, wires become finer by one level. Steps
/// with an analysis are not counted, because the removal of nodes causes them.
///
/// Until wires have become coarser for the first time, if they can, and for kObservedSteps steps
/// after a change, steps are solved completely.
///
/// Limits: the estimates are not part of the state. The level is recorded (Degradation::wires).

#include "budget/deadline.h"

namespace hawser::budget {

class Coarsening {
  public:
    static constexpr int kMaxLevel = 4;        ///< Levels.
    static constexpr int kObservedSteps = 60;  ///< Steps in which a decreasing mean is awaited.
    /// Maximum ratio of the mean after kObservedSteps steps that counts as a decrease.
    static constexpr double kMaxRatioOfDecrease = 0.97;
    static constexpr int kMinStepsAtLevel =
        240;  ///< Minimum steps at a level before the next lower one.
    /// Limit of the mean for a finer level, which needs up to 1.5 times the time.
    static constexpr double kLowerLevelFraction = 0.6;

    bool possible = false;  ///< True if a system would remove more nodes at a higher level.
    [[nodiscard]] int level() const noexcept { return level_; }
    /// True if wires must be coarsened before the solver's work is reduced in another way.
    [[nodiscard]] bool has_priority() const noexcept {
        return possible && (level_ == 0 || (level_ == 1 && reached_from_below_ &&
                                            steps_at_level_ < kObservedSteps));
    }
    /// Record a step without analysis. @param demand  Time of the step divided by the budget.
    void add_sample(double demand) noexcept {
        rate_.add_sample(demand);
        mean_ = rate_.samples() == 1 ? demand : mean_ + 0.125 * (demand - mean_);
        if (rate_.samples() < Rate::kSettledSamples) return;
        bool mean_stopped = level_ == 0;
        if (++steps_at_level_ % kObservedSteps == 0) {
            mean_stopped = mean_stopped || mean_ > kMaxRatioOfDecrease * mean_before_;
            mean_before_ = mean_;
        }
        const double demanded = level_ == 0 ? rate_.upper_estimate() : mean_;
        if (mean_stopped && possible && level_ < kMaxLevel && demanded > 1.0)
            set_level(level_ + 1);
        else if (level_ > 0 && steps_at_level_ >= kMinStepsAtLevel && mean_ < kLowerLevelFraction)
            set_level(level_ - 1);
    }

  private:
    void set_level(int level) noexcept {
        reached_from_below_ = level > level_;
        level_ = level;
        steps_at_level_ = 0;
        mean_before_ = mean_;
    }
    Rate rate_;
    double mean_ = 0.0, mean_before_ = 0.0;
    int level_ = 0;
    bool reached_from_below_ = true;  ///< True if the level was reached from the level below.
    int steps_at_level_ = 0;          ///< Steps at this level.
};

}  // namespace hawser::budget
