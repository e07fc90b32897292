// SPDX-License-Identifier: Apache-2.0
#include "solve/assemble.h"

#include "context/sweeps.h"
#include "context/view.h"
#include "solve/bounds.h"
#include "solve/capstans.h"
#include "solve/evaluate.h"
#include "solve/joints.h"
#include "solve/wire_plan.h"
#include "solve/wraps.h"

namespace hawser::solve {
namespace {

using assembly::View;

/// Return true if the solution starts at the velocities v_start. Steps with contacts start by
/// Newton's method instead.
bool starts_moving(const context::Model& model) noexcept {
    return model.system.contacts.count() == 0 && model.def.nonsmooth != Nonsmooth::pgs;
}

}  // namespace

void assemble_system(context::StepContext& ctx) noexcept {
    ctx.work.solve.losses_known = false;
    const View v = context::view(ctx);
    const assembly::Kernels& k = assembly::kernels();
    follow_wraps(ctx.model);
    hold_bounds(ctx.model, ctx.work.newton, ctx.model.def.step);
    begin_capstans(ctx.model);
    release_capstans(ctx.model, ctx.work.newton);
    choose_completed(ctx.model, ctx.state, ctx.pool);
    const bool completes = ctx.model.completion.any;
    const bool moving = starts_moving(ctx.model);
    View rows = v;
    // PGS computes residuals without updating the effect of v₊.
    if (!moving && ctx.model.def.nonsmooth != Nonsmooth::pgs) rows.v_start = nullptr;
    context::sweep(
        ctx.model, ctx.pool,
        [&](int strip) {
            evaluate_block(ctx.model, rows, strip);
            replan_wires(ctx.model, rows, strip);
            if (completes) (void)complete_block(ctx.model, v, strip, v.v_start, true);
            context::each(ctx.model.system.strips.interactions(strip),
                          [&](std::int32_t a, std::int32_t b) { k.first_rhs(v, a, b, moving); });
        },
        [&](std::int32_t a, std::int32_t b, int) {
            k.body_terms(v, a, b);
            ctx.state.loads.add_terms(v, a, b);
            if (completes) (void)k.complete_spins(v, a, b, v.v_start, true);
            k.first_body_rhs(v, a, b, moving);
        });
    ctx.work.solve.rhs_ready = true;
}

}  // namespace hawser::solve
