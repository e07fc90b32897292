// SPDX-License-Identifier: Apache-2.0
/// Measure the errors that cuts leave in a step, and set the one multiplier that readers get.
#include "split/split.h"

#include "base/index.h"
#include "context/cuts_data.h"
#include "context/view.h"
#include "solve/losses.h"

#include <hawser/row_constants.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace hawser::split {
namespace {

/// Set the impulses of a cut interaction to the mean of its duplicates on both sides.
void average_sides(model::Interactions& in, const context::Cut& cut) noexcept {
    double active = 0.0;
    for (int r = 0; r < in.rows[at(cut.id)]; ++r) {
        double sum = 0.0;
        for (std::int32_t i = cut.first; i < cut.first + cut.sides; ++i)
            sum += in.lambda[at(in.row_begin[at(i)] + r)];
        in.lambda[at(in.row_begin[at(cut.id)] + r)] = sum / cut.sides;
    }
    for (std::int32_t i = cut.first; i < cut.first + cut.sides; ++i)
        active = std::max(active, in.active[at(i)]);
    in.active[at(cut.id)] = active;
}

/// Copy multipliers and active flags of an inactive cut to its duplicated interactions, so that the
/// cut may become active.
void copy_from_original(model::Interactions& in, const context::Cut& cut) noexcept {
    for (std::int32_t i = cut.first; i < cut.first + cut.sides; ++i) {
        in.active[at(i)] = in.active[at(cut.id)];
        std::copy_n(&in.lambda[at(in.row_begin[at(cut.id)])], in.rows[at(cut.id)],
                    &in.lambda[at(in.row_begin[at(i)])]);
    }
}

/// Return the velocity of a line's end at the velocities v of the bodies; `given` holds the
/// velocities of bodies without degrees of freedom.
Vec3 end_velocity(const assembly::View& v, std::int32_t body, const double* velocity,
                  const double* given, const double* arm) noexcept {
    const int dof = v.dof[body];
    const double* u = dof == 0 ? given + 6 * body : velocity + v.dof_begin[body];
    if (dof == 1) return Vec3::Zero();
    Vec3 lin(u[0], u[1], u[2]);
    if (dof == 3) return lin;
    return lin + Vec3(u[3], u[4], u[5]).cross(Vec3(arm[0], arm[1], arm[2]));
}

/// Add the impulse K (v − v₊) of the geometric stiffness of a line's copy on the bodies of its side
/// (linear part).
void add_geometric(const assembly::View& v, std::int32_t id, double* sum) noexcept {
    const assembly::GeoSlot& place = v.geo[id];
    if (place.record < 0) return;
    const double* record = v.geo_record + place.record;
    if (record[0] == 0.0) return;
    const std::int32_t* body = v.body + kMaxInteractionBodies * id;
    const double none[3] = {};
    Vec3 change = Vec3::Zero();
    for (int b = 0; b < 2; ++b) {
        const double* arm = place.dof == 6 ? record + 4 + 3 * b : none;
        const Vec3 before = end_velocity(v, body[b], v.v, v.v_before, arm);
        const Vec3 after = end_velocity(v, body[b], v.v_new, v.v_fixed, arm);
        change += (b == 0 ? 1.0 : -1.0) * (before - after);
    }
    const Vec3 u(record[1], record[2], record[3]);
    const Vec3 push = record[0] * (change - u.dot(change) * u);
    for (int b = 0; b < 2; ++b)
        if (v.dof[body[b]] >= 3)
            for (int j = 0; j < 3; ++j) sum[j] += (b == 0 ? 1.0 : -1.0) * push[j];
}

/// Return the norm of the sum of impulses that the sides exert on the bodies, linear parts: Gᵀ(λ of
/// the side − mean) and geometric stiffness.
double impulse_imbalance(context::Model& model, const context::Cut& cut) noexcept {
    const assembly::View v = context::row_view(model);
    const model::Interactions& in = model.interactions;
    const double* mean = &in.lambda[at(in.row_begin[at(cut.id)])];
    double sum[6] = {};
    for (std::int32_t i = cut.first; i < cut.first + cut.sides; ++i) {
        double more[kMaxInteractionRows];
        for (int r = 0; r < in.rows[at(i)]; ++r)
            more[r] = in.lambda[at(in.row_begin[at(i)] + r)] - mean[r];
        add_geometric(v, i, sum);
        for (std::int32_t b = 0; b < in.bodies[at(i)]; ++b) {
            const std::int32_t body = in.body[at(kMaxInteractionBodies * i + b)];
            if (model.bodies.dof(body) >= 3) in.add_impulse(i, b, model.bodies, more, sum);
        }
    }
    return std::hypot(sum[0], sum[1], sum[2]);
}

/// Return the largest residual |G v₊ + Σλ − c| of a cut interaction, with the Σ that it has when it
/// is not cut.
double largest_cut_residual(context::Model& model, const context::Cut& cut) noexcept {
    const assembly::View v = context::row_view(model);
    if (v.active[cut.id] == 0.0 || v.parted[cut.id]) return 0.0;
    const double h = v.h;
    const model::RowState now = model.interactions.row_state(cut.id, model.bodies);
    const model::RowState next = model.interactions.row_state(cut.id, model.bodies, v.v_new);
    double most = 0.0;
    for (int r = 0; r < v.rows[cut.id]; ++r) {
        const std::int32_t row = v.row_begin[cut.id] + r;
        const double ups = v.upsilon[row], sigma = row_sigma(v.epsilon[row], ups, h);
        const double rate = model.interactions.recall[at(row)] * (now.rate[r] + now.carried[r]);
        const double c = ups * (rate - 4.0 / h * now.g[r]);
        most =
            std::max(most, std::fabs(next.rate[r] + next.carried[r] + sigma * v.lambda[row] - c));
    }
    return most;
}

/// Return the norm of the linear momentum that the step creates or loses: the sum of all bodies'
/// momentum residuals.
double residual_momentum(const context::Model& model, const assembly::View& v) noexcept {
    double sum[3] = {};
    for (const std::int32_t body : model.bodies.moving)
        if (v.dof[body] >= 3)
            for (int j = 0; j < 3; ++j) sum[j] += v.momentum[v.dof_begin[body] + j];
    return std::hypot(sum[0], sum[1], sum[2]);
}

double mass(const context::Model& model) noexcept {
    double sum = 0.0;
    for (const std::int32_t body : model.bodies.moving)
        if (model.bodies.dof(body) >= 3) sum += model.bodies.mass[at(body)];
    return sum;
}

}  // namespace

