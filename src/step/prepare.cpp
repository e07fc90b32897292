// SPDX-License-Identifier: Apache-2.0
#include "step/prepare.h"

#include "access/asleep.h"
#include "solve/analysis.h"
#include "solve/wires.h"
#include "split/analyse.h"
#include "split/cuts.h"
#include "split/regroup.h"
#include "step/contact.h"
#include "step/judge_look.h"

namespace hawser::stepper {

void prepare(StepContext& ctx) {
    make_groups(ctx);
    make_cuts(ctx);
    ctx.cut_levels.set({});
    if (ctx.collider.count() > 0) {
        ctx.collider.prepare(ctx.bodies, ctx.interactions, ctx.def.step);
        ctx.collider.surfaces(ctx.def.step, ctx.contacts);
        prepare_contacts(ctx);
    }
    if (ctx.edits.any)
        check_asleep(ctx);
    else
        wake_all(ctx);
    make_wires(ctx);
    analyse(ctx);
    reserve_sleep(ctx);
    prepare_judge(ctx);
    finish_preparation(ctx);
}

}  // namespace hawser::stepper
