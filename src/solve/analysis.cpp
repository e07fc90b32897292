// SPDX-License-Identifier: Apache-2.0
#include "solve/analysis.h"

#include "access/asleep.h"
#include "access/copies.h"
#include "access/undo.h"
#include "base/index.h"
#include "solve/bounds.h"
#include "solve/joints.h"
#include "solve/wires.h"

#include <algorithm>
#include <cmath>

namespace hawser::stepper {
namespace {

void count_model(StepContext& ctx) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    StepStats& s = ctx.work.stats;
    s.bodies = static_cast<std::int32_t>(ctx.model.bodies.moving.size());
    s.interactions = s.equations = 0;
    for (const std::int32_t b : ctx.model.bodies.moving) s.equations += ctx.model.bodies.dof(b);
    for (std::int32_t id = 0; id < interaction_count(ctx.model); ++id) {
        s.interactions += in.gone(id) ? 0 : 1;
        s.equations += in.rows[at(id)];
    }
}

}  // namespace

void begin_analysis(StepContext& ctx) {
    ctx.model.bodies.share_drag(ctx.model.def.step);
    ctx.state.analysed_x = ctx.model.bodies.x;
    ctx.state.analysed_r = ctx.model.bodies.r;
}

void analyse_system(StepContext& ctx, const factor::AnalysisState* state) {
    ctx.model.system.analysis.use(nullptr);  // mostly between steps, where the pool sleeps
    ctx.model.system.analyse(ctx.model.bodies, ctx.model.interactions, ctx.model.def,
                             ctx.pool.threads(), state);
    ctx.work.solve.norms.resize(
        at(ctx.model.system.strips.count() + ctx.model.system.strips.groups()));
    ctx.work.solve.losses.resize(at(ctx.model.system.strips.count()));
    find_joints(ctx);
    reserve_bounds(ctx);
    ctx.work.before.active.resize(ctx.model.system.bounded.size());
    if (!ctx.model.completion.rigid.empty())
        ctx.work.joints.closing.resize(ctx.model.interactions.g.size() +
                                       at(ctx.model.system.symbolic.scalars));
    if (!ctx.model.completion.looped.empty())
        ctx.work.joints.taken.resize(ctx.model.interactions.g.size());
    count_analysis(ctx);
}

void count_analysis(StepContext& ctx) noexcept {
    StepStats& s = ctx.work.stats;
    s.islands = ctx.model.system.islands.count;
    s.matrix_nnz = ctx.model.system.symbolic.matrix_nnz;
    s.factor_nnz = ctx.model.system.symbolic.factor_nnz;
    s.factor_flops = ctx.model.system.symbolic.flops;
    const factor::RepairReport& report = ctx.model.system.report();
    ++(report.replanned ? s.plans : s.repairs);
    if (!report.replanned) s.columns_repaired += report.columns;
    if (ctx.model.system.grew(ctx.model.bodies.bytes() + ctx.model.interactions.bytes()))
        ++s.growths;
}

void finish_preparation(StepContext& ctx) {
    ctx.state.loads.prepare(ctx.model.bodies);
    ctx.work.before.lambda.resize(ctx.model.interactions.lambda.size());
    ctx.work.before.repeats.resize(ctx.model.interactions.repeats.size());
    ctx.work.before.carriers.resize(16 * ctx.model.bodies.driven.size());
    reserve_undo(ctx);
    double mass = 0.0, least = 1e300;
    for (std::int32_t b : ctx.model.bodies.moving) {
        mass += ctx.model.bodies.mass[at(b)];
        least = std::min(least, ctx.model.bodies.mass[at(b)]);
    }
    // A millionth of the impulse of one gravity over a step: far below any real load.
    ctx.model.residual_floor = 1e-6 * ctx.model.def.step * 9.81 * std::sqrt(mass) + 1e-300;
    ctx.model.contact_floor = 1e-6 * ctx.model.def.step * 9.81 * least;
    count_model(ctx);
    ctx.state.topology_changed = false;
}

void prepare_alone(StepContext& ctx) {
    assembly::System::Kept before;
    ctx.model.system.keep(before);
    try {
        wake_all(ctx);
        make_wires(ctx);
        begin_analysis(ctx);
        analyse_system(ctx, nullptr);
        finish_preparation(ctx);
    } catch (...) {
        ctx.model.system.go_back(before);
        throw;
    }
}

}  // namespace hawser::stepper
