// SPDX-License-Identifier: Apache-2.0
#include "step/prestep.h"

namespace hawser::step {

Status prestep(context::StepContext& ctx) noexcept {
    ctx.state.loads.clear();
    if (ctx.actors == nullptr) return Status::ok;
    const Status status = ctx.actors->act(ctx);
    if (status == Status::ok && ctx.state.loads.any())
        ctx.state.loads.finish(ctx.model.bodies, ctx.model.def.step, ctx.pool);
    return status;
}

void accept_systems(context::StepContext& ctx) noexcept {
    ctx.state.loads.accept();
    if (ctx.actors != nullptr) ctx.actors->accept(ctx);
}

void take_back_systems(context::StepContext& ctx) noexcept {
    ctx.state.loads.take_back(ctx.model.bodies);
    if (ctx.actors != nullptr) ctx.actors->go_back(ctx);
}

double added_energy(const context::Model& model, context::State& state, runtime::Pool& pool,
                    const double* v) noexcept {
    return state.loads.added_energy(model.bodies, v, pool);
}

}  // namespace hawser::step
