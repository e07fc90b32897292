// SPDX-License-Identifier: Apache-2.0
#include "budget/deadline.h"

#include <algorithm>
#include <cmath>

namespace hawser::budget {

void Rate::add_sample(double sample) noexcept {
    if (!(sample >= 0.0) || !std::isfinite(sample)) return;
    samples_ = std::min(samples_ + 1, kSettledSamples);
    if (samples_ == 1) {
        mean_ = sample;
        deviation_ = 0.5 * sample;  // initial value of Jacobson's estimator
        return;
    }
    constexpr double kMaxSampleRatio = 4.0;
    // A mean of 0 gives no prediction and would stay 0.
    const double x =
        mean_ > 0.0 ? std::clamp(sample, mean_ / kMaxSampleRatio, mean_ * kMaxSampleRatio) : sample;
    deviation_ += 0.25 * (std::fabs(x - mean_) - deviation_);
    mean_ += 0.125 * (x - mean_);
}

void Rate::lower_estimate(double least) noexcept {
    if (!known() || upper_estimate() <= least) return;
    constexpr double kMeanDecay = 0.99;
    mean_ *= kMeanDecay;
    deviation_ *= kMeanDecay;
}

void Deadline::record_refusal() noexcept {
    rate_[kNext].lower_estimate(kMinRate * rate_[kFirst].upper_estimate());
}

void Deadline::add_sample(const Load& load, const Laps& laps) noexcept {
    if (load.rows <= 0.0 || load.matrix <= 0.0) return;
    if (laps.iterations < 1) {
        if (laps.analysed) return;
        rate_[kStart].add_sample(laps.start / load.rows);
        rate_[kPlain].add_sample((laps.end - laps.start) / load.matrix);
        return;
    }
    rate_[kFinish].add_sample((laps.end - laps.last) / load.matrix);
    if (laps.analysed) return;
    rate_[kStart].add_sample(laps.start / load.rows);
    rate_[kFirst].add_sample((laps.first - laps.start) / load.matrix);
    if (laps.iterations > 1)
        rate_[kNext].add_sample((laps.last - laps.first) / (laps.iterations - 1) / load.matrix);
}

double Deadline::predict_next(const Load& load) const noexcept {
    return load.matrix * (rate_[kNext].known()    ? rate_[kNext].upper_estimate()
                          : rate_[kFirst].known() ? kInitialRate * rate_[kFirst].upper_estimate()
                                                  : kInitialRate * rate_[kPlain].upper_estimate());
}

double Deadline::predict(const Load& load, int iterations) const noexcept {
    const double one = rate_[kFirst].known()
                           ? rate_[kFirst].upper_estimate() + rate_[kFinish].upper_estimate()
                           : rate_[kPlain].upper_estimate();
    return predict_start(load) + one * load.matrix + (iterations - 1) * predict_next(load);
}

int Deadline::iterations_by(double seconds, const Load& load) const noexcept {
    constexpr int kMaxIterations = 1000;  // as in WorldDef::contact_iterations
    const double one = predict(load, 1), each = predict_next(load);
    if (!(each > 0.0)) return kMaxIterations;
    const double more = std::floor((seconds - one) / each);
    return 1 + static_cast<int>(std::clamp(more, 0.0, kMaxIterations - 1.0));
}

}  // namespace hawser::budget
