// SPDX-License-Identifier: Apache-2.0
#include "split/analyse.h"

#include "access/guarded.h"
#include "access/timer.h"
#include "access/undo.h"
#include "context/undo_data.h"
#include "solve/analysis.h"
#include "split/clique.h"
#include "split/open_cuts.h"
#include "split/predict.h"

namespace hawser::stepper {

void analyse(StepContext& ctx, const factor::AnalysisState* state) {
    place_images(ctx);
    begin_analysis(ctx);
    open_cuts(ctx);
    analyse_clique(ctx);
    analyse_system(ctx, state);
}

void relink(StepContext& ctx) {
    // What touches is one part: other cuts may be in force now.
    if (open_cuts(ctx)) return analyse(ctx);
    ctx.model.system.analysis.use(&ctx.pool);
    ctx.model.system.relink(ctx.model.bodies, ctx.model.interactions, ctx.pool.threads());
    count_analysis(ctx);
}

Status ask_for_cuts(StepContext& ctx, std::uint64_t interfaces) noexcept {
    if (interfaces == ctx.model.cuts.asked) return Status::ok;
    const StageTimer timer(ctx, Stage::analyse);
    return guarded(ctx, [&] {
        keep_state(ctx, Undo::Depth::system);
        ctx.model.cuts.asked = interfaces;
        if (!ctx.model.cuts.list.empty() && open_cuts(ctx)) analyse(ctx);
    });
}

}  // namespace hawser::stepper
