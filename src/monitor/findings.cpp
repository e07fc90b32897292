// SPDX-License-Identifier: Apache-2.0
/// Findings of each monitor.
#include "monitor/findings.h"

#include "base/index.h"
#include "context/context.h"
#include "context/copies.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hawser::monitor {
namespace {

/// Return the interaction that a row belongs to.
std::int32_t owner_of(const context::Model& model, std::int32_t row) noexcept {
    const auto& begin = model.interactions.row_begin;
    const auto end = begin.begin() + context::interaction_count(model);
    return static_cast<std::int32_t>(std::upper_bound(begin.begin(), end, row) - begin.begin()) - 1;
}

/// Return the relative error of a step: the larger of its momentum residual and its residual of the
/// contact law. It is 0 for other contact methods and for steps that omitted work of the solver.
double certificate(const context::Model& model, const StepStats& stats) noexcept {
    // Other methods, and steps with a reduced budget, have no certificate.
    if (model.def.nonsmooth != Nonsmooth::newton || stats.degradation.of_solve()) return 0.0;
    return std::max(stats.natural_map, stats.momentum_residual);
}

Finding finding(double value, Limit by, double time) noexcept {
    return {.value = value,
            .doubtful = value / by.doubtful,
            .wrong = value / by.wrong,
            .time = time,
            .interaction = {},
            .body = {}};
}

/// Write the interaction of a row and the violation of this row into a finding. @param row  −1:
/// none.
void name_row(const context::Model& model, std::int32_t row, Finding& out) noexcept {
    if (row < 0) return;
    out.value = std::fabs(model.interactions.g[at(row)]);
    out.interaction = model.interactions.id(owner_of(model, row));
}

/// Return the motor that drives the coordinate of a range against its end with most of the force of
/// this end, −1 if there is none.
std::int32_t motor_pushing_into_end(const context::Model& model, std::int32_t range) noexcept {
    const model::Interactions& in = model.interactions;
    const auto ends = [&](std::int32_t id) {
        const std::int32_t* body = &in.body[at(kMaxInteractionBodies * id)];
        return std::minmax(body[0], body[1]);
    };
    const auto impulse = [&](std::int32_t id) {
        return std::fabs(in.lambda[at(in.row_begin[at(id)])]);
    };
    constexpr double kMinMotorFraction = 0.5;
    std::int32_t found = -1;
    for (const std::int32_t id : in.motors) {
        if (in.bodies[at(id)] != in.bodies[at(range)] || ends(id) != ends(range)) continue;
        const double most = found < 0 ? kMinMotorFraction * impulse(range) : impulse(found);
        if (impulse(id) > most) found = id;
    }
    return found;
}

/// Return the minimum of `now` and the stored samples, and store `now` in place of the oldest one.
template <std::size_t N>
double lasting(double now, std::array<double, N>& before) noexcept {
    const double least = std::min(now, *std::min_element(before.begin(), before.end()));
    std::copy_backward(before.begin(), before.end() - 1, before.end());
    before[0] = now;
    return least;
}

/// Return the smallest rise of energy in the present interval of 0.1 s and the two intervals
/// before. They cover 0.2 to 0.3 s.
double lasting_rise(double now, double time, context::MonitorState& memory) noexcept {
    constexpr double kRiseInterval = 0.1;
    std::array<double, 3>& least = memory.lasting_rise;
    memory.held_time += time;
    if (memory.held_time >= kRiseInterval) {
        least = {now, least[0], least[1]};
        memory.held_time = 0.0;
    }
    least[0] = std::min(least[0], now);
    return *std::min_element(least.begin(), least.end());
}

}  // namespace

context::Works works(const context::State& state) noexcept {
    return {state.ledger.work + state.loads.work,
            state.ledger.drive,
            state.ledger.drag,
            state.ledger.friction,
            state.ledger.contact,
            state.ledger.damped,
            state.ledger.edited.given,
            state.ledger.edited.strained};
}

