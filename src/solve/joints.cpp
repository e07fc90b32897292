// SPDX-License-Identifier: Apache-2.0
#include "solve/joints.h"

#include "access/sweeps.h"
#include "base/index.h"
#include "context/completion_data.h"
#include "graph/bridges.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace hawser::stepper {
namespace {

using assembly::Turning;
using assembly::View;

constexpr std::uint8_t kCoarse = 60;  ///< Steps for which a joint beyond is not completed.

/// A joint in short tells its kernels by the sign of its swing.
void mark_record(model::Interactions& in, std::int32_t id) noexcept {
    if (in.arms[at(id)] == 0) return;
    double& swing = in.jacobian[at(in.jac_begin[at(id)] + model::kArmsSwing)];
    swing = in.completed[at(id)] ? -std::fabs(swing) : std::fabs(swing);
}

/// Spins that belong to completed joints.
void find_turning(StepContext& ctx) noexcept {
    const model::Interactions& in = ctx.interactions;
    std::fill(ctx.system.turning.begin(), ctx.system.turning.end(), std::uint8_t{0});
    ctx.completion.any = false;
    for (const std::int32_t id : ctx.completion.joints) {
        if (!in.completed[at(id)]) continue;
        ctx.completion.any = true;
        for (int b = 0; b < in.bodies[at(id)]; ++b)
            ctx.system.turning[at(in.body[at(kMaxInteractionBodies * id + b)])] = 1;
    }
}

}  // namespace

double swing_number(const StepContext& ctx, std::int32_t id, const double* lambdas) noexcept {
    const model::Interactions& in = ctx.interactions;
    const double* lambda = lambdas + in.row_begin[at(id)];
    double square = 0.0;
    for (int r = 0; r < std::min<int>(in.rows[at(id)], 3); ++r) square += lambda[r] * lambda[r];
    return ctx.def.step * std::sqrt(square) * in.swing[at(id)];
}

void find_joints(StepContext& ctx) {
    Completion& c = ctx.completion;
    const model::Interactions& in = ctx.interactions;
    c.joints.clear();
    c.rigid.clear();
    c.looped.clear();
    std::vector<std::pair<std::int32_t, std::int32_t>> edges;
    const std::int32_t ground = ctx.bodies.count();
    auto node = [&](std::int32_t body) { return ctx.bodies.dof(body) > 0 ? body : ground; };
    for (std::int32_t id = 0; id < in.count(); ++id) {
        ctx.interactions.completed[at(id)] = 0;
        if (ctx.system.rests(id) || !model::may_complete(in, id, ctx.def.step)) continue;
        c.joints.push_back(id);
        if (in.epsilon[at(in.row_begin[at(id)])] > 0.0) continue;  // what gives is determined
        const std::int32_t* body = &in.body[at(kMaxInteractionBodies * id)];
        c.rigid.push_back(id);
        edges.emplace_back(node(body[0]), node(body[1]));
    }
    const std::vector<std::uint8_t> looped = graph::edges_on_loops(ground + 1, edges);
    for (std::size_t k = 0; k < c.rigid.size(); ++k)
        if (looped[k]) c.looped.push_back(c.rigid[k]);
    c.coarse_next.assign(c.joints.size(), 0);
    c.refused.assign(c.joints.size(), 0);
    c.lambda_with.assign(in.lambda.size(), 0.0);
    c.any = false;
    ctx.turnings.assign(at(ctx.system.strips.count() + ctx.system.strips.groups()), {});
}

void begin_completion(StepContext& ctx) noexcept {
    ctx.completion.banned = false;
    std::fill(ctx.completion.refused.begin(), ctx.completion.refused.end(), std::uint8_t{0});
    std::copy(ctx.interactions.lambda.begin(), ctx.interactions.lambda.end(),
              ctx.completion.lambda_with.begin());
}

void choose_completed(StepContext& ctx) noexcept {
    Completion& c = ctx.completion;
    model::Interactions& in = ctx.interactions;
    const bool allowed =
        ctx.started && !c.banned && ctx.cuts.list.empty() && ctx.def.nonsmooth == Nonsmooth::newton;
    over(ctx, static_cast<std::int32_t>(c.joints.size()), [&](std::int32_t a, std::int32_t b) {
        for (std::int32_t k = a; k < b; ++k) {
            const std::int32_t id = c.joints[at(k)];
            const std::uint8_t left = in.coarse[at(id)];
            const bool fast =
                c.refused[at(k)] || !(swing_number(ctx, id, in.lambda.data()) <= kResolvedSwing);
            c.coarse_next[at(k)] = fast ? kCoarse : static_cast<std::uint8_t>(left - (left > 0));
            const bool chosen = allowed && c.coarse_next[at(k)] == 0 && in.parted[at(id)] == 0;
            const bool rigid = in.epsilon[at(in.row_begin[at(id)])] == 0.0;
            in.completed[at(id)] =
                !chosen ? 0 : (rigid ? assembly::kRigid : assembly::kStiffDamper);
            mark_record(in, id);
        }
    });
    find_turning(ctx);
}

Turning complete_strip(StepContext& ctx, const View& v, int strip, const double* u,
                       bool first) noexcept {
    Turning t;
    for (const assembly::PoolRange& r : ctx.system.strips.pools(strip)) {
        const model::Pool& pool = ctx.interactions.pool[static_cast<std::size_t>(r.kind)];
        t.add(assembly::kernels().complete_rows(v, r.kind, pool.ids.data(), pool.data.data(),
                                                r.begin, r.end, u, first));
    }
    return t;
}

void finish_completion(StepContext& ctx) noexcept {
    Completion& c = ctx.completion;
    for (std::size_t k = 0; k < c.joints.size(); ++k)
        ctx.interactions.coarse[at(c.joints[k])] = c.coarse_next[k];
}

}  // namespace hawser::stepper
