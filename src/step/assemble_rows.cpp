// SPDX-License-Identifier: Apache-2.0
#include "step/assemble_rows.h"

#include "context/timer.h"
#include "solve/assemble.h"
#include "solve/wires.h"
#include "split/split.h"

namespace hawser::step {

void assemble_rows(context::StepContext& ctx) noexcept {
    const context::StageTimer timer(ctx, Stage::assemble);
    if (!ctx.model.wires.again) {
        solve::release_wires(ctx.model);
        split::predict(ctx.model, ctx.state);
    }
    solve::assemble_system(ctx);
}

}  // namespace hawser::step
