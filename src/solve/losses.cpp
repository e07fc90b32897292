// SPDX-License-Identifier: Apache-2.0
#include "solve/losses.h"

#include "context/copies.h"
#include "context/sweeps.h"
#include "context/view.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hawser::solve {
namespace {

using assembly::View;

/// ġ of every row at v and at v₊.
struct ViolationRates {
    double before[kMaxInteractionRows], after[kMaxInteractionRows];
};

/// Compute the rates ġ of an interaction's rows from the Jacobian, including the contribution of
/// bodies with a prescribed velocity.
void rates_by_jacobian(const context::Model& model, const View& v, std::int32_t id,
                       ViolationRates& out) noexcept {
    double buffer[model::kArmBufferSize];
    const double* jac = packed_rows(v, id, buffer);
    const bool carried = (v.flags[id] & model::kCarried) != 0;
    const model::RowState s =
        carried ? model.interactions.row_state(id, model.bodies) : model::RowState{};
    for (int r = 0; r < v.rows[id]; ++r) {
        out.before[r] = out.after[r] = carried ? s.carried[r] : 0.0;
        for (int b = 0; b < v.bodies[id]; ++b) {
            const std::int32_t body = v.body[kMaxInteractionBodies * id + b];
            for (int j = 0; j < v.dof[body]; ++j, ++jac) {
                out.before[r] += *jac * v.v[v.dof_begin[body] + j];
                out.after[r] += *jac * v.v_new[v.dof_begin[body] + j];
            }
        }
    }
}

/// Compute the rates ġ of an interaction's rows without a pass over the Jacobian. The rate before
/// the step follows from c = Υ(Rġ − 4g/h), where R is the factor of ġ. The rate after the step
/// follows from the equation of the row.
void rates_by_rows(const View& v, std::int32_t id, ViolationRates& out) noexcept {
    for (int r = 0; r < v.rows[id]; ++r) {
        const std::int32_t row = v.row_begin[id] + r;
        out.before[r] = v.completed[id]
                            ? v.rate[row]
                            : (v.c[row] / v.upsilon[row] + 4.0 / v.h * v.g[row]) / v.recall[row];
        out.after[r] = v.c[row] - v.sigma[row] * v.lambda[row] - v.residual[row];
    }
}

/// Compute the mean rates of the violations in the last step and in this step, d₋ and d₊ of
/// step/completion.h. For a completed joint they follow from the law of its rows.
void rates_between_poses(const context::Model& model, const View& v, std::int32_t id,
                         ViolationRates& out) noexcept {
    const double h = model.def.step;
    model.interactions.secants_before(id, model.bodies, h, out.before);
    if (v.completed[id] != assembly::kCompliant) {
        model.interactions.secants_after(id, model.bodies, v.v_new, h, out.after);
        return;
    }
    for (int r = 0; r < v.rows[id]; ++r) {
        const std::int32_t row = v.row_begin[id] + r;
        const double ups = v.upsilon[row];
        out.after[r] = ups * (v.recall[row] * out.before[r] - 4.0 / h * v.g[row]) -
                       v.sigma[row] * v.lambda[row] - v.residual[row];
    }
}

/// Return the elastic energy ½ g²/ε of a row, or 0 if it exerts no force [J].
/// @param now  Violation at the poses of the step.
double elastic_energy(const View& v, std::int32_t id, std::int32_t row, double now,
                      double g) noexcept {
    if (!model::holds_energy(v.epsilon[row], v.rest_length[id])) return 0.0;
    if ((v.flags[id] & model::kOneSided) && g < 0.0) return 0.0;
    if (v.flags[id] & model::kRange) g = model::range_gap(v.low[id], v.high[id], g - now);
    return 0.5 * g * g / v.epsilon[row];
}

/// Return true if a line was taut at the last half-step position. In this case assembly has not
/// changed its c (when_slack() in assembly/isa/slack.h).
/// @param before  ġ from c; 0 for a line that was slack.
bool was_taut(const View& v, std::int32_t row, double before) noexcept {
    return v.g[row] - 0.5 * v.h * before > 1e-9 * std::fabs(v.g[row]);
}

double losses_of(const context::Model& model, const View& v, std::int32_t id) noexcept {
    const int flags = v.flags[id];
    ViolationRates rate;
    rates_by_rows(v, id, rate);
    bool faded = false;
    for (int r = v.row_begin[id]; r < v.row_begin[id] + v.rows[id]; ++r)
        faded |= std::fabs(v.recall[r]) < assembly::kMinRecall;
    const bool line = (flags & model::kOneSided) != 0;
    if ((flags & (model::kCarried | model::kRange)) || faded ||
        (line && (v.active[id] == 0.0 || !was_taut(v, v.row_begin[id], rate.before[0]))))
        rates_by_jacobian(model, v, id, rate);
    ViolationRates mean = rate;  // of the violations between half-step positions
    if (model.interactions.uses_secants(id)) rates_between_poses(model, v, id, mean);
    double absorbed = 0.0;
    for (int r = 0; r < v.rows[id]; ++r) {
        const std::int32_t row = v.row_begin[id] + r;
        if (v.row_flags[row] & model::kRowVelocity) continue;  // its work counts as driven
        const bool rigid = !model::holds_energy(v.epsilon[row], v.rest_length[id]);
        if (rigid && (flags & model::kByInput)) continue;  // its work counts as driven
        const double g = v.g[row], half = 0.5 * v.h;
        absorbed +=
            elastic_energy(v, id, row, g,
                           model::half_step_gap(v.row_flags[row], g, half, mean.before[r])) -
            elastic_energy(v, id, row, g,
                           model::half_step_gap(v.row_flags[row], g, half, -mean.after[r])) -
            0.5 * v.lambda[row] * (rate.before[r] + rate.after[r]);
    }
    return absorbed;
}

}  // namespace

