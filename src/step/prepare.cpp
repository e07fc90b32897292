// SPDX-License-Identifier: Apache-2.0
#include "step/prepare.h"

#include "access/asleep.h"
#include "solve/analysis.h"
#include "solve/wires.h"
#include "split/split.h"
#include "step/contact.h"
#include "step/judge_prepare.h"

namespace hawser::stepper {

namespace {

using assembly::Contacts;

/// Where shapes alone came or went: the blocks of contacts, and the order where links went. Forms
/// and shares of damping stay those of the last analysis. @return false: it has to be analysed.
bool follow_shapes(StepContext& ctx, Contacts::Blocks changed) {
    if (ctx.state.changed != Changed::shapes || ctx.state.mend != Mend::nothing) return false;
    // With the first shapes that may touch, updates of fronts are kept.
    if (changed != Contacts::Blocks::same &&
        ctx.model.system.contacts.blocks.empty() == ctx.model.system.symbolic.updates_kept)
        return false;
    if (changed == Contacts::Blocks::own)
        ctx.model.system.follow_touching(ctx.model.bodies, ctx.model.interactions);
    if (changed == Contacts::Blocks::links) relink(ctx);
    count_growth(ctx.model, ctx.work.stats);
    ctx.state.changed = Changed::nothing;
    return true;
}

}  // namespace

void prepare(StepContext& ctx) {
    split_model(ctx);
    Contacts::Blocks blocks = Contacts::Blocks::same;
    if (ctx.model.collider.count() > 0) {
        ctx.model.collider.prepare(ctx.model.bodies, ctx.model.interactions, ctx.model.def.step);
        ctx.model.collider.surfaces(ctx.model.def.step, ctx.state.contacts);
        blocks = prepare_contacts(ctx.model, ctx.work);
    }
    if (ctx.state.edits.any)
        check_asleep(ctx.model, ctx.work.stats);
    else
        wake_all(ctx.model, ctx.work.stats);
    if (follow_shapes(ctx, blocks)) return;
    make_wires(ctx.model, ctx.state, ctx.work.wires);
    analyse(ctx);
    reserve_sleep(ctx.model, ctx.work.sleep);
    prepare_judge(ctx.model, ctx.state);
    finish_preparation(ctx);
}

}  // namespace hawser::stepper
