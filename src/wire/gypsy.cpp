// SPDX-License-Identifier: Apache-2.0
#include "wire/gypsy.h"

#include "wire/bounds.h"

#include <algorithm>
#include <cmath>

namespace hawser::wire {
namespace {

constexpr double kInPocket = 1e-6;   ///< Fraction of a pocket within which a link is seated.
constexpr double kStepsAhead = 2.0;  ///< Steps ahead in which the next pocket is searched.

}  // namespace

double GypsyChain::sample(double separation, double rate, double torque, double pull) noexcept {
    jumped_ = wheel_.radius * (separation - wheel_.zero);
    gained_ = wheel_.radius * rate - rate_;
    rate_ = wheel_.radius * rate;
    grip_ = -torque / wheel_.radius;
    pull_ = pull;
    caught_ = 0;
    pocket_distance_ = jumped_ - pocket_ * wheel_.pocket;
    double load = 0.0;
    if (jumping_ == 0) {
        const bool gave_way = std::abs(grip_) >= wheel_.jump_load * (1.0 - kAtBoundTolerance) &&
                              std::abs(pocket_distance_) > kInPocket * wheel_.pocket &&
                              pocket_distance_ * grip_ > 0.0;
        if (!gave_way) return 0.0;
        jumping_ = 1;
        count_ += 1.0;
        if (pocket_distance_ < 0.0) pocket_ -= 1.0;
        load = std::abs(grip_);
    } else if (pocket_distance_ >= (1.0 - kInPocket) * wheel_.pocket ||
               pocket_distance_ <= kInPocket * wheel_.pocket) {
        const bool out = pocket_distance_ > 0.5 * wheel_.pocket,
                   stays = std::abs(pull_) <= wheel_.jump_load;
        if (out) pocket_ += 1.0;
        if (stays) {
            jumping_ = 0;
            caught_ = 1;
        } else {
            if (!out) pocket_ -= 1.0;
            count_ += 1.0;
            load = std::abs(pull_);
        }
    }
    pocket_distance_ = jumped_ - pocket_ * wheel_.pocket;
    return load;
}

GripOrder GypsyChain::order(double h) const noexcept {
    const double r = wheel_.radius;
    const auto most = [&](double force) { return std::min(force * r, kUnbounded); };
    if (jumping_ == 0) {
        const double bound = caught_ != 0 ? kUnbounded : most(wheel_.jump_load);
        // Return to the middle of the pocket, against rounding and compliance.
        return {-pocket_distance_ / (h * r), -bound, bound};
    }
    const double rubs = most(wheel_.jump_friction);
    const double ahead = pocket_distance_ + kStepsAhead * h * (rate_ + gained_);
    if (std::abs(pull_) <= wheel_.jump_load) {
        if (rate_ > 0.0 && ahead >= wheel_.pocket)
            return {(wheel_.pocket - pocket_distance_) / (h * r), -kUnbounded, -rubs};
        if (rate_ < 0.0 && ahead <= 0.0) return {-pocket_distance_ / (h * r), rubs, kUnbounded};
    }
    return {0.0, -rubs, rubs};
}

void GypsyChain::visit_state(StateVisitor& v) {
    for (double* x :
         {&pocket_, &pocket_distance_, &rate_, &gained_, &pull_, &count_, &jumped_, &grip_, &tail_})
        v.visit(*x);
    for (std::int32_t* x : {&jumping_, &caught_}) v.visit(*x);
}

void GypsyChain::check_state(StateRules& rules) const {
    constexpr double kMaxPockets = 1e9;
    rules.range(pocket_, -kMaxPockets, kMaxPockets, "the pocket of the chain is out of range");
    rules.require(pocket_ == std::round(pocket_), "the pocket of the chain is no whole number");
    rules.flag(jumping_, "whether the chain jumps is no flag");
    rules.flag(caught_, "whether the chain was caught is no flag");
}

void GypsyChain::signals(SignalTable& table) {
    table.output("jumps", "1", count_);
    table.output("jumped", "m", jumped_);
    table.output("grip", "N", grip_);
    table.output("tail", "N", tail_);
}

}  // namespace hawser::wire
