// SPDX-License-Identifier: Apache-2.0
/// Method pgs: projected Gauss-Seidel for every row, as in most engines. There is no matrix. A
/// sweep relaxes the rows of all interactions in their order, then the contacts: first the normal,
/// then both tangents on the disk. It starts from the impulses of the last step.
#include "contact/iterate.h"
#include "context/context.h"
#include "context/guarded.h"
#include "context/view.h"
#include "methods/gauss_seidel.h"
#include "solve/bounds.h"
#include "solve/contact_rows.h"
#include "solve/solve.h"

#include <algorithm>
#include <cmath>

namespace hawser::methods {
namespace {

using assembly::View;

/// Call f(body, dof, columns of row r) for each body of an interaction that has degrees of freedom.
template <class F>
void each_body(const View& v, std::int32_t id, int r, F&& f) noexcept {
    int width = 0;
    for (int b = 0; b < v.bodies[id]; ++b) width += v.dof[v.body[kMaxInteractionBodies * id + b]];
    const double* jac = v.jacobian + v.jac_begin[id] + static_cast<std::ptrdiff_t>(r) * width;
    double row[model::kArmWidth];
    if (v.arms[id]) {
        model::unpack_arm_row(v.jacobian + v.jac_begin[id], r, row);
        jac = row;
    }
    for (int b = 0; b < v.bodies[id]; ++b) {
        const std::int32_t body = v.body[kMaxInteractionBodies * id + b];
        if (v.dof[body] == 0) continue;
        f(body, v.dof[body], jac);
        jac += v.dof[body];
    }
}

/// Add the effect M⁻¹ gᵀ x of an impulse x on row r, with Jacobian g, to the velocities v₊.
void push_row(const context::Newton& newton, const View& v, std::int32_t id, int r,
              double x) noexcept {
    each_body(v, id, r, [&](std::int32_t body, int dof, const double* g) {
        double p[6], answered[6];
        for (int j = 0; j < dof; ++j) p[j] = x * g[j];
        velocity_after_impulse(newton, body, dof, p, answered);
        for (int j = 0; j < dof; ++j) v.v_new[v.dof_begin[body] + j] += answered[j];
    });
}

double row_speed(const View& v, std::int32_t id, int r) noexcept {
    double sum = 0.0;
    each_body(v, id, r, [&](std::int32_t body, int dof, const double* g) {
        for (int j = 0; j < dof; ++j) sum += g[j] * v.v_new[v.dof_begin[body] + j];
    });
    return sum;
}

double row_mobility(const context::Newton& newton, const View& v, std::int32_t id, int r) noexcept {
    double sum = 0.0;
    each_body(v, id, r, [&](std::int32_t body, int dof, const double* g) {
        double answered[6];
        velocity_after_impulse(newton, body, dof, g, answered);
        for (int j = 0; j < dof; ++j) sum += g[j] * answered[j];
    });
    return sum;
}

/// Compute the velocities without rows, then add the impulses of the last step.
void start(context::Model& model, context::Newton& newton, const View& v) noexcept {
    for (std::int32_t b = 0; b < v.body_count; ++b)
        if (v.dof[b] > 0)
            velocity_after_impulse(newton, b, v.dof[b], v.a + v.dof_begin[b],
                                   v.v_new + v.dof_begin[b]);
    for (std::int32_t id = 0; id < v.interaction_count; ++id) {
        if (model.system.rests(id)) continue;
        const solve::ImpulseRange range = solve::impulse_range(model, newton, id);
        for (int r = 0; r < v.rows[id]; ++r) {
            const std::int32_t row = v.row_begin[id] + r;
            v.lambda[row] = std::clamp(v.lambda[row], range.low, range.high);
            newton.row_mobility[static_cast<std::size_t>(row)] = row_mobility(newton, v, id, r);
            push_row(newton, v, id, r, v.lambda[row]);
        }
    }
    for (std::size_t k = 0; k < model.system.contacts.count(); ++k) {
        nonsmooth::Cone& c = model.system.contacts.cones[k];
        nonsmooth::project(c.friction, c.lambda);
        push_contact(model, newton, v, k, c.lambda);
    }
}

void sweep_rows(const context::Model& model, const context::Newton& newton,
                const View& v) noexcept {
    for (std::int32_t id = 0; id < v.interaction_count; ++id) {
        if (model.system.rests(id)) continue;
        const solve::ImpulseRange range = solve::impulse_range(model, newton, id);
        if (range.low == range.high) continue;
        for (int r = 0; r < v.rows[id]; ++r) {
            const std::int32_t row = v.row_begin[id] + r;
            const double whole = newton.row_mobility[static_cast<std::size_t>(row)] + v.sigma[row];
            if (!(whole > 0.0)) continue;
            const double row_residual =
                v.c[row] - row_speed(v, id, r) - v.sigma[row] * v.lambda[row];
            const double now =
                std::clamp(v.lambda[row] + row_residual / whole, range.low, range.high);
            const double change = now - v.lambda[row];
            v.lambda[row] = now;
            if (change != 0.0) push_row(newton, v, id, r, change);
        }
    }
}

/// Compute the residuals of the rows, for the certificate.
void store_residuals(context::Model& model, const context::Newton& newton, const View& v) noexcept {
    for (std::int32_t id = 0; id < v.interaction_count; ++id) {
        if (model.system.rests(id)) continue;
        const solve::ImpulseRange range = solve::impulse_range(model, newton, id);
        const double first = v.lambda[v.row_begin[id]];
        if ((v.flags[id] & model::kBounded) || v.parted[id])
            v.active[id] = range.low < first && first < range.high ? 1.0 : 0.0;
        model.interactions.held[static_cast<std::size_t>(id)] = v.active[id] == 0.0 ? first : 0.0;
        for (int r = 0; r < v.rows[id]; ++r) {
            const std::int32_t row = v.row_begin[id] + r;
            const double inactive = r == 0 ? (1.0 - v.active[id]) * v.held[id] : 0.0;
            v.residual[row] = v.active[id] * (v.c[row] - row_speed(v, id, r)) -
                              v.sigma[row] * (v.lambda[row] - inactive);
        }
    }
}

}  // namespace

void begin_pgs(context::Model& model) noexcept { freeze_impulses(model); }

Status solve_pgs(context::StepContext& ctx) noexcept {
    const Status room = context::guarded(ctx, [&] {
        reserve_gauss_seidel(ctx.model, ctx.work.newton, ctx.model.system.contacts.count());
    });
    if (room != Status::ok) return room;
    const View v = context::row_view(ctx.model);
    ctx.work.solve.rhs_ready = false;
    if (!invert_masses(ctx.model, ctx.work.newton, v)) return Status::wrong_pivot;
    start(ctx.model, ctx.work.newton, v);
    for (int i = 0; i < ctx.model.def.nonsmooth_sweeps && !ctx.pool.stopping(); ++i) {
        sweep_rows(ctx.model, ctx.work.newton, v);
        for (std::size_t k = 0; k < ctx.model.system.contacts.count(); ++k) {
            relax_normal(ctx.model, ctx.work.newton, v, k);
            relax_tangents(ctx.model, ctx.work.newton, v, k);
        }
    }
    ctx.work.newton.iterations = ctx.model.def.nonsmooth_sweeps;
    freeze_impulses(ctx.model);
    if (ctx.model.system.contacts.count() > 0) solve::update_contacts(ctx.model, ctx.pool, v.v_new);
    store_residuals(ctx.model, ctx.work.newton, v);
    if (ctx.model.system.contacts.count() > 0)
        ctx.work.stats.natural_map = contact::largest_residual(ctx.model, ctx.work.solve, ctx.pool);
    if (!std::isfinite(ctx.work.stats.natural_map)) return Status::not_finite;
    return solve::measure(ctx);
}

}  // namespace hawser::methods