Finding energy_finding(const context::Model& model, const context::State& state,
                       const context::MonitorPart& p, context::MonitorState& memory,
                       double time) noexcept {
    const Unexplained u = follow_energy(p, works(state), time, memory);
    const double nothing =
        std::max(limit::kNothing * (p.kinetic + p.elastic), state.monitor.nothing);
    const auto fraction = [nothing](double energy, double of) {
        return energy <= nothing ? 0.0 : energy / of;
    };
    const double exchanged = p.kinetic + memory.exchanged, counted = p.kinetic + memory.counted;
    const context::ByAccount<Variation>&now = u.now, &mean = u.mean;
    // Each balance has other momentary changes: at the midpoint between two poses, and at the
    // earlier pose. The latter is half a step away if the last sample is one step old.
    const bool close = time < 1.5 * model.def.step;
    const double posed = close ? u.posed : std::max(now[context::kAtPoses].rise, u.posed);
    const double created =
        std::min({now[context::kBetween].rise, now[context::kByForce].rise, posed});
    const double stays = std::min({created, memory.risen[0], memory.risen[1]});
    memory.risen = {created, memory.risen[0]};
    const double smallest_mean_rise = std::min(
        {mean[context::kBetween].rise, mean[context::kByForce].rise, mean[context::kAtPoses].rise});
    // The energy of lines by their lengths belongs to the state, independent of their forces. It
    // has to last, above a level that lasted. An impact on a stop stores energy there that returns
    // within a few steps.
    const double by_length =
        lasting_rise(std::min(u.lasting[context::kBetween].rise, u.lasting[context::kAtPoses].rise),
                     time, memory);
    const double hidden = std::max(now[context::kUnexplained].rise, now[context::kWithGiven].rise);
    // Use a level that lasted: the energy of an element by its length disappears after some steps.
    const double lost =
        std::min(now[context::kUnexplained].fall, u.lasting[context::kUnexplained].fall);
    Finding out;
    const double by_created = fraction(stays, exchanged) / limit::kCreated.doubtful,
                 by_held = fraction(by_length, exchanged) / limit::kHeld.doubtful,
                 by_hidden = fraction(hidden, counted) / limit::kHidden.doubtful,
                 gained = std::max({by_created, by_held, by_hidden});
    const double fell = fraction(lost, counted) / limit::kLost.doubtful;
    // Report the balance that is nearest to its limit.
    out.value = gained < fell         ? -lost
                : by_hidden == gained ? hidden
                : by_held == gained   ? by_length
                                      : created;
    out.doubtful = std::max(gained, fell);
    out.wrong = std::max(
        {fraction(smallest_mean_rise, exchanged) / limit::kCreated.wrong,
         fraction(by_length, exchanged) / limit::kHeld.wrong,
         fraction(std::max(mean[context::kUnexplained].rise, mean[context::kWithGiven].rise),
                  counted) /
             limit::kHidden.wrong,
         fraction(mean[context::kUnexplained].fall, counted) / limit::kLost.wrong});
    // A split is approximate by choice; its errors of momentum and forces are reported separately.
    if (context::has_cuts(model)) out.wrong = 0.0;
    if (!std::isfinite(now[context::kUnexplained].rise)) out.doubtful = out.wrong = HUGE_VAL;
    out.time = state.time;
    return out;
}

Finding open_finding(const context::Model& model, const context::State& state,
                     const context::MonitorPart& p, context::MonitorState& memory,
                     double time) noexcept {
    memory.open_start *= std::exp(-time / (limit::kSettled * model.def.step));
    Finding out = finding(p.open * limit::kOpen.doubtful, limit::kOpen, state.time);
    // A joint that the scene opened may close without a failure; that it was open is reported.
    const double open = std::max(0.0, p.open - memory.open_start);
    out.wrong = open * limit::kOpen.doubtful / limit::kOpen.wrong;
    name_row(model, p.open_row, out);
    return out;
}

Finding range_finding(const context::Model& model, const context::State& state,
                      const context::MonitorPart& p, context::MonitorState& memory) noexcept {
    Finding out =
        finding(lasting(p.beyond, memory.beyond) * limit::kOpen.doubtful, limit::kOpen, state.time);
    name_row(model, p.beyond_row, out);
    if (p.beyond_row < 0) return out;
    const std::int32_t motor = motor_pushing_into_end(model, owner_of(model, p.beyond_row));
    if (motor >= 0) out.interaction = model.interactions.id(motor);
    return out;
}

Finding depth_finding(const context::Model& model, const context::State& state,
                      const context::MonitorPart& p, context::MonitorState& memory) noexcept {
    Finding out = finding(lasting(p.deep, memory.deep), limit::kDeep, state.time);
    if (p.deep_contact < 0) return out;
    const collide::Contact& c = state.contacts.contacts[at(p.deep_contact)];
    const std::vector<collide::Shape>& shapes = model.collider.shapes();
    const collide::Shape &one = shapes[at(c.shape[0])], &other = shapes[at(c.shape[1])];
    out.value = -c.gap;
    out.body = model.bodies.id((one.thickness <= other.thickness ? one : other).body[0]);
    return out;
}

Finding solved_finding(const context::StepContext& ctx, context::MonitorState& state,
                       double time) noexcept {
    const double residual = certificate(ctx.model, ctx.work.stats);
    state.unsolved = residual > limit::kCertificate.doubtful ? state.unsolved + time : 0.0;
    const bool counts = state.unsolved >= limit::kSustained;
    return finding(counts ? residual : 0.0, limit::kCertificate, ctx.state.time);
}

Finding stretch_finding(const context::Model& model, const context::State& state,
                        const context::MonitorPart& p, context::MonitorState& memory) noexcept {
    Finding out = finding(lasting(p.stretch, memory.stretched), limit::kCable, state.time);
    out.interaction = model.interactions.id(p.stretch_id);
    return out;
}

Finding turn_finding(const context::Model& model, const context::State& state,
                     const context::MonitorPart& p) noexcept {
    Finding out =
        finding(model.def.step * std::sqrt(std::max(p.turn, p.twist)), limit::kTurn, state.time);
    if (p.turn >= p.twist)
        out.body = model.bodies.id(p.turn_body);
    else
        out.interaction = model.interactions.id(p.twist_id);
    return out;
}

}  // namespace hawser::monitor