double losses_between(const context::Model& model, const View& v, std::int32_t begin,
                      std::int32_t end) noexcept {
    double absorbed = 0.0;
    end = std::min(end,
                   context::interaction_count(model));  // duplicated rows count with their original
    for (; begin < end; begin += assembly::kLossChunk) {
        const std::int32_t to = std::min(end, begin + assembly::kLossChunk);
        std::int32_t left[assembly::kLossChunk];
        int count = 0;
        absorbed += assembly::kernels().row_losses(v, begin, to, left, &count);
        for (int k = 0; k < count; ++k) absorbed += losses_of(model, v, left[k]);
    }
    return absorbed;
}

double row_losses(context::Model& model, context::SolveWork& solve, runtime::Pool& pool) noexcept {
    const View v = context::row_view(model);
    auto strip = [&](int i, int) noexcept {
        double& absorbed = solve.losses[static_cast<std::size_t>(i)];
        absorbed = 0.0;
        context::each(model.system.strips.interactions(i),
                      [&](std::int32_t begin, std::int32_t end) {
                          absorbed += losses_between(model, v, begin, end);
                      });
    };
    if (!solve.losses_known) pool.for_each(model.system.strips.count(), strip);
    return std::accumulate(solve.losses.begin(), solve.losses.end(), 0.0);
}

double cut_losses(context::Model& model, std::int32_t id) noexcept {
    const View v = context::row_view(model);
    if (v.parted[id]) return 0.0;
    const model::RowState before = model.interactions.row_state(id, model.bodies);
    const model::RowState after = model.interactions.row_state(id, model.bodies, v.v_new);
    double absorbed = 0.0;
    for (int r = 0; r < v.rows[id]; ++r) {
        const std::int32_t row = v.row_begin[id] + r;
        const double g = before.g[r], half = 0.5 * v.h;
        const double rate = before.rate[r] + before.carried[r];
        const double rate_after = after.rate[r] + after.carried[r];
        absorbed +=
            elastic_energy(v, id, row, g, model::half_step_gap(v.row_flags[row], g, half, rate)) -
            elastic_energy(v, id, row, g,
                           model::half_step_gap(v.row_flags[row], g, half, -rate_after)) -
            0.5 * v.lambda[row] * (rate + rate_after);
    }
    return absorbed;
}

double held_by_line(context::Model& model, std::int32_t id) noexcept {
    const View v = context::row_view(model);
    const std::int32_t row = v.row_begin[id];
    if (model.system.rests(id)) {  // cut: not evaluated in this step, and bodies have moved
        const model::RowState now = model.interactions.row_state(id, model.bodies);
        return elastic_energy(v, id, row, now.g[0],
                              now.g[0] - 0.5 * v.h * (now.rate[0] + now.carried[0]));
    }
    ViolationRates rate;
    rates_by_jacobian(model, v, id, rate);
    return elastic_energy(v, id, row, v.g[row], v.g[row] + 0.5 * v.h * rate.after[0]);
}

}  // namespace hawser::solve
