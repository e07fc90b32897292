// SPDX-License-Identifier: Apache-2.0
#include "step/impact.h"

#include "assembly/kinetic.h"
#include "base/index.h"
#include "contact/newton.h"
#include "context/sweeps.h"
#include "context/view.h"
#include "solve/bounds.h"
#include "solve/contact_rows.h"
#include "state/remember.h"
#include "state/undo.h"
#include "step/assemble_rows.h"
#include "step/contact.h"
#include "step/prestep.h"

#include <algorithm>
#include <cmath>

namespace hawser::step {
namespace {

using assembly::View;
using nonsmooth::Cone;

constexpr double kStiff = 1e-6;   ///< Σ over W: an error of e of 1e-6.
constexpr double kSolved = 1e-8;  ///< Residual that rounding permits with kStiff.

/// Return the speed below which bodies come to rest without a bounce [m/s].
double threshold(const context::Model& model) noexcept {
    return std::max(1e-3, 2.0 * model.def.gravity.norm() * model.def.step);
}

double restitution(const context::State& state, std::size_t k) noexcept {
    const collide::ContactSet& set = state.contacts;
    return set.surfaces[at(set.contacts[k].surface)].restitution;
}

bool hits(const context::Model& model, const context::State& state, std::size_t k) noexcept {
    const double speed = model.system.contacts.cones[k].u[0];
    return speed < -threshold(model) &&
           state.contacts.contacts[k].gap + model.def.step * speed < 0.0;
}

/// Set the law of every contact for this stage.
void set_laws(context::Model& model, const context::State& state, double scale) noexcept {
    for (std::size_t k = 0; k < model.system.contacts.count(); ++k) {
        Cone& c = model.system.contacts.cones[k];
        const double e = scale * restitution(state, k);
        const bool touches = state.contacts.contacts[k].gap <= 0.0;
        c.b[0] = e > 0.0 && hits(model, state, k) ? -e * c.u[0] : (touches ? 0.0 : -1e30);
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

/// Set right-hand sides of rows and bodies such that without contacts the motion does not change.
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

/// Run one attempt. @return ok if v_new contains v⁺; otherwise velocities do not change.
Status attempt(context::StepContext& ctx, double scale) noexcept {
    if (const Status s = start_contacts(ctx, Phase::impact); s != Status::ok) return s;
    set_laws(ctx.model, ctx.state, scale);
    assemble_rows(ctx);
    hold_motion(ctx);
    contact::begin_newton(ctx.model, ctx.work, ctx.pool);
    solve::update_contacts(ctx.model, ctx.pool, nullptr);
    ctx.work.solve.rhs_ready = false;
    return contact::solve_newton(ctx);
}

/// True if a failure is not due to the attempt but to its resources: the step is undone.
bool ends_step(Status status) noexcept {
    return status == Status::out_of_memory || status == Status::over_bound ||
           status == Status::cancelled;
}

}  // namespace

Status impact(context::StepContext& ctx, bool& found) noexcept {
    const std::size_t count = ctx.model.system.contacts.count();
    found = false;
    bool bouncy = false;
    for (std::size_t k = 0; k < count && !bouncy; ++k) bouncy = restitution(ctx.state, k) > 0.0;
    if (!bouncy) return Status::ok;
    solve::update_contacts(ctx.model, ctx.pool, ctx.model.bodies.v.data());
    for (std::size_t k = 0; k < count && !found; ++k)
        found = restitution(ctx.state, k) > 0.0 && hits(ctx.model, ctx.state, k);
    if (!found) {
        solve::update_contacts(ctx.model, ctx.pool, nullptr);
        return Status::ok;
    }
    ++ctx.work.stats.impacts;
    state::save_motion(ctx);
    const View v = context::view(ctx);
    const auto moving = [&](const double* of) {
        return assembly::kinetic_energy(ctx.model.bodies, of) +
               added_energy(ctx.model, ctx.state, ctx.pool, of);
    };
    const double before = moving(v.v);
    Status status = Status::ok;
    for (const double scale : {1.0, 0.0}) {
        if (scale == 0.0) ++ctx.work.stats.impact_retries;
        status = attempt(ctx, scale);
        if (ends_step(status)) return status;
        const double after = status == Status::ok ? moving(v.v_new) : 0.0;
        const bool good =
            status == Status::ok && after <= before * (1.0 + 1e-9) &&
            ctx.work.stats.flips_left == 0 &&
            ctx.work.stats.natural_map <= std::max(kSolved, ctx.model.def.contact_tolerance);
        if (good) {
            ctx.state.ledger.contact += before - after;
            std::copy_n(v.v_new, v.dof_count, v.v);
        }
        // Lines and multipliers continue from the last step.
        state::restore_solved_state(ctx);
        if (good) break;
    }
    ctx.work.stats.flips_left = 0;  // the solve of the step itself follows
    ctx.work.newton.iterations = 0;
    return Status::ok;
}

}  // namespace hawser::step
