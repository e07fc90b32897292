// SPDX-License-Identifier: Apache-2.0
#include "stepper/closing.h"

#include "base/index.h"
#include "stepper/stages.h"
#include "stepper/sweeps.h"

#include <algorithm>
#include <cmath>

namespace hawser::stepper {
namespace {

using assembly::View;

constexpr double kOpen = 1e-3;    ///< Gap that is closed [m or rad].
constexpr double kClosed = 1e-5;  ///< Where rounds end [m or rad].
constexpr double kTurned = 0.03;  ///< Turn of a body in a step that may open one by kOpen [rad].
constexpr int kMostRounds = 12;

bool is_rigid(const StepContext& ctx, std::int32_t id) noexcept {
    const model::Interactions& in = ctx.interactions;
    return in.parted[at(id)] == 0 && in.epsilon[at(in.row_begin[at(id)])] == 0.0;
}

/// Whether a joint that the step has linearised may stand open now.
bool may_be_open(const StepContext& ctx) noexcept {
    const model::Interactions& in = ctx.interactions;
    const std::vector<std::int32_t>& joints = ctx.completion.joints;
    if (std::none_of(joints.begin(), joints.end(), [&](std::int32_t id) {
            return in.completed[at(id)] == 0 && is_rigid(ctx, id);
        }))
        return false;
    if (ctx.stats.violation_max > kOpen) return true;
    const model::Bodies& b = ctx.bodies;
    double most = 0.0;
    for (const std::int32_t body : b.moving) {
        if (b.dof(body) < 6) continue;
        const double* w = &b.v[at(b.dof_begin[at(body)] + 3)];
        most = std::max(most, w[0] * w[0] + w[1] * w[1] + w[2] * w[2]);
    }
    return ctx.def.step * std::sqrt(most) > kTurned;
}

/// −g/h of rigid joints at the poses at hand, as right-hand side. @return largest |g|.
double write_gaps(StepContext& ctx, const View& v) noexcept {
    std::fill_n(v.solution, ctx.system.symbolic.scalars, 0.0);
    const double per_h = 1.0 / v.h;
    double most = 0.0;
    for (const std::int32_t id : ctx.completion.joints) {
        if (!is_rigid(ctx, id)) continue;
        const model::RowState now = ctx.interactions.row_state(id, ctx.bodies);
        double room[model::kArmRoom];
        const double* jac = packed_rows(v, id, room);
        for (int r = 0; r < v.rows[id]; ++r) {
            const double to = -per_h * now.g[r];
            if (!(std::fabs(now.g[r]) <= most)) most = std::fabs(now.g[r]);
            if (v.interaction_offset[id] >= 0) v.solution[v.interaction_offset[id] + r] = to;
            const double push =
                v.interaction_offset[id] >= 0 ? 0.0 : to * v.inv_sigma[v.row_begin[id] + r];
            for (int b = 0; b < v.bodies[id]; ++b) {
                const std::int32_t body = v.body[kMaxInteractionBodies * id + b];
                for (int j = 0; j < v.dof[body]; ++j)
                    v.solution[v.body_offset[body] + j] += push * *jac++;
            }
        }
    }
    return most;
}

void move(StepContext& ctx, const View& v, double time) noexcept {
    for (const std::int32_t body : ctx.bodies.moving) {
        const int dof = v.dof[body];
        const double* d = v.solution + v.body_offset[body];
        if (dof == 1) {
            v.x[3 * body] += time * d[0];
        } else if (dof > 1) {
            ctx.bodies.drift(body, d, dof == 6 ? d + 3 : nullptr, time);
        }
    }
}

}  // namespace

void close_joints(StepContext& ctx) noexcept {
    if (!ctx.cuts.list.empty() || ctx.def.nonsmooth != Nonsmooth::newton || !may_be_open(ctx))
        return;
    const View v = view(ctx);
    double gap = write_gaps(ctx, v);
    if (!(gap > kOpen)) return;
    for (int round = 0; round < kMostRounds && gap > kClosed; ++round) {
        ctx.system.numeric.solve(ctx.system.symbolic, v.solution, ctx.pool);
        ++ctx.stats.substitutions;
        ctx.rhs_ready = false;
        move(ctx, v, v.h);
        const double before = gap;
        gap = write_gaps(ctx, v);
        constexpr double kConverges = 0.9;
        if (!(gap <= kConverges * before)) break;
    }
}

}  // namespace hawser::stepper
