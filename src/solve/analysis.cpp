// SPDX-License-Identifier: Apache-2.0
#include "solve/analysis.h"

#include "base/index.h"
#include "context/asleep.h"
#include "context/copies.h"
#include "solve/bounds.h"
#include "solve/factor.h"
#include "solve/joints.h"
#include "solve/runs.h"
#include "solve/wire_bounds.h"
#include "solve/wires.h"
#include "state/undo.h"

#include <algorithm>
#include <cmath>

namespace hawser::solve {
namespace {

void count_model(context::Model& model, StepStats& stats) noexcept {
    const model::Interactions& in = model.interactions;
    StepStats& s = stats;
    s.bodies = static_cast<std::int32_t>(model.bodies.moving.size());
    s.interactions = s.equations = 0;
    for (const std::int32_t b : model.bodies.moving) s.equations += model.bodies.dof(b);
    for (std::int32_t id = 0; id < context::interaction_count(model); ++id) {
        s.interactions += in.gone(id) ? 0 : 1;
        s.equations += in.rows[at(id)];
    }
}

void reserve_closing(const context::Model& model, context::JointWork& joints) {
    if (!model.completion.rigid.empty())
        joints.closing.resize(model.interactions.g.size() + at(model.system.symbolic.scalars));
    if (!model.completion.looped.empty()) joints.taken.resize(model.interactions.g.size());
}

}  // namespace

void begin_analysis(context::Model& model, context::State& state) {
    model.bodies.split_drag(model.def.step);
    state.analysed_x = model.bodies.x;
    state.analysed_r = model.bodies.r;
}

void analyse_system(context::Model& model, context::Work& work, runtime::Pool& pool,
                    const factor::AnalysisState* state) {
    model.system.analysis.use(nullptr);  // mostly between steps, when the pool sleeps
    model.system.analyse(model.bodies, model.interactions, model.def, pool.threads(), state);
    work.solve.norms.resize(at(model.system.strips.count() + model.system.strips.groups()));
    work.solve.losses.resize(at(model.system.strips.count()));
    reserve_bounds(model, work.newton);
    reserve_runs(model, work.newton);
    reserve_wire_bounds(model, work.newton);
    work.solve.columns.reserve(max_columns(model));
    work.solve.factored_active.assign(model.system.bounded.size(), 0.0);
    work.before.active.resize(model.system.bounded.size());
    find_joints(model, work.joints);
    reserve_closing(model, work.joints);
    count_analysis(model, work.stats);
}

void count_analysis(context::Model& model, StepStats& stats) noexcept {
    StepStats& s = stats;
    s.islands = model.system.islands.count;
    s.matrix_nnz = model.system.symbolic.matrix_nnz;
    s.factor_nnz = model.system.symbolic.factor_nnz;
    s.factor_flops = model.system.symbolic.flops;
    const factor::RepairReport& report = model.system.report();
    ++(report.replanned ? s.plans : s.repairs);
    if (!report.replanned) s.columns_repaired += report.columns;
    count_growth(model, stats);
}

void count_growth(context::Model& model, StepStats& stats) noexcept {
    if (model.system.needed_more_memory(model.bodies.bytes() + model.interactions.bytes()))
        ++stats.growths;
}

void finish_preparation(context::StepContext& ctx) {
    ctx.state.loads.prepare(ctx.model.bodies);
    ctx.work.before.lambda.resize(ctx.model.interactions.lambda.size());
    ctx.work.before.repeats.resize(ctx.model.interactions.repeats.size());
    ctx.work.before.carriers.resize(16 * ctx.model.bodies.driven.size());
    ctx.work.wheel_angles.resize(ctx.model.interactions.spans.size());
    state::reserve_undo(ctx.model, ctx.work.undo);
    // Slides of almost no mass give no scale for contacts and lines of nodes.
    constexpr double kNone = 1e300;
    double mass = 0.0, least = kNone, least_of_all = kNone;
    for (const std::int32_t b : ctx.model.bodies.moving) {
        const double m = ctx.model.bodies.mass[at(b)];
        mass += m;
        least_of_all = std::min(least_of_all, m);
        if (ctx.model.bodies.dof(b) > 1) least = std::min(least, m);
    }
    if (least == kNone) least = least_of_all;
    // A millionth of the impulse of standard gravity over a step: far below any real load.
    ctx.model.residual_floor = 1e-6 * ctx.model.def.step * 9.81 * std::sqrt(mass) + 1e-300;
    ctx.model.contact_floor = 1e-6 * ctx.model.def.step * 9.81 * least;
    ctx.model.scalar_floor = 1e-6 * ctx.model.def.step * 9.81 * least_of_all;
    count_model(ctx.model, ctx.work.stats);
    ctx.state.changed = context::Changed::nothing;
}

void prepare_alone(context::StepContext& ctx) {
    assembly::System::Kept saved_system;
    ctx.model.system.keep(saved_system);
    try {
        context::wake_all(ctx.model, ctx.work.stats);
        make_wires(ctx.model, ctx.state, ctx.work.wires);
        begin_analysis(ctx.model, ctx.state);
        analyse_system(ctx.model, ctx.work, ctx.pool, nullptr);
        finish_preparation(ctx);
    } catch (...) {
        ctx.model.system.go_back(saved_system);
        throw;
    }
}

}  // namespace hawser::solve
