// SPDX-License-Identifier: Apache-2.0
#include "stepper/assemble_rows.h"

#include "stepper/assemble.h"
#include "stepper/predict.h"
#include "stepper/timer.h"
#include "stepper/wires.h"

namespace hawser::stepper {

void assemble_rows(StepContext& ctx) noexcept {
    const StageTimer timer(ctx, Stage::assemble);
    if (!ctx.wires.again) {
        release_wires(ctx);
        predict(ctx);
    }
    assemble_system(ctx);
}

}  // namespace hawser::stepper
