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
    const model::Interactions& in = ctx.interactions;
    StepStats& s = ctx.stats;
    s.bodies = static_cast<std::int32_t>(ctx.bodies.moving.size());
    s.interactions = s.equations = 0;
    for (const std::int32_t b : ctx.bodies.moving) s.equations += ctx.bodies.dof(b);
    for (std::int32_t id = 0; id < interaction_count(ctx); ++id) {
        s.interactions += in.gone(id) ? 0 : 1;
        s.equations += in.rows[at(id)];
    }
}

}  // namespace

void begin_analysis(StepContext& ctx) {
    ctx.bodies.share_drag(ctx.def.step);
    ctx.analysed_x = ctx.bodies.x;
    ctx.analysed_r = ctx.bodies.r;
}

void analyse_system(StepContext& ctx, const factor::AnalysisState* state) {
    ctx.system.keeps_momentum = ctx.cuts.grouped;  // finish_cuts() adds them up
    ctx.system.analysis.use(nullptr);              // mostly between steps, where the pool sleeps
    ctx.system.analyse(ctx.bodies, ctx.interactions, ctx.def, ctx.pool.threads(), state);
    ctx.norms.resize(at(ctx.system.strips.count() + ctx.system.strips.groups()));
    ctx.losses.resize(at(ctx.system.strips.count()));
    find_joints(ctx);
    reserve_bounds(ctx);
    ctx.active_before.resize(ctx.system.bounded.size());
    if (!ctx.completion.rigid.empty())
        ctx.closing.resize(ctx.interactions.g.size() + at(ctx.system.symbolic.scalars));
    count_analysis(ctx);
}

void count_analysis(StepContext& ctx) noexcept {
    StepStats& s = ctx.stats;
    s.islands = ctx.system.islands.count;
    s.matrix_nnz = ctx.system.symbolic.matrix_nnz;
    s.factor_nnz = ctx.system.symbolic.factor_nnz;
    s.factor_flops = ctx.system.symbolic.flops;
    const factor::RepairReport& report = ctx.system.report();
    ++(report.replanned ? s.plans : s.repairs);
    if (!report.replanned) s.columns_repaired += report.columns;
    if (ctx.system.grew(ctx.bodies.bytes() + ctx.interactions.bytes())) ++s.growths;
}

void finish_preparation(StepContext& ctx) {
    ctx.loads.prepare(ctx.bodies);
    ctx.lambda_before.resize(ctx.interactions.lambda.size());
    ctx.repeats_before.resize(ctx.interactions.repeats.size());
    ctx.carriers_before.resize(16 * ctx.bodies.driven.size());
    reserve_undo(ctx);
    double mass = 0.0, least = 1e300;
    for (std::int32_t b : ctx.bodies.moving) {
        mass += ctx.bodies.mass[at(b)];
        least = std::min(least, ctx.bodies.mass[at(b)]);
    }
    // A millionth of the impulse of one gravity over a step: far below any real load.
    ctx.residual_floor = 1e-6 * ctx.def.step * 9.81 * std::sqrt(mass) + 1e-300;
    ctx.contact_floor = 1e-6 * ctx.def.step * 9.81 * least;
    count_model(ctx);
    ctx.topology_changed = false;
}

void prepare_alone(StepContext& ctx) {
    assembly::System::Kept before;
    ctx.system.keep(before);
    try {
        wake_all(ctx);
        make_wires(ctx);
        begin_analysis(ctx);
        analyse_system(ctx, nullptr);
        finish_preparation(ctx);
    } catch (...) {
        ctx.system.go_back(before);
        throw;
    }
}

}  // namespace hawser::stepper
