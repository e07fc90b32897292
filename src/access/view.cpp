// SPDX-License-Identifier: Apache-2.0
#include "access/view.h"

namespace hawser::stepper {

assembly::View view(StepContext& ctx) noexcept {
    assembly::View v = ctx.system.view(ctx.bodies, ctx.interactions, ctx.def);
    ctx.loads.show(v);
    return v;
}

}  // namespace hawser::stepper
