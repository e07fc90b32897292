// SPDX-License-Identifier: Apache-2.0
#include "step/closing.h"

#include "base/index.h"
#include "context/context.h"
#include "context/copies.h"
#include "context/monitor_data.h"
#include "context/view.h"
#include "monitor/measures.h"
#include "solve/evaluate.h"
#include "solve/factor.h"

#include <algorithm>
#include <cmath>

namespace hawser::step {
namespace {

using assembly::View;

constexpr double kOpen = 1e-3;    ///< Gap above which a joint is closed [m or rad].
constexpr double kClosed = 1e-5;  ///< Gap at which iterations end [m or rad].
/// Rotation of a body in a step that may open a joint by kOpen [rad].
constexpr double kTurned = 0.03;
constexpr double kFarTurn = 0.7;  ///< Rotation beyond which directions have changed too much [rad].
constexpr int kMaxClosings = 12;

/// True if a joint may be open because the step has linearised it.
bool may_be_open(const context::Model& model, const StepStats& stats) noexcept {
    const model::Interactions& in = model.interactions;
    const std::vector<std::int32_t>& joints = model.completion.rigid;
    if (std::all_of(joints.begin(), joints.end(),
                    [&](std::int32_t id) { return in.completed[at(id)] == assembly::kRigid; }))
        return false;
    if (stats.violation_max > kOpen) return true;
    const model::Bodies& b = model.bodies;
    double most = 0.0;
    for (const std::int32_t body : b.moving) {
        if (b.dof(body) < 6) continue;
        const double* w = &b.v[at(b.dof_begin[at(body)] + 3)];
        most = std::max(most, w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    }
    return model.def.step * std::sqrt(most) > kTurned;
}

/// Write −g/h of rigid joints at the present poses to the right-hand side. @return largest |g|.
double write_gaps(const context::Model& model, const View& v) noexcept {
    std::fill_n(v.solution, model.system.symbolic.scalars, 0.0);
    const double per_h = 1.0 / v.h;
    double most = 0.0;
    for (const std::int32_t id : model.completion.rigid) {
        if (model.interactions.parted[at(id)] != 0) continue;
        const model::RowState now = model.interactions.row_state(id, model.bodies);
        double buffer[model::kArmBufferSize];
        const double* jac = packed_rows(v, id, buffer);
        for (int r = 0; r < v.rows[id]; ++r) {
            if (!(std::fabs(now.g[r]) <= most)) most = std::fabs(now.g[r]);
            jac = assembly::ask_of_row(v, id, r, jac, -per_h * now.g[r]);
        }
    }
    return most;
}

/// Move bodies by the solution vector of the solver. Angular velocities rotate with the bodies, so
/// that the kinetic energy does not change.
void move(context::Model& model, const View& v, double time) noexcept {
    for (const std::int32_t body : model.bodies.moving) {
        const int dof = v.dof[body];
        const double* d = v.solution + v.body_offset[body];
        if (dof == 1) {
            v.x[3 * body] += time * d[0];
        } else if (dof > 1) {
            model.bodies.drift(body, d, dof == 6 ? d + 3 : nullptr, time);
        }
        if (dof < 6) continue;
        Eigen::Map<Vec3> spin(v.v + v.dof_begin[body] + 3);
        spin = (model::turn_by(d + 3, time) * spin).eval();
    }
}

/// Return the potential energy of all bodies in gravity [J].
double height(const context::Model& model) noexcept {
    const model::Bodies& b = model.bodies;
    double sum = 0.0;
    for (const std::int32_t body : b.moving) {
        if (b.dof(body) == 1 || b.weight[at(body)] == 0) continue;
        for (int k = 0; k < 3; ++k)
            sum -= b.mass[at(body)] * model.def.gravity[k] * b.x[3 * at(body) + at(k)];
    }
    return sum;
}

/// Return the largest rotation rate of a body in the vector of the solver [rad/s].
double fastest_turn(const context::Model& model, const View& v) noexcept {
    double most = 0.0;
    for (const std::int32_t body : model.bodies.moving) {
        if (v.dof[body] < 6) continue;
        const double* w = v.solution + v.body_offset[body] + 3;
        most = std::max(most, w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    }
    return std::sqrt(most);
}

/// Close gaps with the factorisation of the step. @return the remaining gap.
double close_with_factor(context::Model& model, context::Work& work, runtime::Pool& pool,
                         const View& v, double gap) noexcept {
    constexpr double kConverges = 0.5;
    for (int round = 0; round < kMaxClosings && gap > kClosed; ++round) {
        model.system.numeric.solve(model.system.symbolic, v.solution, pool);
        ++work.stats.substitutions;
        work.solve.rhs_ready = false;
        // The step is far beyond the range of the linearisation.
        if (!(v.h * fastest_turn(model, v) <= kFarTurn)) break;
        move(model, v, v.h);
        const double before = gap;
        gap = write_gaps(model, v);
        if (!(gap <= kConverges * before)) break;
    }
    return gap;
}

/// Move poses by the solution vector of the solver, or by a halved fraction of it as long as the
/// gap grows. @return the new gap; if no fraction reduces it, the earlier one.
double move_some(context::Model& model, context::JointWork& joints, const View& v,
                 double gap) noexcept {
    constexpr int kMaxHalvings = 4;
    const double turn = v.h * fastest_turn(model, v);
    double fraction = turn > kFarTurn ? kFarTurn / turn : 1.0;
    if (!std::isfinite(turn)) return gap;
    // write_gaps() overwrites the solution, which is needed to move back.
    double* const kept = joints.closing.data() + model.interactions.g.size();
    std::copy_n(v.solution, model.system.symbolic.scalars, kept);
    for (int half = 0; half <= kMaxHalvings; ++half, fraction *= 0.5) {
        move(model, v, fraction * v.h);
        const double now = write_gaps(model, v);
        if (now <= gap) return now;
        std::copy_n(kept, model.system.symbolic.scalars, v.solution);
        move(model, v, -fraction * v.h);
    }
    return gap;
}

/// Close gaps by Newton's method, with Jacobians and factors at the present poses. A factorisation
/// is used again as long as an iteration reduces the gap by more than 10 %. Iterations converge
/// slowly if light bodies between heavy ones contribute to Σ.
void close_again(context::StepContext& ctx, const View& v) noexcept {
    constexpr int kMaxFactors = 8, kMaxIterationsEach = 8;
    constexpr double kGoesOn = 0.9;
    for (int i = 0; i < kMaxFactors; ++i) {
        solve::evaluate_keeping_ranges(ctx.model, ctx.work.before, ctx.pool);
        double gap = write_gaps(ctx.model, v);
        const double first = gap;
        if (gap <= kClosed || solve::factor(ctx, true) != Status::ok) return;
        for (int round = 0; round < kMaxIterationsEach; ++round) {
            const double before = gap;
            gap = move_some(ctx.model, ctx.work.joints, v, gap);
            if (gap <= kClosed) return;
            if (gap > kGoesOn * before) break;
            ctx.model.system.numeric.solve(ctx.model.system.symbolic, v.solution, ctx.pool);
            ++ctx.work.stats.substitutions;
        }
        if (gap >= first) return;
    }
}

}  // namespace

void close_joints(context::StepContext& ctx) noexcept {
    context::MonitorState& monitors = ctx.state.monitor.state;
    monitors.closed = monitors.closed_elastic = 0.0;
    if (context::has_cuts(ctx.model) || ctx.model.def.nonsmooth != Nonsmooth::newton ||
        !may_be_open(ctx.model, ctx.work.stats))
        return;
    const View v = context::row_view(ctx.model);
    const double gap = write_gaps(ctx.model, v);
    if (!(gap > kOpen)) return;
    const double before = height(ctx.model);
    double* const gaps = ctx.work.joints.closing.data();
    monitor::read_spring_gaps(ctx.model, ctx.state, gaps);
    ctx.pool.block_stop(true);  // poses have begun to move
    if (!(close_with_factor(ctx.model, ctx.work, ctx.pool, v, gap) <= kOpen)) close_again(ctx, v);
    ctx.pool.block_stop(false);
    monitors.closed = height(ctx.model) - before;
    monitors.closed_elastic = monitor::held_by_closing(ctx.model, ctx.state, gaps);
}

}  // namespace hawser::step
