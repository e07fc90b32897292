// SPDX-License-Identifier: Apache-2.0
#include "step/assemble_rows.h"

#include "context/timer.h"
#include "solve/assemble.h"
#include "solve/wires.h"
#include "split/split.h"

namespace hawser::stepper {

void assemble_rows(StepContext& ctx) noexcept {
    const StageTimer timer(ctx, Stage::assemble);
    if (!ctx.model.wires.again) {
        release_wires(ctx.model);
        predict(ctx.model, ctx.state);
    }
    assemble_system(ctx);
}

}  // namespace hawser::stepper
