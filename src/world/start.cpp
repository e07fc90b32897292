// SPDX-License-Identifier: Apache-2.0
/// Data for a check of a start: rows and overlaps at the present poses.
#include <hawser/inspect.h>
#include <hawser/world.h>

#include "step/ready.h"
#include "world/impl.h"

#include <new>

namespace hawser {

RowsView WorldSolverView::rows(InteractionId id) const {
    const std::size_t i = impl().index_of(id);
    const context::StepContext& ctx = impl().ctx;
    const model::Interactions& in = ctx.model.interactions;
    const model::RowState state = in.row_state(id.index, ctx.model.bodies);
    RowsView out;
    out.rows = in.rows[i];
    out.bodies = in.bodies[i];
    for (std::size_t r = 0; r < in.rows[i]; ++r) {
        const std::size_t row = at(in.row_begin[i]) + r;
        out.velocity[r] = (in.row_flags[row] & model::kRowVelocity) != 0;
        (out.velocity[r] ? out.speed : out.violation)[r] = state.g[r];
        out.rate[r] = state.rate[r] + state.carried[r];
        out.compliance[r] = in.epsilon[row];
        out.damping_time[r] = in.tau[row];
        double unit[kMaxInteractionRows] = {};
        unit[r] = 1.0;
        for (std::size_t b = 0; b < in.bodies[i]; ++b)
            in.add_impulse(id.index, static_cast<int>(b), ctx.model.bodies, unit,
                           out.jacobian[b][r].data());
    }
    return out;
}

std::vector<ContactView> World::overlaps() const {
    const world::Using use(impl_->use, "overlaps");
    context::StepContext& ctx = impl_->ctx;
    std::vector<ContactView> out;
    if (ctx.model.collider.count() == 0) return out;
    step::ready(ctx);
    collide::ContactSet found;
    ctx.model.collider.surfaces(ctx.model.def.step, found);
    // The collider remembers no result until keep().
    if (!ctx.model.collider.collide(ctx.model.bodies, ctx.model.def.step, found, ctx.pool)) {
        const BoundMet met = ctx.model.collider.limit_reached();
        if (met.bound != Bound::none) throw LimitError(met);
        if (!ctx.model.collider.finite())
            throw DefError(
                "a body with a shape is so far away that coordinates do not resolve lengths");
        throw std::bad_alloc();
    }
    for (const collide::Contact& c : found.contacts) {
        if (c.gap >= 0.0) continue;
        ContactView& v = out.emplace_back();
        v.gap = c.gap;
        for (int k = 0; k < 3; ++k) {
            v.point[k] = 0.5 * (c.on[0][k] + c.on[1][k]);
            v.normal[k] = c.normal[k];
        }
        v.force = -c.gap / found.surfaces[at(c.surface)].compliance * v.normal;
        for (int s = 0; s < 2; ++s) v.shape[s] = ctx.model.collider.slots.id<ShapeId>(c.shape[s]);
    }
    return out;
}

}  // namespace hawser
