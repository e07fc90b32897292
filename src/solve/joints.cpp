// SPDX-License-Identifier: Apache-2.0
#include "solve/joints.h"

#include "base/index.h"
#include "context/completion_data.h"
#include "context/copies.h"
#include "context/sweeps.h"
#include "context/view.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace hawser::solve {
namespace {

using assembly::Turning;
using assembly::View;
using context::IterationChange;

constexpr std::uint8_t kCoarseSteps =
    60;  ///< Steps for which a joint above the limit is not completed.

/// Write into the record of a compact joint (model/arms.h) whether end-of-step constraint
/// iterations apply to it. Kernels read it as the sign of the constant of its oscillation number.
void mark_record(model::Interactions& in, const context::JointSlot& joint,
                 bool completed) noexcept {
    if (joint.record < 0) return;
    double& vibration = in.jacobian[at(joint.record)];
    vibration = completed ? -std::fabs(vibration) : std::fabs(vibration);
}

/// Mark the bodies of joints with end-of-step constraint iterations.
void find_turning(context::Model& model) noexcept {
    const model::Interactions& in = model.interactions;
    std::fill(model.system.turning.begin(), model.system.turning.end(), std::uint8_t{0});
    model.completion.any = model.completion.any_compliant = false;
    for (const std::int32_t id : model.completion.joints) {
        if (!in.completed[at(id)]) continue;
        model.completion.any = true;
        model.completion.any_compliant |= in.completed[at(id)] == assembly::kCompliant;
        for (int b = 0; b < in.bodies[at(id)]; ++b)
            model.system.turning[at(in.body[at(kMaxInteractionBodies * id + b)])] = 1;
    }
}

/// Mark the rows of an interaction whose half-step violations are means of two poses.
void mark_secants(model::Interactions& in, std::int32_t id, bool marked) noexcept {
    for (int r = 0; r < in.rows[at(id)]; ++r) {
        std::uint8_t& flags = in.row_flags[at(in.row_begin[at(id)] + r)];
        flags = static_cast<std::uint8_t>(marked ? flags | model::kRowSecant
                                                 : flags & ~model::kRowSecant);
    }
}

}  // namespace

void find_joints(context::Model& model, context::JointWork& joints) {
    context::Completion& c = model.completion;
    const model::Interactions& in = model.interactions;
    c.joints.clear();
    c.joint_slots.clear();
    c.rigid.clear();
    c.looped.clear();
    joints.edges.clear();
    const std::int32_t ground = model.bodies.count();
    auto node = [&](std::int32_t body) { return model.bodies.dof(body) > 0 ? body : ground; };
    for (std::int32_t id = 0; id < in.count(); ++id) {
        model.interactions.completed[at(id)] = 0;
        const bool joint = !model.system.rests(id) && model::may_complete(in, id, model.def.step);
        const bool compliant = model::is_compliant(in, id);
        mark_secants(model.interactions, id, joint && compliant);
        if (!joint) continue;
        c.joints.push_back(id);
        c.joint_slots.push_back(
            {in.row_begin[at(id)],
             in.arms[at(id)] != 0 ? in.jac_begin[at(id)] + model::kArmsVibration : -1,
             std::min<std::int32_t>(in.rows[at(id)], 3)});
        if (compliant) continue;  // its forces are determined
        const std::int32_t* body = &in.body[at(kMaxInteractionBodies * id)];
        c.rigid.push_back(id);
        joints.edges.emplace_back(node(body[0]), node(body[1]));
    }
    const std::span<const std::uint8_t> looped = joints.loops.find(ground + 1, joints.edges);
    for (std::size_t k = 0; k < c.rigid.size(); ++k)
        if (looped[k]) c.looped.push_back(c.rigid[k]);
    c.coarse_next.assign(c.joints.size(), 0);
    c.refused.assign(c.joints.size(), 0);
    c.lambda_with.assign(in.lambda.size(), 0.0);
    c.any = c.any_compliant = false;
    joints.changes.assign(at(model.system.strips.count() + model.system.strips.groups()), {});
}

void begin_completion(context::Model& model) noexcept {
    model.completion.banned = false;
    std::fill(model.completion.refused.begin(), model.completion.refused.end(), std::uint8_t{0});
    std::copy(model.interactions.lambda.begin(), model.interactions.lambda.end(),
              model.completion.lambda_with.begin());
}

