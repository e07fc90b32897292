// SPDX-License-Identifier: Apache-2.0
/// Work that enters through interactions, lines whose length a drum pays out, and motors at an end
/// of their force range.
#include "solve/drives.h"

#include "access/push_event.h"
#include "access/view.h"
#include "base/index.h"

#include <cmath>

namespace hawser::stepper {
namespace {

/// λ·G (v + v₊)/2 over the rows: what an interaction does to the kinetic energy of the bodies
/// that move. Exact for the scheme: its velocities change by M⁻¹Gᵀλ.
double work_on_bodies(const assembly::View& v, std::int32_t id, bool rigid_rows_only) noexcept {
    double room[model::kArmRoom];
    const double* jac = packed_rows(v, id, room);
    double work = 0.0;
    for (int r = 0; r < v.rows[id]; ++r) {
        const std::int32_t row = v.row_begin[id] + r;
        double speed = 0.0;
        for (int b = 0; b < v.bodies[id]; ++b) {
            const std::int32_t body = v.body[kMaxInteractionBodies * id + b];
            for (int j = 0; j < v.dof[body]; ++j) {
                const std::int32_t k = v.dof_begin[body] + j;
                speed += 0.5 * *jac++ * (v.v[k] + v.v_new[k]);
            }
        }
        const bool velocity = (v.row_flags[row] & model::kRowVelocity) != 0;
        if (rigid_rows_only && !velocity && model::holds_energy(v.epsilon[row], v.rest_length[id]))
            continue;
        work += v.lambda[row] * speed;
    }
    return work;
}

/// −λ·(G v of prescribed velocities): what carriers put into an elastic or rigid row, which hands
/// it on to the bodies or keeps it.
double work_of_carriers(const Model& model, const assembly::View& v, std::int32_t id,
                        bool elastic_rows_only) noexcept {
    const model::RowState s = model.interactions.row_state(id, model.bodies);
    double work = 0.0;
    for (int r = 0; r < v.rows[id]; ++r) {
        const std::int32_t row = v.row_begin[id] + r;
        if (elastic_rows_only && !model::holds_energy(v.epsilon[row], v.rest_length[id])) continue;
        if (!(v.row_flags[row] & model::kRowVelocity)) work -= v.lambda[row] * s.carried[r];
    }
    return work;
}

}  // namespace

double drive_work(Model& model) noexcept {
    const assembly::View v = row_view(model);
    double work = 0.0;
    for (const std::int32_t id : model.interactions.working) {
        if (v.active[id] == 0.0 && v.held[id] == 0.0) continue;
        const int flags = v.flags[id];
        const bool velocity = (v.row_flags[v.row_begin[id]] & model::kRowVelocity) != 0;
        if (flags & model::kFriction) {  // with what its spring holds
            work += work_on_bodies(v, id, false);
            continue;
        }
        const bool driven = velocity || (flags & model::kByInput) != 0;
        if (driven) work += work_on_bodies(v, id, true);
        if (flags & model::kCarried) work += work_of_carriers(model, v, id, driven);
    }
    return work;
}

void move_carriers(Model& model) noexcept {
    model::Bodies& bodies = model.bodies;
    for (const std::int32_t body : bodies.driven) {
        const auto b = at(body);
        for (std::size_t i = 0; i < 3; ++i)
            bodies.x[3 * b + i] += model.def.step * bodies.v_fixed[6 * b + i];
        const double* w = &bodies.v_fixed[6 * b + 3];
        const double speed = std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
        if (!(speed > 0.0)) continue;
        const double half = 0.5 * model.def.step * speed, s = std::sin(half) / speed;
        bodies.turn(body, Quat(std::cos(half), s * w[0], s * w[1], s * w[2]));
    }
}

void follow_winches(Model& model, State& state) noexcept {
    model::Interactions& in = model.interactions;
    const double h = model.def.step;
    for (const std::int32_t id : in.winches) {
        const auto row = at(in.row_begin[at(id)]);
        const double before = in.epsilon[row];
        in.follow_length(id, model.bodies, h);
        // With the energy g²/2ε at the new compliance; at the old one it was ε_new/ε_old of it.
        if (in.epsilon[row] != before)
            state.ledger.drive +=
                in.elastic(id, model.bodies, h) * (1.0 - in.epsilon[row] / before);
    }
}

void report_saturation(StepContext& ctx) noexcept {
    model::Interactions& in = ctx.model.interactions;
    for (std::size_t i = 0; i < in.motors.size(); ++i) {
        const std::int32_t id = in.motors[i];
        // One that may give no force at all is off.
        const bool off = in.low[at(id)] == 0.0 && in.high[at(id)] == 0.0;
        const bool at_end = in.active[at(id)] == 0.0 && !off;
        if (at_end && !in.saturated[i])
            push_event(ctx, EventKind::saturation, id, in.force[at(in.row_begin[at(id)])]);
        in.saturated[i] = at_end ? 1 : 0;
    }
}

}  // namespace hawser::stepper
