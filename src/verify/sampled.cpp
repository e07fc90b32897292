// SPDX-License-Identifier: Apache-2.0
#include "verify/sampled.h"

#include <algorithm>

namespace hawser::verify {

namespace {

constexpr std::int64_t kEverySteps = 600;
constexpr std::int64_t kAfterEvents = 300;  // Least distance of sampled intervals after events.
constexpr int kWindowSteps = 3;  // The first step only provides the changes of angular velocities.

/// True if an event of this kind starts a sampled interval: events that change a world or break a
/// part. Slack and taut lines are too frequent.
bool starts_interval(const Event& event) {
    switch (event.kind) {
        case EventKind::slack:
        case EventKind::taut:
        case EventKind::input_clamped:
        case EventKind::layer:
        case EventKind::alarm:
        case EventKind::alarm_end:
        case EventKind::range:
        case EventKind::fast:
            return false;
        default:
            return true;
    }
}

}  // namespace

SampledVerifier::SampledVerifier(const World& world, std::int64_t last) : last_(last) {
    if (world.settings().coupling != Coupling::exact ||
        world.settings().on_diverged != OnDiverged::stop)
        return;
    verifier_.emplace(world, Checks{.strict = false, .sea = false, .states = false});
    interval_begin_ = world.step_count() - kEverySteps;
}

void SampledVerifier::before_step(const World& world) {
    if (!verifier_) return;
    if (steps_left_ == 0) {
        const std::int64_t since = world.step_count() - interval_begin_;
        const bool ends = world.step_count() == last_ - kWindowSteps;
        if (since < kEverySteps && !ends && !(events_happened_ && since >= kAfterEvents)) return;
        verifier_->begin_at(world);
        interval_begin_ = world.step_count();
        steps_left_ = kWindowSteps;
        events_happened_ = false;
    }
    verifier_->before_step(world);
}

void SampledVerifier::after_step(const World& world, std::span<const Event> events) {
    events_happened_ =
        events_happened_ || std::any_of(events.begin(), events.end(), starts_interval);
    if (steps_left_ == 0 || !verifier_) return;
    --steps_left_;
    ++steps_;
    objection_ = verifier_->after_step(world);
}

}  // namespace hawser::verify
