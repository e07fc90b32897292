// SPDX-License-Identifier: Apache-2.0
#include "stepper/prepare.h"

#include "stepper/analyse.h"
#include "stepper/analysis.h"
#include "stepper/asleep.h"
#include "stepper/contact.h"
#include "stepper/cuts.h"
#include "stepper/judge_look.h"
#include "stepper/regroup.h"
#include "stepper/wires.h"

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
