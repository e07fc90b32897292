// SPDX-License-Identifier: Apache-2.0
#include "budget/deadline.h"

#include <algorithm>
#include <cmath>

namespace hawser::budget {

void Rate::learn(double sample) noexcept {
    if (!(sample >= 0.0) || !std::isfinite(sample)) return;
    samples_ = std::min(samples_ + 1, kSettled);
    if (samples_ == 1) {
        mean_ = sample;
        deviation_ = 0.5 * sample;  // initial value of Jacobson's estimator
        return;
    }
    constexpr double kOutlier = 4.0;
    // A mean of 0 gives no prediction and would stay 0.
    const double x = mean_ > 0.0 ? std::clamp(sample, mean_ / kOutlier, mean_ * kOutlier) : sample;
    deviation_ += 0.25 * (std::fabs(x - mean_) - deviation_);
    mean_ += 0.125 * (x - mean_);
}

void Rate::relax(double least) noexcept {
    if (!known() || high() <= least) return;
    constexpr double kStep = 0.99;
    mean_ *= kStep;
    deviation_ *= kStep;
}

void Deadline::refused() noexcept { rate_[kNext].relax(kMinimum * rate_[kFirst].high()); }

void Deadline::learn(const Load& load, const Laps& laps) noexcept {
    if (load.rows <= 0.0 || load.matrix <= 0.0) return;
    if (laps.iterations < 1) {
        if (laps.analysed) return;
        rate_[kStart].learn(laps.start / load.rows);
        rate_[kPlain].learn((laps.end - laps.start) / load.matrix);
        return;
    }
    rate_[kFinish].learn((laps.end - laps.last) / load.matrix);
    if (laps.analysed) return;
    rate_[kStart].learn(laps.start / load.rows);
    rate_[kFirst].learn((laps.first - laps.start) / load.matrix);
    if (laps.iterations > 1)
        rate_[kNext].learn((laps.last - laps.first) / (laps.iterations - 1) / load.matrix);
}

double Deadline::predict_next(const Load& load) const noexcept {
    return load.matrix * (rate_[kNext].known()    ? rate_[kNext].high()
                          : rate_[kFirst].known() ? kGuess * rate_[kFirst].high()
                                                  : kGuess * rate_[kPlain].high());
}

double Deadline::predict(const Load& load, int iterations) const noexcept {
    const double one =
        rate_[kFirst].known() ? rate_[kFirst].high() + rate_[kFinish].high() : rate_[kPlain].high();
    return predict_start(load) + one * load.matrix + (iterations - 1) * predict_next(load);
}

int Deadline::iterations_by(double seconds, const Load& load) const noexcept {
    constexpr int kMaximum = 1000;  // as in WorldDef::contact_iterations
    const double one = predict(load, 1), each = predict_next(load);
    if (!(each > 0.0)) return kMaximum;
    const double more = std::floor((seconds - one) / each);
    return 1 + static_cast<int>(std::clamp(more, 0.0, kMaximum - 1.0));
}

}  // namespace hawser::budget
