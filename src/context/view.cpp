// SPDX-License-Identifier: Apache-2.0
#include "context/view.h"

namespace hawser::context {

assembly::View row_view(Model& model) noexcept {
    return model.system.view(model.bodies, model.interactions, model.def);
}

assembly::View view(StepContext& ctx) noexcept {
    assembly::View v = row_view(ctx.model);
    ctx.state.loads.show(v);
    return v;
}

}  // namespace hawser::context
