// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file budget.h
/// Whether a solve that runs in iterations can afford another one, while it runs; deadline.h
/// decides before it begins.
///
/// The next iteration is taken to cost what deadline.h says, which learns it, else what the last
/// one did, and what follows the last iteration (projection, refinement) what it did in the step
/// before. Time differs from run to run; so that a run can be repeated, what it allowed is what
/// gets recorded and imposed (Degradation).

#include <hawser/stats.h>

namespace hawser::stepper {

/// Spent since the solver began.
struct Spent {
    double seconds = 0.0;  ///< CPU time of the slowest thread.
    double work = 0.0;     ///< [flop]
};

/// Limits of a step's solve for contacts; 0: none.
struct Limits {
    double seconds = 0.0, work = 0.0;
    int most = 0;           ///< Iterations.
    double next = 0.0;      ///< What a further iteration takes; 0: what the last one did [s].
    double foreseen = 0.0;  ///< With one more than `most` the solver would end at [s].
    Degradation imposed{};  ///< Instead of all these.
};

class Budget {
  public:
    /// @param spent  Until now, where the first iteration begins.
    void begin(const Limits& limits, const Spent& spent) noexcept {
        limits_ = limits;
        last_ = spent;
        cause_ = DegradedBy::nothing;
        foreseen_ = 0.0;
    }
    /// The solve has ended: nothing is limited until the next begin().
    void end() noexcept { limits_ = {}; }
    [[nodiscard]] bool needs_time() const noexcept {
        return !limits_.imposed.any() && limits_.seconds > 0.0;
    }
    /// Whether a solve that it ends ends with the factorisation at hand: one more would not fit.
    [[nodiscard]] bool hasty() const noexcept {
        return limits_.imposed.any() ? limits_.imposed.hasty : limits_.seconds > 0.0;
    }

    /// After each iteration. @param iterations  Made so far.
    [[nodiscard]] bool another(const Spent& spent, int iterations) noexcept {
        if (limits_.imposed.any()) {
            const int most = limits_.imposed.iterations;
            return most == 0 || iterations < most || refuse(DegradedBy::order, 0.0);
        }
        const Spent next{2.0 * spent.seconds - last_.seconds, 2.0 * spent.work - last_.work};
        last_ = spent;
        const double end =
            (limits_.next > 0.0 ? spent.seconds + limits_.next : next.seconds) + finish_;
        if (limits_.seconds > 0.0 && end > limits_.seconds) return refuse(DegradedBy::clock, end);
        if (limits_.work > 0.0 && next.work > limits_.work) return refuse(DegradedBy::work, 0.0);
        if (limits_.most > 0 && iterations >= limits_.most)
            return refuse(DegradedBy::prediction, limits_.foreseen);
        return true;
    }
    /// The solve is done. @param seconds  Spent, with what followed the last another().
    void finished(double seconds) noexcept { finish_ = seconds - last_.seconds; }

    [[nodiscard]] DegradedBy cause() const noexcept { return cause_; }
    [[nodiscard]] double foreseen() const noexcept { return foreseen_; }  ///< [s]

  private:
    bool refuse(DegradedBy cause, double foreseen) noexcept {
        cause_ = cause;
        foreseen_ = foreseen;
        return false;
    }

    Limits limits_;
    double finish_ = 0.0;  ///< Time that ending the solve takes [s].
    Spent last_;
    DegradedBy cause_ = DegradedBy::nothing;
    double foreseen_ = 0.0;
};

}  // namespace hawser::stepper
