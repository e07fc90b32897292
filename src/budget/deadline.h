// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file deadline.h
/// Prediction of the solver time from the work of a step. Degradation is decided before the step
/// begins (docs/theory/deadlines.md).
///
/// The solver of a step has stages. The work of each is known before the step (contact points are,
/// because collision comes first). The rate of each follows from measured steps:
/// ```
///     stage    from … to                                             work
///     start    solver begins … right-hand side complete              rows
///     first    … first Newton iteration complete                     matrix
///     next     each further iteration                                matrix
///     finish   … impulses projected, residuals refined and measured  matrix
///     plain    all after start, of a step without contacts           matrix
/// ```
/// Rates use V. Jacobson's estimator of round trips ("Congestion avoidance and control", 1988). The
/// mean m and the mean deviation d of samples x are updated with gains 1/8 and 1/4; the estimate is
/// m + 2d. A sample is limited to between a quarter and four times the mean. A step in which the
/// operating system displaced the caches thus does not dominate the next hundred. A step with an
/// analysis is used for `finish` only: the first contact of two bodies has costs that later steps
/// do not have.
///
/// Further iterations cost between a few substitutions and a factorisation. Their rate is not
/// measured while they do not seem to fit. Therefore each step that ends without one lowers the
/// rate by 1 %, until one is tried. The minimum is a quarter of the rate of the first iteration.
///
/// Limits: rates are measured at run time and are not part of the state. Their decisions are
/// recorded (Degradation).

#include <array>

namespace hawser::budget {

/// Work of the solver in a step.
struct Load {
    double rows = 0.0;    ///< Rows and velocities; a contact point counts twelve.
    double matrix = 0.0;  ///< matrix_work(), plus kRowWork for each row [flop].
};
/// Work of the sweeps of an iteration per row [flop].
inline constexpr double kRowWork = 40.0;
/// Return the work of a factorisation and its substitutions, which read L about four times [flop].
[[nodiscard]] inline double matrix_work(double flops, double nnz) noexcept {
    return flops + 16.0 * nnz;
}

/// CPU time of the solver in a step, since its begin [s].
struct Laps {
    double start = 0.0;  ///< Time at which the right-hand side was complete.
    double first = 0.0;  ///< Time at which the first iteration was complete.
    double last = 0.0;   ///< Time at which the last iteration was complete.
    double end = 0.0;
    int iterations = 0;
    bool analysed = false;  ///< True if the system was analysed in the step.
};

/// Time per work, estimated from samples.
class Rate {
  public:
    /// Number of samples after which the initial deviation has decayed to (3/4)^16 = 1 %.
    static constexpr int kSettledSamples = 16;
    void add_sample(double sample) noexcept;
    [[nodiscard]] int samples() const noexcept { return samples_; }
    [[nodiscard]] bool known() const noexcept { return samples_ > 0; }
    [[nodiscard]] double upper_estimate() const noexcept { return mean_ + 2.0 * deviation_; }
    /// Lower the estimate by 1 % if it exceeds `least`. Call in a step without a new sample.
    void lower_estimate(double least) noexcept;

  private:
    int samples_ = 0;  ///< Number of samples, at most kSettledSamples.
    double mean_ = 0.0, deviation_ = 0.0;
};

class Deadline {
  public:
    void add_sample(const Load& load, const Laps& laps) noexcept;
    /// True if a step has been measured.
    [[nodiscard]] bool has_samples() const noexcept {
        return rate_[kFirst].known() || rate_[kPlain].known();
    }
    /// True if enough steps have been measured to decide by the rates.
    [[nodiscard]] bool has_enough_samples() const noexcept {
        return rate_[kFinish].samples() >= Rate::kSettledSamples ||
               rate_[kPlain].samples() >= Rate::kSettledSamples;
    }
    /// Predict the CPU time of the solver with `iterations` iterations, at least 1 [s].
    [[nodiscard]] double predict(const Load& load, int iterations) const noexcept;
    /// Predict the CPU time of a further iteration [s].
    [[nodiscard]] double predict_next(const Load& load) const noexcept;
    /// Record that an iteration was refused because its predicted time exceeded the limit.
    void record_refusal() noexcept;
    /// Predict the time of the stage `start` [s].
    [[nodiscard]] double predict_start(const Load& load) const noexcept {
        return rate_[kStart].upper_estimate() * load.rows;
    }
    /// Return the maximum number of iterations, at least 1, with which the solver ends in time.
    [[nodiscard]] int iterations_by(double seconds, const Load& load) const noexcept;

  private:
    enum { kStart, kFirst, kNext, kFinish, kPlain, kStages };
    /// Rate of further iterations relative to the first one: initial value, and minimum.
    static constexpr double kInitialRate = 0.5, kMinRate = 0.25;
    std::array<Rate, kStages> rate_;
};

}  // namespace hawser::budget
