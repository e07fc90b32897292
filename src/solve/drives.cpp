// SPDX-License-Identifier: Apache-2.0
/// Work of interactions, lines with a length paid out by a drum, and motors at an end of their
/// force range.
#include "solve/drives.h"

#include "assembly/rows.h"
#include "base/index.h"
#include "context/push_event.h"
#include "context/view.h"

#include <cmath>
#include <span>

namespace hawser::solve {
namespace {

/// Weights of the velocities before and after the step.
struct VelocityWeights {
    double before, after;
};

/// Return λ·G (a v + b v₊), summed over the rows of an interaction. With a = b = ½ this is the work
/// of an interaction on the kinetic energy of moving bodies, exact for the scheme, since their
/// velocities change by M⁻¹Gᵀλ.
double impulse_times(const assembly::View& v, std::int32_t id, VelocityWeights weights,
                     bool rigid_rows_only) noexcept {
    double buffer[model::kArmBufferSize];
    const double* jac = packed_rows(v, id, buffer);
    double work = 0.0;
    for (int r = 0; r < v.rows[id]; ++r) {
        const std::int32_t row = v.row_begin[id] + r;
        double speed = 0.0;
        for (int b = 0; b < v.bodies[id]; ++b) {
            const std::int32_t body = v.body[kMaxInteractionBodies * id + b];
            for (int j = 0; j < v.dof[body]; ++j) {
                const std::int32_t k = v.dof_begin[body] + j;
                speed += *jac++ * (weights.before * v.v[k] + weights.after * v.v_new[k]);
            }
        }
        const bool velocity = (v.row_flags[row] & model::kRowVelocity) != 0;
        if (rigid_rows_only && !velocity && model::holds_energy(v.epsilon[row], v.rest_length[id]))
            continue;
        work += v.lambda[row] * speed;
    }
    return work;
}

/// Return the work of bodies with a prescribed velocity on elastic or rigid rows [J], −λ·(G v of
/// prescribed velocities). The rows transfer it to other bodies or store it.
double work_of_carriers(const context::Model& model, const assembly::View& v, std::int32_t id,
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

/// Return the work of prescribed velocities on all rows of a friction [J].
double friction_of_carriers(const context::Model& model, const assembly::View& v,
                            std::int32_t id) noexcept {
    const model::RowState s = model.interactions.row_state(id, model.bodies);
    double work = 0.0;
    for (int r = 0; r < v.rows[id]; ++r) work -= v.lambda[v.row_begin[id] + r] * s.carried[r];
    return work;
}

/// True if a friction has an infinite bound: the stop of a guide.
bool is_stop(const context::Model& model, std::int32_t id) {
    const InteractionDef& d = model.interactions.def[at(id)];
    return d.kind == InteractionKind::LineFriction && d.get("force") >= model::kUnbounded;
}

/// Call f(id, true if friction, true if driven) for interactions that may do external work. The
/// work of friction includes the energy of its spring.
template <class F>
void each_drive(const context::Model& model, const assembly::View& v, F&& f) noexcept {
    for (const std::int32_t id : model.interactions.working) {
        if (v.active[id] == 0.0 && v.held[id] == 0.0) continue;
        const bool velocity = (v.row_flags[v.row_begin[id]] & model::kRowVelocity) != 0;
        f(id, (v.flags[id] & model::kFriction) != 0,
          velocity || (v.flags[id] & model::kByInput) != 0);
    }
}

}  // namespace

DriveWork drive_work(context::Model& model) noexcept {
    const assembly::View v = context::row_view(model);
    DriveWork out;
    each_drive(model, v, [&](std::int32_t id, bool friction, bool driven) {
        const bool carried = (v.flags[id] & model::kCarried) != 0;
        const double work = friction || driven ? impulse_times(v, id, {0.5, 0.5}, !friction) : 0.0;
        if (!friction) {
            out.driven += work;
            if (carried) out.driven += work_of_carriers(model, v, id, driven);
            return;
        }
        // The work of a carrier is driven; the remaining work on the bodies is friction.
        const double put_in = carried ? friction_of_carriers(model, v, id) : 0.0;
        out.driven += put_in;
        (is_stop(model, id) ? out.stopped : out.friction) += put_in - work;
    });
    return out;
}

double drive_gain(context::Model& model) noexcept {
    const assembly::View v = context::row_view(model);
    double gain = 0.0;
    each_drive(model, v, [&](std::int32_t id, bool friction, bool driven) {
        if (friction || driven) gain += impulse_times(v, id, {-1.0, 1.0}, !friction);
    });
    return gain;
}

double spring_gain(context::Model& model, std::span<const std::int32_t> springs) noexcept {
    const assembly::View v = context::row_view(model);
    double gain = 0.0;
    for (const std::int32_t id : springs)
        if (v.active[id] != 0.0 && !model.system.rests(id))
            gain += impulse_times(v, id, {-1.0, 1.0}, false);
    return gain;
}

double spring_travel_energy(context::Model& model, std::span<const std::int32_t> springs) noexcept {
    const assembly::View v = context::row_view(model);
    double sum = 0.0;
    for (const std::int32_t id : springs) {
        if (v.active[id] == 0.0 || model.system.rests(id)) continue;
        const bool carried = (v.flags[id] & model::kCarried) != 0;
        const model::RowState s =
            carried ? model.interactions.row_state(id, model.bodies) : model::RowState{};
        double buffer[model::kArmBufferSize];
        const double* jac = packed_rows(v, id, buffer);
        for (int r = 0; r < v.rows[id]; ++r) {
            const std::int32_t row = v.row_begin[id] + r;
            const double speed =
                assembly::along_row(v, id, jac, v.v, v.dof_begin, carried ? s.carried[r] : 0.0);
            if ((v.row_flags[row] & model::kRowVelocity) == 0 &&
                model::holds_energy(v.epsilon[row], v.rest_length[id]))
                sum += v.h * v.h * speed * speed / v.epsilon[row];
        }
    }
    return sum;
}

void move_carriers(context::Model& model) noexcept {
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

void follow_winches(context::Model& model, context::State& state) noexcept {
    model::Interactions& in = model.interactions;
    const double h = model.def.step;
    for (const std::int32_t id : in.winches) {
        const auto row = at(in.row_begin[at(id)]);
        const double before = in.epsilon[row];
        in.update_length_at_drum(id, model.bodies, h);
        // The energy is g²/2ε at the new compliance; at the old one it was the ε_new/ε_old part of
        // it.
        if (in.epsilon[row] == before) continue;
        const double more = in.elastic(id, model.bodies, h) * (1.0 - in.epsilon[row] / before);
        // A slide of a guide or bollard does no driven work.
        if (kind_info(in.kinds[at(id)]).is(kAtGuide))
            state.ledger.damped -= more;
        else
            state.ledger.drive += more;
    }
}

void report_saturation(context::StepContext& ctx) noexcept {
    model::Interactions& in = ctx.model.interactions;
    for (std::size_t i = 0; i < in.motors.size(); ++i) {
        const std::int32_t id = in.motors[i];
        // A motor with a zero range is off.
        const bool off = in.low[at(id)] == 0.0 && in.high[at(id)] == 0.0;
        const bool at_end = in.active[at(id)] == 0.0 && !off;
        if (at_end && !in.saturated[i])
            context::push_event(ctx, EventKind::saturation, id, in.force[at(in.row_begin[at(id)])]);
        in.saturated[i] = at_end ? 1 : 0;
    }
}

}  // namespace hawser::solve
