// SPDX-License-Identifier: Apache-2.0
#include "step/ready.h"

#include "context/asleep.h"
#include "context/undo_data.h"
#include "split/split.h"
#include "state/undo.h"
#include "step/analysed_poses.h"
#include "step/prepare.h"

#include <utility>

namespace hawser::stepper {
void repair(StepContext& ctx) {
    if (ctx.state.repair == PendingRepair::nothing) return;
    assembly::System::Kept before;
    ctx.model.system.keep(before);
    const bool all =
        ctx.state.repair == PendingRepair::all || ctx.state.repair == PendingRepair::all_follow;
    const bool same =
        ctx.state.repair == PendingRepair::rebuild || ctx.state.repair == PendingRepair::all;
    try {
        const factor::AnalysisState order = before.analysis.state;
        if (all) prepare_touching(ctx);
        ctx.model.system.contacts.make_blocks();
        const AnalysedPoses poses(ctx);
        analyse(ctx, same ? &order : nullptr);
    } catch (...) {
        ctx.model.system.go_back(before);
        throw;
    }
    if (all) finish_preparing(ctx);
    reserve_sleep(ctx.model, ctx.work.sleep);
    ctx.work.before.lambda.resize(ctx.model.interactions.lambda.size());
    ctx.work.before.repeats.resize(ctx.model.interactions.repeats.size());
    reserve_undo(ctx.model, ctx.work.undo);
    ctx.state.repair = PendingRepair::nothing;
}

void make_ready(StepContext& ctx) {
    if (ctx.state.changed != Changed::nothing) {
        keep_state(ctx, may_split(ctx.model) ? Undo::Depth::model : Undo::Depth::system);
        prepare(ctx);
        ctx.state.repair = PendingRepair::nothing;
    } else {
        repair(ctx);
    }
}

Transaction::Transaction(StepContext& ctx) noexcept : ctx_(ctx), done_(ctx.work.undo.holds()) {}

Transaction::~Transaction() {
    if (!done_) restore_kept(ctx_);
}

void Transaction::done() noexcept {
    if (!done_) {
        drop_kept(ctx_.work.undo);
        ctx_.state.edits.clear();
    }
    done_ = true;
}

void ready(StepContext& ctx) {
    if (ctx.state.changed == Changed::nothing && ctx.state.repair == PendingRepair::nothing) return;
    Transaction all(ctx);
    make_ready(ctx);
    all.done();
}

}  // namespace hawser::stepper
