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

namespace hawser::stepper {

namespace {

using assembly::Contacts;

/// Rebuild after a failed step, from the order of the last analysis and at its poses.
void rebuild_undone(StepContext& ctx) {
    const bool all =
        ctx.state.repair == PendingRepair::all || ctx.state.repair == PendingRepair::all_follow;
    ctx.model.system.contacts.make_blocks();
    {
        const AnalysedPoses poses(ctx);
        analyse(ctx);
    }
    if (all) finish_preparing(ctx);
    reserve_sleep(ctx.model, ctx.work.sleep);
    ctx.work.before.lambda.resize(ctx.model.interactions.lambda.size());
    ctx.work.before.repeats.resize(ctx.model.interactions.repeats.size());
    reserve_undo(ctx.model, ctx.work.undo);
    ctx.state.changed = Changed::nothing;
}

/// Update after changes of shapes alone: the blocks of contacts, and the order if links were
/// removed. Forms and damping fractions stay those of the last analysis.
/// @return false if an analysis is needed.
bool follow_shapes(StepContext& ctx, Contacts::Blocks changed) {
    if (ctx.state.changed != Changed::shapes) return false;
    // Earlier updates were undone, so the changed blocks are unknown.
    const bool undone = ctx.state.repair != PendingRepair::nothing;
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
    if (changed == Contacts::Blocks::links) relink(ctx);
    count_growth(ctx.model, ctx.work.stats);
    ctx.state.changed = Changed::nothing;
    return true;
}

}  // namespace

Contacts::Blocks prepare_touching(StepContext& ctx) {
    if (ctx.model.collider.count() == 0) return Contacts::Blocks::same;
    ctx.model.collider.prepare(ctx.model.bodies, ctx.model.interactions, ctx.model.def.step);
    ctx.model.collider.surfaces(ctx.model.def.step, ctx.state.contacts);
    return prepare_contacts(ctx.model, ctx.work);
}

void finish_preparing(StepContext& ctx) {
    const bool any = ctx.state.edits.any;
    ctx.state.edits.any = true;  // the monitors continue
    try {
        prepare_monitors(ctx.model, ctx.state);
    } catch (...) {
        ctx.state.edits.any = any;
        throw;
    }
    ctx.state.edits.any = any;
    finish_preparation(ctx);
}

void prepare(StepContext& ctx) {
    split_model(ctx);
    const Contacts::Blocks blocks = prepare_touching(ctx);
    if (ctx.state.edits.any)
        check_asleep(ctx.model, ctx.work.stats);
    else
        wake_all(ctx.model, ctx.work.stats);
    if (follow_shapes(ctx, blocks)) return;
    make_wires(ctx.model, ctx.state, ctx.work.wires);
    analyse(ctx);
    reserve_sleep(ctx.model, ctx.work.sleep);
    prepare_monitors(ctx.model, ctx.state);
    finish_preparation(ctx);
}

}  // namespace hawser::stepper
