// SPDX-License-Identifier: Apache-2.0
#include "step/impact.h"

#include "assembly/kinetic.h"
#include "base/index.h"
#include "contact/newton.h"
#include "context/sweeps.h"
#include "context/view.h"
#include "solve/bounds.h"
#include "solve/contact_rows.h"
#include "split/split.h"
#include "state/remember.h"
#include "state/undo.h"
#include "step/assemble_rows.h"
#include "step/contact.h"
#include "step/impact_times.h"
#include "step/prestep.h"

#include <algorithm>
#include <cmath>

namespace hawser::step {
namespace {

using assembly::View;
using nonsmooth::Cone;

constexpr double kStiff = 1e-8;   ///< Σ over W: an error of e of some 1e-8.
constexpr double kSolved = 1e-8;  ///< Residual that rounding permits with kStiff.

/// Set the contact laws of an impact.
/// @param hits  By contact, 1: an impact. @param scale  Factor of the restitution.
void set_laws(context::Model& model, const context::State& state,
              const std::vector<std::uint8_t>& hits, double scale) noexcept {
    for (std::size_t k = 0; k < model.system.contacts.count(); ++k) {
        Cone& c = model.system.contacts.cones[k];
        const double e = scale * restitution(state, k);
        const bool touches = state.contacts.contacts[k].gap <= 0.0;
        c.b[0] = hits[k] != 0 ? -e * c.u[0] : (touches ? 0.0 : -1e30);
        c.b[1] = c.b[2] = 0.0;
        // An impact has no time for compression. A small Σ remains for redundant points.
        c.sigma_n = std::min(c.sigma_n, kStiff * c.mobility);
        c.sigma_t = std::min(c.sigma_t, kStiff * c.mobility);
        std::fill_n(c.lambda, 3, 0.0);
    }
    for (nonsmooth::Resistance& a : model.system.contacts.resistances.laws) {
        std::fill_n(a.b, 3, 0.0);
        a.sigma = std::min(a.sigma, kStiff * a.mobility);
        std::fill_n(a.lambda, 3, 0.0);
    }
}

/// Set the right-hand sides of rows and bodies so that the motion would not change without
/// contacts.
void hold_motion(context::StepContext& ctx) noexcept {
    const View v = context::view(ctx);
    const assembly::Kernels& k = assembly::kernels();
    std::copy_n(v.v, v.dof_count, v.v_new);
    std::fill_n(v.lambda, ctx.model.interactions.row_count, 0.0);
    std::fill_n(v.a, v.dof_count, 0.0);
    std::fill(ctx.model.system.contacts.impulse.begin(), ctx.model.system.contacts.impulse.end(),
              0.0);
    auto update_rows = [&] {
        std::fill_n(v.solution, ctx.model.system.symbolic.scalars, 0.0);
        context::over_interactions(ctx.model, ctx.pool, [&](std::int32_t a, std::int32_t b) {
            k.row_update(v, a, b, false);
        });
    };
    solve::hold_bounds(ctx.model, ctx.work.newton, 0.0);  // bounded forces have no impulse
    // A range that the coordinate only approaches does not act in an impact.
    for (const std::int32_t id : ctx.model.system.bounded)
        if ((v.flags[id] & model::kRange) && v.g[v.row_begin[id]] == 0.0 &&
            v.low[id] + v.high[id] > model::kNoWidth)
            v.active[id] = 0.0;
    update_rows();  // residual + Σλ = c − G v; then c is set to G v
    for (std::int32_t id = 0; id < v.interaction_count; ++id)
        for (std::int32_t r = v.row_begin[id]; r < v.row_begin[id] + v.rows[id]; ++r)
            v.c[r] -= v.active[id] != 0.0 ? v.residual[r] + v.sigma[r] * v.lambda[r] : 0.0;
    std::fill_n(v.lambda, ctx.model.interactions.row_count, 0.0);
    std::fill_n(v.residual, ctx.model.interactions.row_count, 0.0);
    update_rows();  // residuals of zero
    context::over(ctx.pool, v.body_count,
                  [&](std::int32_t a, std::int32_t b) { k.body_rhs(v, a, b); });
    for (const std::int32_t body : ctx.model.bodies.moving)
        for (int j = 0; j < v.dof[body]; ++j)
            v.a[v.dof_begin[body] + j] = -v.solution[v.body_offset[body] + j];
}

/// Try to solve the impacts once. @return ok if v_new contains v⁺; otherwise velocities do not
/// change.
Status attempt(context::StepContext& ctx, double scale) noexcept {
    if (const Status s = start_contacts(ctx, Phase::impact); s != Status::ok) return s;
    set_laws(ctx.model, ctx.state, ctx.work.impact.hits, scale);
    assemble_rows(ctx);
    hold_motion(ctx);
    contact::begin_newton(ctx.model, ctx.work, ctx.pool);
    solve::update_contacts(ctx.model, ctx.pool, nullptr);
    ctx.work.solve.rhs_ready = false;
    return contact::solve_newton(ctx);
}

/// True if a failure is caused by missing resources, not by the attempt. The step is then undone.
bool ends_step(Status status) noexcept {
    return status == Status::out_of_memory || status == Status::over_bound ||
           status == Status::cancelled;
}

/// Move the velocities of bodies with an impact to its time.
void advance_velocities(context::StepContext& ctx, const View& v) noexcept {
    context::ImpactWork& w = ctx.work.impact;
    std::copy_n(v.v, v.dof_count, w.before.begin());
    for (const std::int32_t body : ctx.model.bodies.moving) {
        if (w.time[at(body)] < 0.0) continue;
        const double fraction = 0.5 + w.time[at(body)] / v.h;
        for (int j = v.dof_begin[body]; j < v.dof_begin[body] + v.dof[body]; ++j)
            v.v[j] += fraction * w.change[at(j)];
    }
}

/// Apply the change of velocity by the impact at its time t: v ← v + Δv and x ← x − t Δv. The pose
/// after the step is then that of a body that changes its velocity at this time.
void apply(context::StepContext& ctx, const View& v) noexcept {
    context::ImpactWork& w = ctx.work.impact;
    state::save_poses(ctx);
    for (const std::int32_t body : ctx.model.bodies.moving) {
        const std::int32_t begin = v.dof_begin[body];
        const int dof = v.dof[body];
        const double time = impact_time(w, at(body));
        double* shift = &w.change[at(begin)];  // no longer needed
        for (int j = 0; j < dof; ++j) {
            const double change = v.v_new[begin + j] - v.v[begin + j];
            v.v[begin + j] = w.before[at(begin + j)] + change;
            shift[j] = time * change;
        }
        if (!(time > 0.0)) continue;
        if (dof == 1)
            v.x[3 * body] -= shift[0];
        else
            ctx.model.bodies.drift(body, shift, dof == 6 ? shift + 3 : nullptr, -1.0);
    }
    // Contacts without an impact belong to the moved poses.
    solve::update_contacts(ctx.model, ctx.pool, w.change.data());
    const assembly::Contacts& c = ctx.model.system.contacts;
    for (std::size_t k = 0; k < w.hits.size(); ++k)
        if (w.hits[k] == 0)
            ctx.state.contacts.contacts[k].gap -= c.cones[k].u[0] - c.rows[k].carried[0];
    split::copy_ghost_poses(ctx.model);
}

/// Solve the impacts of the marked contacts, and without restitution if they gain energy.
Status solve_impacts(context::StepContext& ctx) noexcept {
    ++ctx.work.stats.impacts;
    state::save_motion(ctx);
    const View v = context::view(ctx);
    const auto moving = [&](const double* of) {
        return assembly::kinetic_energy(ctx.model.bodies, of) +
               added_energy(ctx.model, ctx.state, ctx.pool, of);
    };
    advance_velocities(ctx, v);
    const double before = moving(v.v);
    bool good = false;
    for (const double scale : {1.0, 0.0}) {
        if (scale == 0.0) ++ctx.work.stats.impact_retries;
        const Status status = attempt(ctx, scale);
        if (ends_step(status)) return status;
        const double after = status == Status::ok ? moving(v.v_new) : 0.0;
        good = status == Status::ok && after <= before * (1.0 + 1e-9) &&
               ctx.work.stats.flips_left == 0 &&
               ctx.work.stats.natural_map <= std::max(kSolved, ctx.model.def.contact_tolerance);
        if (good) {
            ctx.state.ledger.contact += before - after;
            apply(ctx, v);
        }
        // Lines and multipliers continue from the last step.
        state::restore_solved_state(ctx);
        if (good) break;
    }
    if (!good) std::copy_n(ctx.work.impact.before.begin(), v.dof_count, v.v);
    return Status::ok;
}

}  // namespace

Status impact(context::StepContext& ctx, bool& found) noexcept {
    Status status = Status::ok;
    found = false;
    if (!mark_candidates(ctx, status)) return status;
    found = find_times(ctx, status);
    if (found && status == Status::ok) status = solve_impacts(ctx);
    ctx.work.stats.flips_left = 0;  // the solve of the step itself follows
    ctx.work.newton.iterations = 0;
    if (status != Status::ok || found) return status;
    return start_contacts(ctx, Phase::regular);
}

}  // namespace hawser::step
