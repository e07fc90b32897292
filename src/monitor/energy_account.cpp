// SPDX-License-Identifier: Apache-2.0
/// Energy balance of the monitors: sums, their extrema, exchanged energy.
#include "monitor/energy_account.h"

#include "context/monitor_data.h"

#include <algorithm>
#include <cmath>

namespace hawser::monitor {
namespace {

/// Return the change of energy that no recorded work explains, for each energy balance [J].
context::ByAccount<double> unexplained(const context::MonitorPart& p, const context::Works& w,
                                       double given) noexcept {
    const double left = p.kinetic + p.potential + p.elastic - w[context::kForces] -
                        w[context::kDrives] + w[context::kDrag] + w[context::kFriction] +
                        w[context::kContacts] + w[context::kRows] - w[context::kGiven] -
                        w[context::kStrained];
    const double moving = p.kinetic + p.potential + p.elastic;
    const double between = left - w[context::kDrag] - w[context::kRows] + w[context::kStrained];
    return {left, left + given, between - p.elastic + p.by_length, between - moving + p.at_pose,
            between - p.elastic + p.by_force};
}

Variation follow(context::DecayingExtremes& tide, double now, double forgotten) noexcept {
    tide.least = std::min(now, tide.least + forgotten * (now - tide.least));
    tide.most = std::max(now, tide.most + forgotten * (now - tide.most));
    return {now - tide.least, tide.most - now};
}

void set(context::MonitorState& state, std::size_t i, double now) noexcept {
    state.mean[i] = now;
    state.now_extremes[i] = state.mean_extremes[i] = {now, now};
}

/// Time for which rows may store absorbed energy, in an overlap or in an element that tightens [s].
constexpr double kHeldFor = 1.0;

/// Add to `state.given` the energy that rows returned beyond the energy that they absorbed
/// recently. Rows may store absorbed energy for about kHeldFor.
/// @param taken  Energy that the rows absorbed in this sample; negative: returned [J].
void count_returned_energy(double taken, double time, context::MonitorState& state) noexcept {
    state.held = (state.held + std::max(0.0, taken)) * std::exp(-time / kHeldFor);
    const double back = std::min(state.held, std::max(0.0, -taken));
    state.held -= back;
    state.given += std::max(0.0, -taken) - back;
}

void keep(const context::MonitorPart& p, const context::Works& w,
          context::MonitorState& state) noexcept {
    state.kinetic = p.kinetic;
    state.potential = p.potential;
    state.elastic = p.elastic;
    state.by_length = p.by_length;
    state.by_force = p.by_force;
    state.work = w;
}

}  // namespace

void begin_energy(const context::MonitorPart& p, const context::Works& w,
                  context::MonitorState& state) noexcept {
    const context::ByAccount<double> now = unexplained(p, w, state.given);
    for (std::size_t i = 0; i < now.size(); ++i) set(state, i, now[i]);
    state.exchanged = state.counted = state.age = 0.0;
    state.begun = 1;
    keep(p, w, state);
}

Unexplained follow_energy(const context::MonitorPart& p, const context::Works& w, double time,
                          context::MonitorState& state) noexcept {
    if (state.begun == 0) begin_energy(p, w, state);
    count_returned_energy(w[context::kRows] - state.work[context::kRows], time, state);
    double moved = std::fabs(p.kinetic - state.kinetic) + std::fabs(p.potential - state.potential);
    for (std::size_t i = 0; i < context::kRows; ++i) moved += std::fabs(w[i] - state.work[i]);
    // An unresolved spring stores energy by its length that its force never exerts; rows absorb and
    // return it. The exchange at its source is counted.
    const double by_rows = std::fabs(p.elastic - state.elastic);
    const double sprung = std::min({by_rows, std::fabs(p.by_length - state.by_length),
                                    std::fabs(p.by_force - state.by_force)});
    const double row_work = std::fabs(w[context::kRows] - state.work[context::kRows]);
    // The sums do not decay before kMemory has passed.
    state.age += time;
    const double forgotten =
        state.age <= limit::kMemory ? 0.0 : std::min(1.0, time / limit::kMemory);
    state.exchanged += 0.5 * (moved + sprung) - forgotten * state.exchanged;
    state.counted += 0.5 * (moved + by_rows + row_work) - forgotten * state.counted;
    const context::ByAccount<double> now = unexplained(p, w, state.given);
    // Works begin half a step before the start: half of them belongs to earlier motion.
    const bool first = state.begun++ == 1;
    context::ByAccount<double> early{};
    for (std::size_t i = 0; i < w.size(); ++i)
        for (std::size_t k = 0; k < early.size(); ++k)
            if (k < context::kBetween ||
                (i != context::kDrag && i != context::kRows && i != context::kStrained))
                early[k] += 0.5 * std::fabs(w[i] - state.work[i]);
    Unexplained out;
    for (std::size_t i = 0; i < now.size(); ++i) {
        // Rows that close gaps of the initial state add energy that the scene causes.
        if (i == context::kWithGiven && state.open_start > 1.0) set(state, i, now[i]);
        if (first) set(state, i, std::min(now[i], state.mean[i] + early[i]));
        // After they have closed, mechanical energy must be balanced again.
        constexpr std::int64_t kClosingSteps = 3;  // steps
        if (i >= context::kBetween && state.open_start > 1.0 && state.begun <= kClosingSteps + 1)
            continue;
        state.mean[i] += (1.0 - std::exp(-time / limit::kMean)) * (now[i] - state.mean[i]);
        out.now[i] = follow(state.now_extremes[i], now[i], forgotten);
        out.mean[i] = follow(state.mean_extremes[i], state.mean[i], forgotten);
        const context::DecayingExtremes& level = state.mean_extremes[i];
        out.lasting[i] = {std::max(0.0, now[i] - level.least), std::max(0.0, level.most - now[i])};
    }
    // The first sample has no earlier value.
    out.posed = first ? out.now[context::kBetween].rise : state.posed;
    state.posed = out.now[context::kAtPoses].rise;
    keep(p, w, state);
    return out;
}

}  // namespace hawser::monitor
