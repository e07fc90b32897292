// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file budget.h
/// Whether a solve that runs in iterations can afford another one.
///
/// The next iteration is taken to cost what the last one did, and what follows the last iteration
/// (projection, refinement) what it did in the step before. Time differs from run to run; so that
/// a run can be repeated, the number of iterations it allowed is what gets recorded and imposed.

namespace hawser::stepper {

/// Spent since the solve began.
struct Spent {
    double seconds = 0.0;  ///< CPU time of the slowest thread.
    double work = 0.0;     ///< [flop]
};

class Budget {
  public:
    /// @param seconds,work  Limits, 0: none. @param iterations  Imposed instead of these, 0: none.
    void begin(double seconds, double work, int iterations) noexcept {
        seconds_ = seconds;
        work_ = work;
        iterations_ = iterations;
        last_ = {};
    }
    /// No limits until begin().
    void end() noexcept { begin(0.0, 0.0, 0); }
    [[nodiscard]] bool needs_time() const noexcept { return iterations_ == 0 && seconds_ > 0.0; }

    /// After each iteration. @param iterations  Made so far.
    [[nodiscard]] bool another(const Spent& spent, int iterations) noexcept {
        if (iterations_ > 0) return iterations < iterations_;
        const Spent next{2.0 * spent.seconds - last_.seconds, 2.0 * spent.work - last_.work};
        last_ = spent;
        return (seconds_ <= 0.0 || next.seconds + finish_ <= seconds_) &&
               (work_ <= 0.0 || next.work <= work_);
    }
    /// The solve is done. @param seconds  Spent, with what followed the last another().
    void finished(double seconds) noexcept { finish_ = seconds - last_.seconds; }

  private:
    double seconds_ = 0.0, work_ = 0.0;
    int iterations_ = 0;
    double finish_ = 0.0;  ///< Time that ending the solve takes [s].
    Spent last_;
};

}  // namespace hawser::stepper
