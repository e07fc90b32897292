// SPDX-License-Identifier: Apache-2.0
/// Run stage analyse of a step with splits.
#include "split/split.h"

#include "context/guarded.h"
#include "context/timer.h"
#include "context/undo_data.h"
#include "solve/analysis.h"
#include "split/clique.h"
#include "split/cuts.h"
#include "state/undo.h"

namespace hawser::split {

void analyse(context::StepContext& ctx, const factor::AnalysisState* state) {
    copy_ghost_poses(ctx.model);
    solve::begin_analysis(ctx.model, ctx.state);
    open_cuts(ctx.model);
    analyse_clique(ctx.model);
    // finish_cuts() sums the residuals of momentum
    ctx.model.system.keeps_momentum = ctx.model.cuts.grouped;
    solve::analyse_system(ctx.model, ctx.work, ctx.pool, state);
}

void relink(context::StepContext& ctx) {
    // Bodies in contact belong to one part, so other cuts may be in force now.
    if (open_cuts(ctx.model)) return analyse(ctx);
    ctx.model.system.analysis.use(&ctx.pool);
    ctx.model.system.relink(ctx.model.bodies, ctx.model.interactions, ctx.pool.threads());
    solve::count_analysis(ctx.model, ctx.work.stats);
}

Status request_cuts(context::StepContext& ctx, std::uint64_t interfaces) noexcept {
    if (interfaces == ctx.model.cuts.asked) return Status::ok;
    const context::StageTimer timer(ctx, Stage::analyse);
    return context::guarded(ctx, [&] {
        state::save_state(ctx, context::Undo::Depth::system);
        ctx.model.cuts.asked = interfaces;
        if (!ctx.model.cuts.list.empty() && open_cuts(ctx.model)) analyse(ctx);
    });
}

}  // namespace hawser::split