void choose_completed(context::Model& model, const context::State& state,
                      runtime::Pool& pool) noexcept {
    context::Completion& c = model.completion;
    model::Interactions& in = model.interactions;
    const bool allowed = state.started && !c.banned && !context::has_cuts(model) &&
                         model.def.nonsmooth == Nonsmooth::newton;
    context::over(
        pool, static_cast<std::int32_t>(c.joints.size()), [&](std::int32_t a, std::int32_t b) {
            for (std::int32_t k = a; k < b; ++k) {
                const std::int32_t id = c.joints[at(k)];
                const std::uint8_t left = in.coarse[at(id)];
                constexpr double kMaxSquaredVibration = kResolvedVibration * kResolvedVibration;
                const bool fast =
                    c.refused[at(k)] ||
                    !(squared_vibration(model, k, in.lambda.data()) <= kMaxSquaredVibration);
                c.coarse_next[at(k)] =
                    fast ? kCoarseSteps : static_cast<std::uint8_t>(left - (left > 0));
                const bool chosen = allowed && c.coarse_next[at(k)] == 0 && in.parted[at(id)] == 0;
                std::uint8_t completed = 0;
                if (chosen)
                    completed = in.row_flags[at(c.joint_slots[at(k)].row)] & model::kRowSecant
                                    ? assembly::kCompliant
                                    : assembly::kRigid;
                in.completed[at(id)] = completed;
                mark_record(in, c.joint_slots[at(k)], chosen);
            }
        });
    find_turning(model);
}

Turning complete_block(const context::Model& model, const View& v, int strip, const double* u,
                       bool first) noexcept {
    Turning t;
    for (const assembly::PoolRange& r : model.system.strips.pools(strip)) {
        const model::Pool& pool = model.interactions.pool[static_cast<std::size_t>(r.kind)];
        t.add(assembly::kernels().complete_rows(v, r.kind, pool.ids.data(), pool.data.data(),
                                                r.begin, r.end, u, first));
    }
    return t;
}

void adopt_completed(context::StepContext& ctx) noexcept {
    const View v = context::view(ctx);
    const std::vector<std::int32_t>& joints = ctx.model.completion.joints;
    context::over(ctx.pool, static_cast<std::int32_t>(joints.size()),
                  [&](std::int32_t a, std::int32_t b) {
                      assembly::kernels().adopt_completed(v, joints.data(), a, b);
                  });
    context::over(ctx.pool, v.body_count, [&](std::int32_t a, std::int32_t b) {
        assembly::kernels().adopt_spins(v, a, b);
    });
}

namespace {

/// Return the largest change of a right-hand side among the compliant joints of a row block,
/// weighted by its effect on the solution.
///
/// A change δc of a redundant row is a force δc/(hΣ), which changes the oscillation number s of the
/// joint by h · vibration · δc/Σ. At the end s must be accurate to kVibrationTolerance, or noise
/// would reject a stiff loop.
double weighted_change(const context::Model& model, const View& v, int strip) noexcept {
    constexpr double kMaxRelativeChange = 1e-7,
                     kVibrationTolerance = 0.01;  // the change of step/completion.cpp
    double most = 0.0;
    if (!model.completion.any_compliant) return most;
    for (const assembly::PoolRange& range : model.system.strips.pools(strip)) {
        if (!model::kind_completes(range.kind)) continue;
        const auto& ids = model.interactions.pool[static_cast<std::size_t>(range.kind)].ids;
        for (std::int32_t k = range.begin; k < range.end; ++k) {
            const std::int32_t id = ids[at(k)];
            if (v.completed[id] != assembly::kCompliant) continue;
            const double rate = kMaxRelativeChange / kVibrationTolerance * v.h * v.vibration[id];
            for (std::int32_t r = v.row_begin[id]; r < v.row_begin[id] + v.rows[id]; ++r) {
                const double weight = std::max(1.0, rate / v.sigma[r]);
                const double change = weight * std::fabs(v.c_next[r] - v.c[r]);
                if (!(change <= most)) most = change;  // keeps NaN
            }
        }
    }
    return most;
}

}  // namespace

IterationChange renew_completed(context::StepContext& ctx) noexcept {
    const View v = context::view(ctx);
    const assembly::RowBlocks& strips = ctx.model.system.strips;
    auto& parts = ctx.work.joints.changes;  // one per row block or group
    context::sweep(
        ctx.model, ctx.pool,
        [&](int strip) {
            parts[at(strip)] = {complete_block(ctx.model, v, strip, v.v_new, false),
                                weighted_change(ctx.model, v, strip)};
        },
        [&](std::int32_t a, std::int32_t b, int i) {
            const Turning t = assembly::kernels().complete_spins(v, a, b, v.v_new, false);
            parts[at(i)].add(t);
        });
    IterationChange all;
    for (int i = 0; i < strips.count() + strips.groups(); ++i) {
        all.add(parts[at(i)]);
        if (!(parts[at(i)].weighted <= all.weighted)) all.weighted = parts[at(i)].weighted;
        parts[at(i)] = {};
    }
    return all;
}

void finish_completion(context::Model& model) noexcept {
    context::Completion& c = model.completion;
    for (std::size_t k = 0; k < c.joints.size(); ++k)
        model.interactions.coarse[at(c.joints[k])] = c.coarse_next[k];
}

}  // namespace hawser::solve
