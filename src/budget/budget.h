// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file budget.h
/// Budget of an iterative solve: decides during the solve if another iteration fits; deadline.h
/// decides before it begins.
///
/// The next iteration is assumed to cost the prediction of deadline.h, or else as much as the last
/// one. The rest of the solve (projection, refinement) is assumed to cost as much as in the step
/// before. Times differ from run to run. To make a run repeatable, the resulting decision is
/// recorded and imposed (Degradation).

#include <hawser/stats.h>

namespace hawser::budget {

/// Consumption since the begin of the solver.
struct Spent {
    double seconds = 0.0;  ///< CPU time of the slowest thread.
    double work = 0.0;     ///< [flop]
};

/// Limits of the contact solve of a step; 0: none.
struct Limits {
    double seconds = 0.0, work = 0.0;
    int most = 0;       ///< Maximum number of iterations.
    double next = 0.0;  ///< Cost of a further iteration; 0: as the last one [s].
    /// Predicted end of the solver with one iteration more than `most` [s].
    double foreseen = 0.0;
    Degradation imposed{};  ///< Imposed degradation; replaces all limits.
};

class Budget {
  public:
    /// Begin a solve. @param spent  Consumption up to the first iteration.
    void begin(const Limits& limits, const Spent& spent) noexcept {
        limits_ = limits;
        last_ = spent;
        cause_ = DegradedBy::nothing;
        foreseen_ = 0.0;
    }
    /// End a solve: there are no limits until the next begin().
    void end() noexcept { limits_ = {}; }
    [[nodiscard]] bool needs_time() const noexcept {
        return !limits_.imposed.any() && limits_.seconds > 0.0;
    }
    /// True if a solve that the budget ends keeps the present factorisation, because another one
    /// would not fit.
    [[nodiscard]] bool exits_early() const noexcept {
        return limits_.imposed.any() ? limits_.imposed.hasty : limits_.seconds > 0.0;
    }

    /// Decide after each iteration. @param iterations  Number of finished iterations.
    [[nodiscard]] bool allows_iteration(const Spent& spent, int iterations) noexcept {
        if (limits_.imposed.any()) {
            const int most = limits_.imposed.iterations;
            return most == 0 || iterations < most || set_cause(DegradedBy::order, 0.0);
        }
        const Spent next{2.0 * spent.seconds - last_.seconds, 2.0 * spent.work - last_.work};
        last_ = spent;
        const double end =
            (limits_.next > 0.0 ? spent.seconds + limits_.next : next.seconds) + finish_;
        if (limits_.seconds > 0.0 && end > limits_.seconds)
            return set_cause(DegradedBy::clock, end);
        if (limits_.work > 0.0 && next.work > limits_.work) return set_cause(DegradedBy::work, 0.0);
        if (limits_.most > 0 && iterations >= limits_.most)
            return set_cause(DegradedBy::prediction, limits_.foreseen);
        return true;
    }
    /// Report the end of the solve. @param seconds  Time spent, including the work after the last
    /// allows_iteration().
    void record_end_of_solve(double seconds) noexcept { finish_ = seconds - last_.seconds; }

    [[nodiscard]] DegradedBy cause() const noexcept { return cause_; }
    [[nodiscard]] double foreseen() const noexcept { return foreseen_; }  ///< [s]

  private:
    bool set_cause(DegradedBy cause, double foreseen) noexcept {
        cause_ = cause;
        foreseen_ = foreseen;
        return false;
    }

    Limits limits_;
    double finish_ = 0.0;  ///< Time to end the solve after the last iteration [s].
    Spent last_;
    DegradedBy cause_ = DegradedBy::nothing;
    double foreseen_ = 0.0;
};

}  // namespace hawser::budget
