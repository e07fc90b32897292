// SPDX-License-Identifier: Apache-2.0
#include "step/prepare.h"

#include "context/asleep.h"
#include "monitor/prepare_monitor.h"
#include "solve/analysis.h"
#include "solve/wires.h"
#include "split/split.h"
#include "state/undo.h"
#include "step/analysed_poses.h"
#include "step/contact.h"

namespace hawser::step {

namespace {

using assembly::Contacts;

/// Rebuild the analysed system after a failed step, with the order of the last analysis and at its
/// poses.
void rebuild_undone(context::StepContext& ctx) {
    const bool all = ctx.state.repair == context::PendingRepair::all ||
                     ctx.state.repair == context::PendingRepair::all_follow;
    ctx.model.system.contacts.make_blocks();
    {
        const AnalysedPoses poses(ctx);
        split::analyse(ctx);
    }
    if (all) finish_preparing(ctx);
    context::reserve_sleep(ctx.model, ctx.work.sleep);
    ctx.work.before.lambda.resize(ctx.model.interactions.lambda.size());
    ctx.work.before.repeats.resize(ctx.model.interactions.repeats.size());
    state::reserve_undo(ctx.model, ctx.work.undo);
    ctx.state.changed = context::Changed::nothing;
}

/// Update the blocks of contacts after changes of shapes only, and the order if links were removed.
/// The selected forms of rows and the damping fractions of the last analysis remain.
/// @return false if an analysis is needed.
bool follow_shapes(context::StepContext& ctx, Contacts::Blocks changed) {
    if (ctx.state.changed != context::Changed::shapes) return false;
    // Earlier updates were undone, so the changed blocks are unknown.
    const bool undone = ctx.state.repair != context::PendingRepair::nothing;
    // With the first shapes that may touch, updates of fronts are kept.
    if ((changed != Contacts::Blocks::same || undone) &&
        ctx.model.system.contacts.blocks.empty() == ctx.model.system.symbolic.updates_kept)
        return false;
    if (undone) {
        rebuild_undone(ctx);
        return true;
    }
    if (changed == Contacts::Blocks::own)
        ctx.model.system.follow_touching(ctx.model.bodies, ctx.model.interactions);
    if (changed == Contacts::Blocks::links) split::relink(ctx);
    solve::count_growth(ctx.model, ctx.work.stats);
    ctx.state.changed = context::Changed::nothing;
    return true;
}

}  // namespace

Contacts::Blocks prepare_touching(context::StepContext& ctx) {
    if (ctx.model.collider.count() == 0) return Contacts::Blocks::same;
    ctx.model.collider.prepare(ctx.model.bodies, ctx.model.interactions, ctx.model.def.step);
    ctx.model.collider.surfaces(ctx.model.def.step, ctx.state.contacts);
    return prepare_contacts(ctx.model, ctx.work);
}

void finish_preparing(context::StepContext& ctx) {
    const bool any = ctx.state.edits.any;
    ctx.state.edits.any = true;  // the monitors continue
    try {
        monitor::prepare_monitors(ctx.model, ctx.state);
    } catch (...) {
        ctx.state.edits.any = any;
        throw;
    }
    ctx.state.edits.any = any;
    solve::finish_preparation(ctx);
}

void prepare(context::StepContext& ctx) {
    split::split_model(ctx);
    const Contacts::Blocks blocks = prepare_touching(ctx);
    if (ctx.state.edits.any)
        context::check_asleep(ctx.model, ctx.work.stats);
    else
        context::wake_all(ctx.model, ctx.work.stats);
    if (follow_shapes(ctx, blocks)) return;
    solve::make_wires(ctx.model, ctx.state, ctx.work.wires);
    split::analyse(ctx);
    context::reserve_sleep(ctx.model, ctx.work.sleep);
    monitor::prepare_monitors(ctx.model, ctx.state);
    solve::finish_preparation(ctx);
}

}  // namespace hawser::step
