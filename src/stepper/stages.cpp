// SPDX-License-Identifier: Apache-2.0
#include "stepper/stages.h"

#include "base/index.h"
#include "stepper/bounds.h"
#include "stepper/clique.h"
#include "stepper/closing.h"
#include "stepper/completion.h"
#include "stepper/contact.h"
#include "stepper/drives.h"
#include "stepper/regroup.h"
#include "stepper/rows.h"
#include "stepper/sleep.h"
#include "stepper/step.h"
#include "stepper/sweeps.h"
#include "stepper/timer.h"

#include <algorithm>
#include <cmath>

namespace hawser::stepper {
namespace {

using assembly::View;

void evaluate_strip(StepContext& ctx, const View& v, int strip) noexcept {
    for (const assembly::PoolRange& r : ctx.system.strips.pools(strip)) {
        const model::Pool& pool = ctx.interactions.pool[static_cast<std::size_t>(r.kind)];
        assembly::kernels().evaluate(v, r.kind, pool.ids.data(), pool.data.data(), r.begin, r.end);
    }
}

/// Whether the solution starts at v_start: with contacts Newton's method has a start of its own.
bool starts_moving(const StepContext& ctx) noexcept {
    return ctx.system.contacts.count() == 0 && ctx.def.nonsmooth != Nonsmooth::pgs;
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

double row_speed(const View& v, std::int32_t id) noexcept {
    double room[model::kArmRoom];
    const double* jac = packed_rows(v, id, room);
    return along_row(v, id, jac, v.v_new, v.dof_begin);
}

void push_event(StepContext& ctx, EventKind kind, std::int32_t id, double value) noexcept {
    ctx.events.push({ctx.time, kind, ctx.interactions.id(id), value});
    ++ctx.stats.event_count[static_cast<std::size_t>(kind)];
}

View view(StepContext& ctx) noexcept {
    View v = ctx.system.view(ctx.bodies, ctx.interactions, ctx.def);
    ctx.loads.show(v);
    return v;
}

void analyse(StepContext& ctx, const factor::AnalysisState* state) {
    place_images(ctx);
    ctx.bodies.share_drag(ctx.def.step);
    ctx.analysed_x = ctx.bodies.x;
    ctx.analysed_r = ctx.bodies.r;
    open_cuts(ctx);
    analyse_clique(ctx);
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

void relink(StepContext& ctx) {
    // What touches is one part: other cuts may be in force now.
    if (open_cuts(ctx)) return analyse(ctx);
    ctx.system.analysis.use(&ctx.pool);
    ctx.system.relink(ctx.bodies, ctx.interactions, ctx.pool.threads());
    count_analysis(ctx);
}

void prepare(StepContext& ctx) {
    make_groups(ctx);
    make_cuts(ctx);
    ctx.cut_levels.set({});
    if (ctx.collider.count() > 0) {
        ctx.collider.prepare(ctx.bodies, ctx.interactions, ctx.def.step);
        ctx.collider.surfaces(ctx.def.step, ctx.contacts);
        prepare_contacts(ctx);
    }
    if (ctx.edits.any)
        check_asleep(ctx);
    else
        wake_all(ctx);
    make_wires(ctx);
    analyse(ctx);
    reserve_sleep(ctx);
    prepare_judge(ctx);
    ctx.loads.prepare(ctx.bodies);
    ctx.lambda_before.resize(ctx.interactions.lambda.size());
    ctx.repeats_before.resize(ctx.interactions.repeats.size());
    ctx.carriers_before.resize(16 * ctx.bodies.driven.size());
    ctx.undo.reserve(ctx);
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

Status prestep(StepContext& ctx) noexcept {
    ctx.loads.clear();
    if (ctx.actors == nullptr) return Status::ok;
    const Status status = ctx.actors->act(ctx);
    if (status == Status::ok && ctx.loads.any())
        ctx.loads.finish(ctx.bodies, ctx.def.step, ctx.pool);
    return status;
}

void accept_systems(StepContext& ctx) noexcept {
    ctx.loads.accept();
    if (ctx.actors != nullptr) ctx.actors->accept(ctx);
}

void take_back_systems(StepContext& ctx) noexcept {
    ctx.loads.take_back(ctx.bodies);
    if (ctx.actors != nullptr) ctx.actors->go_back(ctx);
}

double added_energy(StepContext& ctx, const double* v) noexcept {
    return ctx.loads.added_energy(ctx.bodies, v, ctx.pool);
}

void evaluate_rows(StepContext& ctx) noexcept {
    View v = view(ctx);
    v.v_start = nullptr;  // nothing is solved
    auto strip = [&](int i, int) noexcept { evaluate_strip(ctx, v, i); };
    ctx.pool.for_each(ctx.system.strips.count(), strip);
}

void evaluate_keeping_ranges(StepContext& ctx) noexcept {
    const KeptRanges kept(ctx.active_before, ctx.interactions.active.data(), ctx.system.bounded);
    evaluate_rows(ctx);
}

void assemble_rows(StepContext& ctx) noexcept {
    const StageTimer timer(ctx, Stage::assemble);
    ctx.losses_known = false;
    if (!ctx.wires.again) {
        release_wires(ctx);
        predict(ctx);
    }
    const View v = view(ctx);
    const assembly::Kernels& k = assembly::kernels();
    hold_bounds(ctx, ctx.def.step);
    choose_completed(ctx);
    const bool completes = ctx.completion.any;
    const bool moving = starts_moving(ctx);
    View rows = v;
    // PGS measures its solution without renewing what v₊ does.
    if (!moving && ctx.def.nonsmooth != Nonsmooth::pgs) rows.v_start = nullptr;
    sweep(
        ctx,
        [&](int strip) {
            evaluate_strip(ctx, rows, strip);
            replan_wires(ctx, rows, strip);
            if (completes) (void)complete_strip(ctx, v, strip, v.v_start, true);
            each(ctx.system.strips.interactions(strip),
                 [&](std::int32_t a, std::int32_t b) { k.first_rhs(v, a, b, moving); });
        },
        [&](std::int32_t a, std::int32_t b, int) {
            k.body_terms(v, a, b);
            ctx.loads.add_terms(v, a, b);
            if (completes) (void)k.complete_spins(v, a, b, v.v_start, true);
            k.first_body_rhs(v, a, b, moving);
        });
    ctx.rhs_ready = true;
}

void integrate(StepContext& ctx) noexcept {
    const View v = view(ctx);
    finish_cuts(ctx);
    ctx.drive += drive_work(ctx);
    ctx.damped += row_losses(ctx);
    settle_wires(ctx);
    count_contact_work(ctx);
    if (ctx.collider.count() > 0) remember_contacts(ctx);
    ctx.drag += ctx.loads.count();
    over(ctx, v.body_count,
         [&](std::int32_t a, std::int32_t b) { assembly::kernels().integrate(v, a, b); });
    move_carriers(ctx);
    ctx.work += ctx.step_work;
    ctx.drag += ctx.step_drag;
    ++ctx.step;
    ctx.time = static_cast<double>(ctx.step) * ctx.def.step;
    ctx.stats.step = ctx.step;
    ctx.stats.time = ctx.time;
    const double per_h = 1.0 / ctx.def.step;
    over(ctx, ctx.interactions.row_count, [&](std::int32_t a, std::int32_t b) {
        for (std::int32_t r = a; r < b; ++r) v.force_of_row[r] = per_h * v.lambda[r];
    });
    if (ctx.newton.switch_late) (void)switch_bounds(ctx, ctx.contact_floor, kAnyRows);
    ctx.newton.switch_late = false;
    for (std::size_t i = 0; i < ctx.system.breakable.size(); ++i) {
        const std::int32_t id = ctx.system.breakable[i];
        const double tension = -v.force_of_row[v.row_begin[id]];
        if (v.parted[id] || tension <= ctx.system.breaking_load[i]) continue;
        ctx.damped += held_by_line(ctx, original(ctx, id));
        part_all(ctx, original(ctx, id));
        push_event(ctx, EventKind::line_break, original(ctx, id), tension);
    }
    for (std::size_t i = 0; i < ctx.active_before.size(); ++i) {
        std::int32_t id = ctx.system.bounded[i];
        const double now = v.active[id];
        if (now == ctx.active_before[i] || v.parted[id]) continue;
        if (v.flags[id] & (model::kMotor | model::kFriction)) continue;
        const std::int32_t row = v.row_begin[id];
        id = speaker(ctx, id);  // of the sides of a cut one
        if (id < 0) continue;
        if (v.flags[id] & model::kRange) {
            if (now != 0.0) push_event(ctx, EventKind::range, id, v.g[row]);
        } else {
            push_event(ctx, now != 0.0 ? EventKind::taut : EventKind::slack, id,
                       now != 0.0 ? -v.force_of_row[row] : 0.0);
        }
    }
    // Renews rows, so that events come first; anchors and winches go by the poses then.
    close_joints(ctx);
    finish_completion(ctx);
    move_anchors(ctx);
    report_saturation(ctx);
    follow_winches(ctx);
    // Above this the solution no longer satisfies its own equations to engineering accuracy.
    constexpr double kResidualWarning = 1e-8;
    if (ctx.stats.momentum_residual > kResidualWarning)
        push_event(ctx, EventKind::warning, -1, ctx.stats.momentum_residual);
}

}  // namespace hawser::stepper