void finish_cuts(context::StepContext& ctx) noexcept {
    ctx.work.stats.cuts = 0;
    ctx.work.stats.cut_residual = ctx.work.stats.cut_defect = ctx.work.stats.momentum_defect = 0.0;
    if (!ctx.model.cuts.grouped) return;
    const assembly::View v = context::row_view(ctx.model);
    double defect = residual_momentum(ctx.model, v);
    for (context::Cut& cut : ctx.model.cuts.list) {
        if (!cut.open) {
            copy_from_original(ctx.model.interactions, cut);
            cut.defect = cut.residual = 0.0;
            continue;
        }
        average_sides(ctx.model.interactions, cut);
        cut.defect = impulse_imbalance(ctx.model, cut);
        cut.residual = largest_cut_residual(ctx.model, cut);
        ctx.state.ledger.damped += solve::cut_losses(ctx.model, cut.id);
        defect += cut.defect;
        ctx.work.stats.cut_residual = std::max(ctx.work.stats.cut_residual, cut.residual);
        ctx.work.stats.cut_defect = std::max(ctx.work.stats.cut_defect, cut.defect);
        ++ctx.work.stats.cuts;
    }
    const double g = ctx.model.def.gravity.norm() > 0.0 ? ctx.model.def.gravity.norm() : 9.81;
    ctx.work.stats.momentum_defect =
        defect / (ctx.model.def.step * g * std::max(mass(ctx.model), 1e-300));
}

void follow_cuts(context::Model& model) noexcept {
    for (const context::Cut& cut : model.cuts.list) copy_from_original(model.interactions, cut);
}

void part_all(context::Model& model, std::int32_t id) noexcept {
    model::Interactions& in = model.interactions;
    auto part = [&](std::int32_t i) {
        in.parted[at(i)] = 1;
        in.active[at(i)] = 0.0;
    };
    part(id);
    for (const context::Cut& cut : model.cuts.list)
        if (cut.id == id)
            for (std::int32_t i = cut.first; i < cut.first + cut.sides; ++i) part(i);
}

}  // namespace hawser::split
