// SPDX-License-Identifier: Apache-2.0
#include "access/view.h"

namespace hawser::stepper {

assembly::View view(StepContext& ctx) noexcept {
    assembly::View v =
        ctx.model.system.view(ctx.model.bodies, ctx.model.interactions, ctx.model.def);
    ctx.state.loads.show(v);
    return v;
}

}  // namespace hawser::stepper
