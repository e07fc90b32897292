// SPDX-License-Identifier: Apache-2.0
#include "step/ready.h"

#include "context/asleep.h"
#include "context/undo_data.h"
#include "split/split.h"
#include "state/undo.h"
#include "step/analysed_poses.h"
#include "step/prepare.h"

#include <utility>

namespace hawser::step {
void repair(context::StepContext& ctx) {
    if (ctx.state.repair == context::PendingRepair::nothing) return;
    assembly::System::Kept before;
    ctx.model.system.keep(before);
    const bool all = ctx.state.repair == context::PendingRepair::all ||
                     ctx.state.repair == context::PendingRepair::all_follow;
    const bool same = ctx.state.repair == context::PendingRepair::rebuild ||
                      ctx.state.repair == context::PendingRepair::all;
    try {
        const factor::AnalysisState order = before.analysis.state;
        if (all) prepare_touching(ctx);
        ctx.model.system.contacts.make_blocks();
        const AnalysedPoses poses(ctx);
        split::analyse(ctx, same ? &order : nullptr);
    } catch (...) {
        ctx.model.system.go_back(before);
        throw;
    }
    if (all) finish_preparing(ctx);
    context::reserve_sleep(ctx.model, ctx.work.sleep);
    ctx.work.before.lambda.resize(ctx.model.interactions.lambda.size());
    ctx.work.before.repeats.resize(ctx.model.interactions.repeats.size());
    state::reserve_undo(ctx.model, ctx.work.undo);
    ctx.state.repair = context::PendingRepair::nothing;
}

void make_ready(context::StepContext& ctx) {
    if (ctx.state.changed != context::Changed::nothing) {
        state::save_state(ctx, split::may_split(ctx.model) ? context::Undo::Depth::model
                                                           : context::Undo::Depth::system);
        prepare(ctx);
        ctx.state.repair = context::PendingRepair::nothing;
    } else {
        repair(ctx);
    }
}

Transaction::Transaction(context::StepContext& ctx) noexcept
    : ctx_(ctx), done_(ctx.work.undo.holds()) {}

Transaction::~Transaction() {
    if (!done_) state::restore_saved_values(ctx_);
}

void Transaction::done() noexcept {
    if (!done_) {
        state::discard_saved(ctx_.work.undo);
        ctx_.state.edits.clear();
    }
    done_ = true;
}

void ready(context::StepContext& ctx) {
    if (ctx.state.changed == context::Changed::nothing &&
        ctx.state.repair == context::PendingRepair::nothing)
        return;
    Transaction all(ctx);
    make_ready(ctx);
    all.done();
}

}  // namespace hawser::step
