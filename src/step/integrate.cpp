// SPDX-License-Identifier: Apache-2.0
#include "step/integrate.h"

#include "context/copies.h"
#include "context/push_event.h"
#include "context/sweeps.h"
#include "context/view.h"
#include "context/wire_alerts.h"
#include "edit/edits.h"
#include "solve/bounds.h"
#include "solve/drives.h"
#include "solve/joints.h"
#include "solve/losses.h"
#include "solve/wire_plan.h"
#include "solve/wraps.h"
#include "split/split.h"
#include "step/closing.h"
#include "step/contact.h"

namespace hawser::step {
namespace {

using assembly::View;

/// Break lines whose tension exceeds their breaking load.
void break_lines(context::StepContext& ctx, const View& v) noexcept {
    for (std::size_t i = 0; i < ctx.model.system.breakable.size(); ++i) {
        const std::int32_t id = ctx.model.system.breakable[i];
        const double tension = -v.force_of_row[v.row_begin[id]];
        if (v.parted[id] || tension <= ctx.model.system.breaking_load[i]) continue;
        ctx.state.ledger.damped += solve::held_by_line(ctx.model, context::original(ctx.model, id));
        ctx.state.ledger.edited.given += edit::piece_energy(ctx, context::original(ctx.model, id));
        split::part_all(ctx.model, context::original(ctx.model, id));
        context::begin_recoil(ctx.model, context::original(ctx.model, id), true);
        context::push_event(ctx, EventKind::line_break, context::original(ctx.model, id), tension);
    }
}

/// Report lines that became taut or slack, and ranges at an end.
void report_switches(context::StepContext& ctx, const View& v) noexcept {
    for (std::size_t i = 0; i < ctx.work.before.active.size(); ++i) {
        std::int32_t id = ctx.model.system.bounded[i];
        const double now = v.active[id];
        if (now == ctx.work.before.active[i] || v.parted[id]) continue;
        if (v.flags[id] & (model::kMotor | model::kFriction)) continue;
        const std::int32_t row = v.row_begin[id];
        id = context::reporting_interaction(ctx.model,
                                            id);  // one event for all sides of a cut interaction
        if (id < 0) continue;
        if (v.flags[id] & model::kRange) {
            if (now != 0.0) context::push_event(ctx, EventKind::range, id, v.g[row]);
        } else {
            context::push_event(ctx, now != 0.0 ? EventKind::taut : EventKind::slack, id,
                                now != 0.0 ? -v.force_of_row[row] : 0.0);
        }
    }
}

}  // namespace

void integrate(context::StepContext& ctx) noexcept {
    const View v = context::view(ctx);
    split::finish_cuts(ctx);
    const solve::DriveWork drives = solve::drive_work(ctx.model);
    ctx.state.ledger.drive += drives.driven;
    ctx.state.ledger.friction += drives.friction;
    ctx.state.ledger.damped += drives.stopped;
    ctx.state.ledger.damped += solve::row_losses(ctx.model, ctx.work.solve, ctx.pool);
    solve::settle_wires(ctx);
    count_contact_work(ctx);
    if (ctx.model.collider.count() > 0) remember_contacts(ctx.model, ctx.state, ctx.pool);
    ctx.state.ledger.drag += ctx.state.loads.count();
    solve::note_wheels(ctx.model, ctx.work);
    context::over(ctx.pool, v.body_count,
                  [&](std::int32_t a, std::int32_t b) { assembly::kernels().integrate(v, a, b); });
    solve::move_carriers(ctx.model);
    ctx.state.ledger.work += ctx.work.solve.step_work;
    ctx.state.ledger.drag += ctx.work.solve.step_drag;
    ++ctx.state.step;
    ctx.state.time = static_cast<double>(ctx.state.step) * ctx.model.def.step;
    ctx.work.stats.step = ctx.state.step;
    ctx.work.stats.time = ctx.state.time;
    const double per_h = 1.0 / ctx.model.def.step;
    context::over(ctx.pool, ctx.model.interactions.row_count, [&](std::int32_t a, std::int32_t b) {
        for (std::int32_t r = a; r < b; ++r) v.force_of_row[r] = per_h * v.lambda[r];
    });
    if (ctx.work.newton.switch_after_step)
        (void)solve::switch_bounds(ctx.model, ctx.work, ctx.model.contact_floor, solve::kAnyRows);
    ctx.work.newton.switch_after_step = false;
    break_lines(ctx, v);
    report_switches(ctx, v);
    // Events come first, because this renews rows. Anchors and winches then follow the poses.
    close_joints(ctx);
    solve::finish_completion(ctx.model);
    solve::move_anchors(ctx.model);
    solve::follow_wheels(ctx.model, ctx.work);
    solve::report_saturation(ctx);
    solve::follow_winches(ctx.model, ctx.state);
    // Above this limit the solution violates its own equations beyond engineering accuracy.
    constexpr double kResidualWarning = 1e-8;
    if (ctx.work.stats.momentum_residual > kResidualWarning)
        context::push_event(ctx, EventKind::warning, -1, ctx.work.stats.momentum_residual);
}

}  // namespace hawser::step
