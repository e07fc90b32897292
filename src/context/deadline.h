// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file deadline.h
/// How long the solver will take, from the work ahead: what is left out of a step is decided before
/// it begins (docs/methods.md, 11).
///
/// A step's solver runs through stages. Each has a measure of work that is known before the step
/// (contact points are: collision comes first), and a rate that measured steps teach:
/// ```
///     stage    from … to                                             work
///     start    solver begins … right-hand side is there              rows
///     first    … first Newton iteration is done                      matrix
///     next     each further iteration                                matrix
///     finish   … impulses projected, residuals refined and measured  matrix
///     plain    all after start, of a step without contacts           matrix
/// ```
/// A rate is taken as V. Jacobson's estimator of round trips has it ("Congestion avoidance and
/// control", 1988): the mean m and the mean deviation d of samples x follow with gains 1/8 and 1/4,
/// and m + 2d is what is reckoned with; a sample counts as at most four times, and at least a
/// quarter, of the mean, so that a step in which the operating system took the caches away does not
/// rule the next hundred. Stages of a step with an analysis teach nothing but `finish`: the first
/// touch of two bodies costs what no later step costs.
///
/// Further iterations cost from a handful of substitutions to a factorisation. Nothing is learned
/// of them while they do not seem to fit; in a step that ends without one its rate is therefore
/// taken 1 % lower, down to a quarter of the first one's, until one is tried.
///
/// Limits: rates are learned while the program runs and are no part of the state. What they decide
/// is recorded (Degradation).

#include <array>

namespace hawser::stepper {

/// Work of a step's solver.
struct Load {
    double rows = 0.0;    ///< Rows and velocities; a contact point is worth twelve.
    double matrix = 0.0;  ///< matrix_work(), and kRowWork for each of the rows [flop].
};
/// What an iteration sweeps over a row for [flop].
inline constexpr double kRowWork = 40.0;
/// A factorisation and its substitutions, which go through L some four times [flop].
[[nodiscard]] inline double matrix_work(double flops, double nnz) noexcept {
    return flops + 16.0 * nnz;
}

/// CPU time of the solver in a step, since it began [s].
struct Laps {
    double start = 0.0;  ///< When the right-hand side was there.
    double first = 0.0;  ///< When the first iteration was done.
    double last = 0.0;   ///< When the last one was.
    double end = 0.0;
    int iterations = 0;
    bool analysed = false;  ///< The system was analysed within these.
};

/// Time per work, as samples teach it.
class Rate {
  public:
    /// After so many the first guess of the deviation has gone: (3/4)^16 = 1 % is left of it.
    static constexpr int kSettled = 16;
    void learn(double sample) noexcept;
    [[nodiscard]] int samples() const noexcept { return samples_; }
    [[nodiscard]] bool known() const noexcept { return samples_ > 0; }
    [[nodiscard]] double high() const noexcept { return mean_ + 2.0 * deviation_; }
    /// A little lower, for want of samples.
    void relax(double least) noexcept;

  private:
    int samples_ = 0;  ///< At most kSettled.
    double mean_ = 0.0, deviation_ = 0.0;
};

class Deadline {
  public:
    void learn(const Load& load, const Laps& laps) noexcept;
    /// Whether a step has been seen.
    [[nodiscard]] bool knows() const noexcept {
        return rate_[kFirst].known() || rate_[kPlain].known();
    }
    /// Whether enough steps have been seen to cut by it.
    [[nodiscard]] bool settled() const noexcept {
        return rate_[kFinish].samples() >= Rate::kSettled ||
               rate_[kPlain].samples() >= Rate::kSettled;
    }
    /// CPU time of the solver with so many iterations, at least 1 [s].
    [[nodiscard]] double predict(const Load& load, int iterations) const noexcept;
    /// CPU time of a further iteration [s].
    [[nodiscard]] double predict_next(const Load& load) const noexcept;
    /// Another iteration did not seem to fit.
    void refused() noexcept;
    /// The stage `start` of it [s].
    [[nodiscard]] double predict_start(const Load& load) const noexcept {
        return rate_[kStart].high() * load.rows;
    }
    /// Most iterations, at least 1, with which it ends by then.
    [[nodiscard]] int iterations_by(double seconds, const Load& load) const noexcept;

  private:
    enum { kStart, kFirst, kNext, kFinish, kPlain, kStages };
    /// Of the first iteration's time, before one further has been seen; and at least.
    static constexpr double kGuess = 0.5, kLeast = 0.25;
    std::array<Rate, kStages> rate_;
};

}  // namespace hawser::stepper
