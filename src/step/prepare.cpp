// SPDX-License-Identifier: Apache-2.0
#include "step/prepare.h"

#include "access/asleep.h"
#include "solve/analysis.h"
#include "solve/wires.h"
#include "split/split.h"
#include "step/contact.h"
#include "step/judge_prepare.h"

namespace hawser::stepper {

void prepare(StepContext& ctx) {
    split_model(ctx);
    if (ctx.model.collider.count() > 0) {
        ctx.model.collider.prepare(ctx.model.bodies, ctx.model.interactions, ctx.model.def.step);
        ctx.model.collider.surfaces(ctx.model.def.step, ctx.state.contacts);
        prepare_contacts(ctx.model, ctx.work);
    }
    if (ctx.state.edits.any)
        check_asleep(ctx.model, ctx.work.stats);
    else
        wake_all(ctx.model, ctx.work.stats);
    make_wires(ctx.model, ctx.state);
    analyse(ctx);
    reserve_sleep(ctx.model, ctx.work.sleep);
    prepare_judge(ctx.model, ctx.state);
    finish_preparation(ctx);
}

}  // namespace hawser::stepper
