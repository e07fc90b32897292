// SPDX-License-Identifier: Apache-2.0
#include "monitor/energy.h"

#include <hawser/world.h>

#include "assembly/kinetic.h"
#include "assembly/rows.h"
#include "base/hash.h"
#include "base/index.h"
#include "context/copies.h"
#include "context/view.h"
#include "solve/evaluate.h"
#include "solve/wire_plan.h"

#include <algorithm>
#include <cstring>

namespace hawser::monitor {
namespace {

/// Move bodies with a prescribed velocity back by half a step. Their poses are saved in the scratch
/// buffer `before`.
void move_carriers_back(context::Model& model, context::Before& before) noexcept {
    model::Bodies& b = model.bodies;
    const double t = -0.5 * model.def.step;
    double* kept = before.carriers.data();
    for (std::int32_t body : b.driven) {
        const auto i = at(body);
        const double* v = &b.v_fixed[6 * i];
        kept = std::copy_n(&b.x[3 * i], 3, kept);
        kept = std::copy_n(&b.q[4 * i], 4, kept);
        kept = std::copy_n(&b.r[9 * i], 9, kept);
        b.drift(body, v, v + 3, t);
    }
}

void restore_carriers(context::Model& model, context::Before& before) noexcept {
    model::Bodies& b = model.bodies;
    const double* kept = before.carriers.data();
    for (std::int32_t body : b.driven) {
        const auto i = at(body);
        std::copy_n(kept, 3, &b.x[3 * i]);
        std::copy_n(kept + 3, 4, &b.q[4 * i]);
        std::copy_n(kept + 7, 9, &b.r[9 * i]);
        kept += 16;
    }
}

}  // namespace

Energy energy(context::StepContext& ctx) noexcept {
    Energy e;
    const model::Bodies& b = ctx.model.bodies;
    const double half = 0.5 * ctx.model.def.step;
    e.kinetic = assembly::kinetic_energy(b, b.v.data());
    for (std::int32_t body : b.moving) {
        const auto i = at(body);
        if (!b.weight[i] || b.dof(body) == 1) continue;
        const double* v = &b.v[at(b.dof_begin[i])];
        for (int k = 0; k < 3; ++k)
            e.gravity -= b.mass[i] * ctx.model.def.gravity[k] * (b.x[3 * i + at(k)] - half * v[k]);
    }
    const assembly::View v = context::row_view(ctx.model);
    const assembly::KeptRanges kept(ctx.work.before.active, ctx.model.interactions.active.data(),
                                    ctx.model.system.bounded);
    // The bodies of the rows move back by −(h/2) G v below.
    move_carriers_back(ctx.model, ctx.work.before);
    solve::evaluate_rows(ctx.model, ctx.pool);
    restore_carriers(ctx.model, ctx.work.before);
    for (std::int32_t id = 0; id < context::interaction_count(ctx.model); ++id) {
        // The energy of a line follows from its length, not from its state in the last step.
        const bool line = (v.flags[id] & model::kOneSided) != 0;
        if (v.flags[id] & model::kFriction) continue;  // counted as driven
        e.kinetic -= assembly::pair_energy(v, id, b.v.data());
        if (line ? v.parted[id] != 0 : v.active[id] == 0.0) continue;
        if (ctx.model.wires.wire_of[at(id)] >= 0 && !ctx.model.system.rests(id) &&
            (v.flags[id] & model::kCarried) == 0) {
            if (model::holds_energy(v.epsilon[v.row_begin[id]], v.rest_length[id]))
                e.elastic += solve::elastic_energy_of_element(v, id);
            continue;
        }
        double buffer[model::kArmBufferSize];
        const double* jac = packed_rows(v, id, buffer);
        const bool rests = ctx.model.system.rests(id);  // not evaluated in this case
        const model::RowState s =
            rests ? ctx.model.interactions.row_state(id, b) : model::RowState{};
        if (ctx.model.interactions.uses_secants(id)) {
            e.elastic += ctx.model.interactions.elastic(id, b, v.h);
            continue;
        }
        for (int r = 0; r < v.rows[id]; ++r) {
            const std::int32_t row = v.row_begin[id] + r;
            double speed = rests ? s.rate[r] + s.carried[r] : 0.0;
            if (!rests) speed = assembly::along_row(v, id, jac, v.v, v.dof_begin, speed);
            if ((v.row_flags[row] & model::kRowVelocity) ||
                !model::holds_energy(v.epsilon[row], v.rest_length[id]))
                continue;
            const double now = rests ? s.g[r] : v.g[row];
            const double g = !rests && (v.flags[id] & model::kRange)
                                 ? model::range_gap(v.low[id], v.high[id], -half * speed)
                                 : model::half_step_gap(v.row_flags[row], now, half, speed);
            if (!line || g > 0.0) e.elastic += 0.5 * g * g / v.epsilon[row];
        }
    }
    e.added = ctx.state.loads.added;
    e.system = ctx.state.loads.work;
    e.water = ctx.state.loads.water;
    e.applied = ctx.state.ledger.work;
    e.driven = ctx.state.ledger.drive;
    e.edited = ctx.state.ledger.edited.sum();
    e.dissipated = ctx.state.ledger.drag;
    e.friction = ctx.state.ledger.friction;
    e.contact = ctx.state.ledger.contact;
    e.damped = ctx.state.ledger.damped;
    return e;
}

}  // namespace hawser::monitor
