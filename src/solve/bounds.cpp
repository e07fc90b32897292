// SPDX-License-Identifier: Apache-2.0
#include "solve/bounds.h"

#include "assembly/rows.h"
#include "base/index.h"
#include "context/newton_data.h"
#include "context/view.h"
#include "solve/capstans.h"
#include "solve/runs.h"

#include <algorithm>
#include <cmath>

namespace hawser::solve {
namespace {

using assembly::View;

/// True for motors whose bound depends on their speed (power limit).
bool limits_power(const model::Interactions& in, std::int32_t id) noexcept {
    return (in.flags[at(id)] & model::kMotor) != 0 && in.power[at(id)] < model::kUnbounded;
}

double stiffness_scale(const context::Model& model, std::size_t i) noexcept {
    const model::Interactions& in = model.interactions;
    return model.system.bounded_mobility[i] +
           in.sigma[at(in.row_begin[at(model.system.bounded[i])])];
}

/// Return the stiffness W + Σ for the rule by which a bounded row becomes active or inactive. In
/// the convex phase a fraction of W is used, as for contacts.
double switch_scale(const context::Model& model, const context::Newton& newton,
                    std::size_t i) noexcept {
    const double scale = stiffness_scale(model, i);
    return newton.convex
               ? scale - (1.0 - context::kConvexFraction) * model.system.bounded_mobility[i]
               : scale;
}

/// Return λ and the residual r = c − G v − Σλ of a bounded row at the current solution. r is 0 for
/// an active row.
context::BoundedRow present_row(const View& v, std::int32_t id) noexcept {
    const std::int32_t row = v.row_begin[id];
    const double lambda = v.lambda[row];
    const double r =
        v.active[id] != 0.0 ? 0.0 : v.c[row] - assembly::row_speed(v, id) - v.sigma[row] * lambda;
    return {lambda, r};
}

/// Let the row of an inactive range refer to the end that the present velocities approach.
/// @return the change of its right-hand side c.
double choose_end(const context::Model& model, const View& v, std::int32_t id) noexcept {
    if ((v.flags[id] & model::kRange) == 0 || v.active[id] != 0.0 || v.parted[id] != 0) return 0.0;
    const std::int32_t row = v.row_begin[id];
    const double carried = (v.flags[id] & model::kCarried) != 0
                               ? model.interactions.row_state(id, model.bodies).carried[0]
                               : 0.0;
    const double moved = v.h * (assembly::row_speed(v, id) + carried);
    const bool upper = v.high[id] - moved < v.low[id] + moved;
    if (upper == (v.upper[id] != 0)) return 0.0;
    const double left = upper ? v.high[id] : v.low[id], before = v.c[row];
    v.upper[id] = upper ? 1 : 0;
    v.c[row] =
        (left >= 0.0 ? (upper ? left : -left) : -4.0 * v.upsilon[row] * v.g[row]) / v.h - carried;
    return v.c[row] - before;
}

/// Return the end of a changed range to which an inactive row with the impulse `held` belongs. It
/// is the end with the sign of the impulse. If both ends have one sign (a winch that pulls with one
/// of two tensions), it is the nearer end.
double end_of_moved_range(const ImpulseRange& range, double held) noexcept {
    if (held == 0.0) return std::clamp(0.0, range.low, range.high);
    const bool one_sided = range.high < 0.0 || range.low > 0.0;
    const double middle = one_sided ? 0.5 * (range.low + range.high) : 0.0;
    return held < middle ? range.low : range.high;
}

context::BoundedRow along(const context::Newton& n, std::size_t i, double t) noexcept {
    const context::BoundedRow &a = n.row[i], &b = n.row_end[i];
    return {a.lambda + t * (b.lambda - a.lambda), a.r + t * (b.r - a.r)};
}

/// True for a line under tension that follows its own law, not a replacement law.
bool is_taut_line(const View& v, std::int32_t id) noexcept {
    constexpr int kOther = model::kRange | model::kMotor | model::kFriction;
    const double lambda = v.lambda[v.row_begin[id]];
    return (v.flags[id] & (model::kOneSided | kOther)) == model::kOneSided && v.active[id] != 0.0 &&
           v.parted[id] == 0 && lambda < 0.0 && lambda > -model::kUnbounded;
}

/// Status of a row, and the status that the law requires.
struct SwitchRequest {
    bool was_active, active;
    bool across;       ///< True if it moves from one end of its range to the other.
    double projected;  ///< Its impulse, clamped to the range [N s].
    [[nodiscard]] bool requests_switch() const noexcept { return active != was_active || across; }
};
SwitchRequest request_of(const context::Model& model, const context::Newton& newton, const View& v,
                         std::size_t i, const context::BoundedRow& p,
                         const ImpulseRange& range) noexcept {
    const std::int32_t id = model.system.bounded[i];
    const bool was_active = v.active[id] != 0.0;
    // An inactive row first follows its bound. Then the rule decides whether it stays
    // inactive.
    const double lambda = was_active ? p.lambda : end_of_moved_range(range, v.held[id]);
    const double y = lambda + p.r / switch_scale(model, newton, i);
    const double projected = std::clamp(y, range.low, range.high);
    const bool active = range.low < y && y < range.high;
    // A reversed motor may move from one end to the other within a step.
    const bool across = !was_active && !active && projected != lambda;
    return {was_active, active, across, projected};
}
/// True for rows that never become active or inactive: rows that are broken or replaced, and ranges
/// with equal ends.
bool never_switches(const context::Model& model, const View& v, std::int32_t id,
                    const ImpulseRange& range) noexcept {
    return v.parted[id] || model.wires.is_replaced(id) ||
           ((v.flags[id] & model::kRange) && range.low == range.high);
}

/// Return true if rounding of tensions is the only reason to switch a turning point of a run.
bool is_rounding(const context::Model& model, std::int32_t id, const SwitchRequest& wish,
                 double lambda, const ImpulseRange& range) noexcept {
    const double way = std::fabs(wish.projected - lambda), width = range.high - range.low;
    // A stop without a finite bound gives no scale.
    constexpr double kStopImpulse = 1e20;  // [N s]
    if (width > kStopImpulse) return false;
    if (way > kCapstanAtBound * width || !is_capstan(model, id)) return false;
    return wish.was_active || way <= kCapstanNoise * width ||
           way <= kCapstanRounding * largest_in_run(model, id);
}

}  // namespace

void reserve_bounds(const context::Model& model, context::Newton& newton) {
    newton.row.resize(model.system.bounded.size());
    newton.row_end.resize(model.system.bounded.size());
    const model::Interactions& in = model.interactions;
    newton.on_scalar.clear();
    for (const std::int32_t id : model.system.bounded) {
        const std::int32_t* body = &in.body[kMaxInteractionBodies * at(id)];
        newton.on_scalar.push_back(std::any_of(body, body + in.bodies[at(id)], [&](std::int32_t b) {
            return model.bodies.kind[at(b)] == BodyKind::scalar;
        }));
    }
    newton.loaded.clear();
    for (const std::int32_t id : model.system.bounded)
        if (((in.flags[at(id)] & model::kFriction) && in.load_begin[at(id)] >= 0 &&
             !is_capstan(model, id)) ||
            limits_power(in, id))
            newton.loaded.push_back(id);
    newton.follow.reserve(newton.loaded.size());
}

void hold_bounds(context::Model& model, context::Newton& newton, double time) noexcept {
    model::Interactions& in = model.interactions;
    newton.bound_time = time;
    newton.follow.restart();
    for (const std::int32_t id : model.system.bounded) {
        double& held = in.held[at(id)];
        if (held != 0.0) held = 0.0;
        if (in.active[at(id)] != 0.0 || !(in.flags[at(id)] & (model::kMotor | model::kFriction)))
            continue;
        const ImpulseRange range = impulse_range(model, newton, id);
        held = end_of_moved_range(range, in.lambda[at(in.row_begin[at(id)])]);
    }
}

void take_bounds(context::Model& model, context::Newton& newton) noexcept {
    const View v = context::row_view(model);
    for (std::size_t i = 0; i < model.system.bounded.size(); ++i) {
        newton.row[i].r += choose_end(model, v, model.system.bounded[i]);
        newton.row_end[i] = present_row(v, model.system.bounded[i]);
    }
}

void keep_bounds(context::Newton& newton, double t) noexcept {
    context::Newton& n = newton;
    if (t == 1.0) return n.row.swap(n.row_end);
    for (std::size_t i = 0; i < n.row.size(); ++i) n.row[i] = along(n, i, t);
}

double bounds_merit(const context::Model& model, const context::Newton& newton, double t) noexcept {
    double sum = 0.0;
    for (std::size_t i = 0; i < model.system.bounded.size(); ++i) {
        const ImpulseRange range = impulse_range(model, newton, model.system.bounded[i]);
        const double scale = stiffness_scale(model, i);
        const context::BoundedRow p = along(newton, i, t);
        const double e = p.lambda - std::clamp(p.lambda + p.r / scale, range.low, range.high);
        sum += scale * e * e;
    }
    return sum;
}

double bounds_slope(const context::Model& model, const context::Newton& newton, double t) noexcept {
    const View v = context::row_view(const_cast<context::Model&>(model));  // reads only
    double sum = 0.0;
    for (std::size_t i = 0; i < model.system.bounded.size(); ++i) {
        const std::int32_t id = model.system.bounded[i];
        const ImpulseRange range = impulse_range(model, newton, id);
        if (never_switches(model, v, id, range)) continue;
        const double sigma = v.sigma[v.row_begin[id]];
        const context::BoundedRow &from = newton.row[i], &to = newton.row_end[i],
                                  p = along(newton, i, t);
        // c − G v = r + Σλ. A row without compliance is at a bound or has the impulse of the
        // solution.
        const double right_side = p.r + sigma * p.lambda;
        double impulse = p.lambda;
        if (sigma > 0.0)
            impulse = std::clamp(right_side / sigma, range.low, range.high);
        else if (right_side != 0.0)
            impulse = right_side > 0.0 ? range.high : range.low;
        const double change = from.r + sigma * from.lambda - to.r - sigma * to.lambda;
        sum += (p.lambda - impulse) * change;
    }
    return sum;
}

double bounds_map(const context::Model& model, const context::Newton& newton) noexcept {
    const model::Interactions& in = model.interactions;
    double largest = 0.0;
    const auto inactive = [&](std::int32_t id) {
        return in.active[at(id)] == 0.0 && !model.system.rests(id);
    };
    for (const std::int32_t id : in.frictions) {
        if (!inactive(id)) continue;
        const double held = in.held[at(id)],
                     bound = end_of_moved_range(impulse_range(model, newton, id), held);
        if (bound == held) continue;
        largest = std::max(
            largest, std::fabs(bound - held) / std::max(std::fabs(bound), model.contact_floor));
    }
    for (const std::int32_t id : in.motors) {
        if (!limits_power(in, id) || !inactive(id) || !(newton.bound_time > 0.0)) continue;
        const double excess = power_excess(model, newton, id);
        // Below its power limit a motor exerts its full force.
        const auto is_at = [&](double bound) {
            const double end = newton.bound_time * bound;
            return std::fabs(in.held[at(id)] - end) <= 1e-12 * std::fabs(end);
        };
        const bool whole = is_at(in.low[at(id)]) || is_at(in.high[at(id)]);
        largest = std::max(largest, whole ? excess : std::fabs(excess));
    }
    return largest;
}

namespace {

/// Read the impulses of the rows whose bounds depend on other rows. Active rows get 0.
void read_dependent_impulses(const context::Model& model, const context::Newton& newton,
                             double* out) noexcept {
    for (const std::int32_t id : newton.loaded)
        *out++ = model.interactions.active[at(id)] == 0.0 ? model.interactions.held[at(id)] : 0.0;
}

/// Extrapolate bounds that change with the impulses on which they depend. The extrapolation uses
/// the effect of earlier changes in this step.
void extrapolate_bounds(context::Model& model, context::Work& work) noexcept {
    const View v = context::row_view(model);
    nonsmooth::Anderson& follow = work.newton.follow;
    read_dependent_impulses(model, work.newton, follow.image());
    const double* x = follow.next(model.contact_floor);
    for (const std::int32_t id : work.newton.loaded) {
        double& held = model.interactions.held[at(id)];
        const double solved_impulse = *x++;
        // Friction does not reverse at any load.
        if (v.active[id] != 0.0 || !(solved_impulse * held > 0.0)) continue;
        held = v.lambda[v.row_begin[id]] = solved_impulse;
        work.solve.losses_known = false;
    }
}

}  // namespace

std::int32_t switch_bounds(context::Model& model, context::Work& work, double floor,
                           std::int32_t most) noexcept {
    const View v = context::row_view(model);
    std::int32_t switch_count = 0;
    const bool follows = most > 0 && !work.newton.loaded.empty();
    const bool runs = most == kAnyRows && !model.system.capstans.empty();
    if (runs) note_runs(model);
    if (follows) read_dependent_impulses(model, work.newton, work.newton.follow.x());
    for (std::size_t i = 0; i < model.system.bounded.size(); ++i) {
        const std::int32_t id = model.system.bounded[i], row = v.row_begin[id];
        const ImpulseRange range = impulse_range(model, work.newton, id);
        if (never_switches(model, v, id, range)) continue;
        const context::BoundedRow p = work.newton.row[i];
        double& held = model.interactions.held[at(id)];
        const SwitchRequest wish = request_of(model, work.newton, v, i, p, range);
        if (wish.active && wish.was_active) continue;
        if (wish.requests_switch() && is_rounding(model, id, wish, p.lambda, range)) continue;
        if (wish.requests_switch()) {
            // Lines without load are slack or taut by rounding, which does not count.
            const double least =
                work.newton.on_scalar[i] != 0 ? std::min(floor, model.scalar_floor) : floor;
            if (std::fabs(wish.projected - p.lambda) <= least) continue;
            if (switch_count++ >= most) continue;
        }
        if (most == 0) continue;
        work.solve.losses_known = false;
        v.active[id] = wish.active ? 1.0 : 0.0;
        if (wish.active) continue;
        held = wish.projected;
        v.lambda[row] = wish.projected;
    }
    if (switch_count > 0 && runs) settle_runs(model, work.newton);
    if (follows && switch_count == 0) extrapolate_bounds(model, work);
    if (switch_count > 0) work.newton.follow.restart();
    return switch_count;
}

bool any_row_requests_switch(const context::Model& model, const context::Newton& newton,
                             const View& v) noexcept {
    for (std::size_t i = 0; i < model.system.bounded.size(); ++i) {
        const std::int32_t id = model.system.bounded[i];
        if (is_taut_line(v, id)) continue;
        (void)choose_end(model, v, id);
        const ImpulseRange range = impulse_range(model, newton, id);
        if (never_switches(model, v, id, range)) continue;
        const context::BoundedRow p = present_row(v, id);
        const SwitchRequest wish = request_of(model, newton, v, i, p, range);
        if (wish.requests_switch() && std::fabs(wish.projected - p.lambda) > 0.0 &&
            !is_rounding(model, id, wish, p.lambda, range))
            return true;
    }
    return false;
}

void show_held(context::Model& model) noexcept {
    const View v = context::row_view(model);
    for (const std::int32_t id : model.system.bounded) {
        if (v.active[id] != 0.0 || v.parted[id] || model.wires.is_replaced(id)) continue;
        double& lambda = v.lambda[v.row_begin[id]];
        if (lambda != v.held[id]) lambda = v.held[id];
    }
}

std::int32_t asking_rows(context::Model& model, context::Work& work, double floor) noexcept {
    take_bounds(model, work.newton);
    keep_bounds(work.newton, 1.0);
    return switch_bounds(model, work, floor, 0);
}

void move_anchors(context::Model& model) noexcept {
    model::Interactions& in = model.interactions;
    for (const std::int32_t id : in.frictions) {
        if (in.active[at(id)] != 0.0 || model.system.rests(id)) continue;
        const auto row = at(in.row_begin[at(id)]);
        const double g = in.row_state(id, model.bodies).g[0];
        in.set_anchor(id, in.anchor[at(id)] + g + in.epsilon[row] * in.force[row]);
    }
}

}  // namespace hawser::solve
