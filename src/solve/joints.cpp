// SPDX-License-Identifier: Apache-2.0
#include "solve/joints.h"

#include "access/copies.h"
#include "access/sweeps.h"
#include "access/view.h"
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

/// Writes into the record of a compact joint (model/arms.h) whether it is completed, as the sign of
/// its swing number's constant, where kernels read it.
void mark_record(model::Interactions& in, std::int32_t id) noexcept {
    if (in.arms[at(id)] == 0) return;
    double& swing = in.jacobian[at(in.jac_begin[at(id)] + model::kArmsSwing)];
    swing = in.completed[at(id)] ? -std::fabs(swing) : std::fabs(swing);
}

/// Spins that belong to completed joints.
void find_turning(StepContext& ctx) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    std::fill(ctx.model.system.turning.begin(), ctx.model.system.turning.end(), std::uint8_t{0});
    ctx.model.completion.any = false;
    for (const std::int32_t id : ctx.model.completion.joints) {
        if (!in.completed[at(id)]) continue;
        ctx.model.completion.any = true;
        for (int b = 0; b < in.bodies[at(id)]; ++b)
            ctx.model.system.turning[at(in.body[at(kMaxInteractionBodies * id + b)])] = 1;
    }
}

}  // namespace

double swing_number(const StepContext& ctx, std::int32_t id, const double* lambdas) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    const double* lambda = lambdas + in.row_begin[at(id)];
    double square = 0.0;
    for (int r = 0; r < std::min<int>(in.rows[at(id)], 3); ++r) square += lambda[r] * lambda[r];
    return ctx.model.def.step * std::sqrt(square) * in.swing[at(id)];
}

void find_joints(StepContext& ctx) {
    Completion& c = ctx.model.completion;
    const model::Interactions& in = ctx.model.interactions;
    c.joints.clear();
    c.rigid.clear();
    c.looped.clear();
    std::vector<std::pair<std::int32_t, std::int32_t>> edges;
    const std::int32_t ground = ctx.model.bodies.count();
    auto node = [&](std::int32_t body) { return ctx.model.bodies.dof(body) > 0 ? body : ground; };
    for (std::int32_t id = 0; id < in.count(); ++id) {
        ctx.model.interactions.completed[at(id)] = 0;
        if (ctx.model.system.rests(id) || !model::may_complete(in, id, ctx.model.def.step))
            continue;
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
    ctx.work.joints.turnings.assign(
        at(ctx.model.system.strips.count() + ctx.model.system.strips.groups()), {});
}

void begin_completion(StepContext& ctx) noexcept {
    ctx.model.completion.banned = false;
    std::fill(ctx.model.completion.refused.begin(), ctx.model.completion.refused.end(),
              std::uint8_t{0});
    std::copy(ctx.model.interactions.lambda.begin(), ctx.model.interactions.lambda.end(),
              ctx.model.completion.lambda_with.begin());
}

void choose_completed(StepContext& ctx) noexcept {
    Completion& c = ctx.model.completion;
    model::Interactions& in = ctx.model.interactions;
    const bool allowed = ctx.state.started && !c.banned && !has_cuts(ctx.model) &&
                         ctx.model.def.nonsmooth == Nonsmooth::newton;
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
    for (const assembly::PoolRange& r : ctx.model.system.strips.pools(strip)) {
        const model::Pool& pool = ctx.model.interactions.pool[static_cast<std::size_t>(r.kind)];
        t.add(assembly::kernels().complete_rows(v, r.kind, pool.ids.data(), pool.data.data(),
                                                r.begin, r.end, u, first));
    }
    return t;
}

void adopt_completed(StepContext& ctx) noexcept {
    const View v = view(ctx);
    const std::vector<std::int32_t>& joints = ctx.model.completion.joints;
    over(ctx, static_cast<std::int32_t>(joints.size()), [&](std::int32_t a, std::int32_t b) {
        assembly::kernels().adopt_completed(v, joints.data(), a, b);
    });
    over(ctx, v.body_count,
         [&](std::int32_t a, std::int32_t b) { assembly::kernels().adopt_spins(v, a, b); });
}

Turning renew_completed(StepContext& ctx) noexcept {
    const View v = view(ctx);
    const assembly::Strips& strips = ctx.model.system.strips;
    auto& parts = ctx.work.joints.turnings;  // one a strip or group
    sweep(
        ctx, [&](int strip) { parts[at(strip)] = complete_strip(ctx, v, strip, v.v_new, false); },
        [&](std::int32_t a, std::int32_t b, int i) {
            const Turning t = assembly::kernels().complete_spins(v, a, b, v.v_new, false);
            parts[at(i)].add(t);
        });
    Turning all;
    for (int i = 0; i < strips.count() + strips.groups(); ++i) {
        all.add(parts[at(i)]);
        parts[at(i)] = {};
    }
    return all;
}

void finish_completion(StepContext& ctx) noexcept {
    Completion& c = ctx.model.completion;
    for (std::size_t k = 0; k < c.joints.size(); ++k)
        ctx.model.interactions.coarse[at(c.joints[k])] = c.coarse_next[k];
}

}  // namespace hawser::stepper
