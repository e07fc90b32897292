// SPDX-License-Identifier: Apache-2.0
#include "stepper/stages.h"

#include "stepper/drives.h"
#include "stepper/step.h"

#include <algorithm>
#include <cmath>

namespace hawser::stepper {
namespace {

using assembly::Norms;
using assembly::View;

constexpr std::int32_t kChunk = StepContext::kChunk;
std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// Run f(begin, end) over chunks of [0, count).
template <class F>
void over(StepContext& ctx, std::int32_t count, F&& f) noexcept {
    auto task = [&](int i, int) noexcept { f(i * kChunk, std::min((i + 1) * kChunk, count)); };
    ctx.pool.for_each(StepContext::chunks(count), task);
}

/// Merge in order, so that sums do not depend on threads.
Norms merged(const std::vector<Norms>& parts) noexcept {
    Norms n;
    for (const Norms& p : parts) {
        n.momentum += p.momentum;
        n.impulse += p.impulse;
        n.work += p.work;
        n.drag += p.drag;
        n.finite += p.finite;
        if (!(p.constraint <= n.constraint)) n.constraint = p.constraint;
        if (!(p.stretch <= n.stretch)) n.stretch = p.stretch;
        if (p.gap > n.gap) {
            n.gap = p.gap;
            n.gap_id = p.gap_id;
        }
    }
    return n;
}

/// Call f for each of some ranges.
template <class F>
void each(std::span<const assembly::IndexRange> ranges, F&& f) noexcept {
    for (const assembly::IndexRange& r : ranges) f(r.begin, r.end);
}

/// rows(strip), then own(begin, end) for the strip's own bodies, strip by strip; then own() for
/// the shared bodies. The last argument of own() is a place in ctx.norms; that of the rows is
/// `strip`.
template <class Rows, class Own>
void sweep(StepContext& ctx, Rows&& rows, Own&& own) noexcept {
    const assembly::Strips& strips = ctx.system.strips;
    auto strip = [&](int i, int) noexcept {
        rows(i);
        each(strips.bodies(i), [&](std::int32_t a, std::int32_t b) { own(a, b, i); });
    };
    auto group = [&](int i, int) noexcept {
        each(strips.shared(i),
             [&](std::int32_t a, std::int32_t b) { own(a, b, strips.count() + i); });
    };
    ctx.pool.for_each(strips.count(), strip);
    ctx.pool.for_each(strips.groups(), group);
}

void evaluate_strip(StepContext& ctx, const View& v, int strip) noexcept {
    for (const assembly::PoolRange& r : ctx.system.strips.pools(strip)) {
        const model::Pool& pool = ctx.interactions.pool[static_cast<std::size_t>(r.kind)];
        assembly::kernels().evaluate(v, r.kind, pool.ids.data(), pool.data.data(), r.begin, r.end);
    }
}

/// Right-hand side of the first solve, from rows and body terms.
void start_solve(StepContext& ctx, const View& v) noexcept {
    const assembly::Kernels& k = assembly::kernels();
    sweep(
        ctx,
        [&](int strip) {
            each(ctx.system.strips.interactions(strip),
                 [&](std::int32_t a, std::int32_t b) { k.first_rhs(v, a, b); });
        },
        [&](std::int32_t a, std::int32_t b, int) { k.first_body_rhs(v, a, b); });
    ctx.rhs_ready = true;
}

/// What follows a correction of v₊ and λ.
enum class Next { solve, measure };

/// One solve with the current residuals, the first one having been substituted forward already: v₊,
/// λ corrected, residuals renewed. Then either the right-hand side of another one, or the norms of
/// the solution as it stands.
Norms correct(StepContext& ctx, const View& v, bool first, Next next) noexcept {
    const assembly::Kernels& k = assembly::kernels();
    const assembly::Strips& strips = ctx.system.strips;
    if (first)
        ctx.system.numeric.backward(ctx.system.symbolic, v.solution, ctx.pool);
    else
        ctx.system.numeric.solve(ctx.system.symbolic, v.solution, ctx.pool);
    auto add = [&](std::int32_t a, std::int32_t b) { k.add_solution(v, a, b); };
    auto add_shared = [&](int i, int) noexcept { each(strips.shared(i), add); };
    ctx.pool.for_each(strips.groups(), add_shared);
    if (next == Next::measure) std::fill(ctx.norms.begin(), ctx.norms.end(), Norms{});
    sweep(
        ctx,
        [&](int strip) {
            each(strips.bodies(strip), add);
            each(strips.interactions(strip), [&](std::int32_t a, std::int32_t b) {
                k.row_update(v, a, b, first);
                if (next == Next::measure) k.row_norms(v, a, b, &ctx.norms[at(strip)]);
            });
        },
        [&](std::int32_t a, std::int32_t b, int norm) {
            if (next == Next::measure)
                k.body_norms(v, a, b, &ctx.norms[at(norm)]);
            else
                k.body_rhs(v, a, b);
        });
    return next == Next::measure ? merged(ctx.norms) : Norms{};
}

/// G v₊ of a one-row interaction.
double row_speed(const View& v, std::int32_t id) noexcept {
    const double* jac = v.jacobian + v.jac_begin[id];
    double sum = 0.0;
    for (int b = 0; b < v.bodies[id]; ++b) {
        const std::int32_t body = v.body[kMaxInteractionBodies * id + b];
        for (int j = 0; j < v.dof[body]; ++j) sum += *jac++ * v.v_new[v.dof_begin[body] + j];
    }
    return sum;
}

}  // namespace

void push_event(StepContext& ctx, EventKind kind, std::int32_t id, double value) noexcept {
    ctx.events.push({ctx.time, kind, InteractionId{id}, value});
    ++ctx.stats.event_count[static_cast<std::size_t>(kind)];
}

View view(StepContext& ctx) noexcept {
    return ctx.system.view(ctx.bodies, ctx.interactions, ctx.def);
}

void prepare(StepContext& ctx) {
    ctx.analysed_x = ctx.bodies.x;
    ctx.analysed_r = ctx.bodies.r;
    ctx.system.analyse(ctx.bodies, ctx.interactions, ctx.def, ctx.pool.threads());
    ctx.norms.resize(at(ctx.system.strips.count() + ctx.system.strips.groups()));
    ctx.active_before.resize(ctx.system.one_sided.size());
    ctx.lambda_before.resize(ctx.interactions.lambda.size());
    ctx.carriers_before.resize(16 * ctx.bodies.driven.size());
    double mass = 0.0;
    for (std::int32_t b : ctx.bodies.moving) mass += ctx.bodies.mass[at(b)];
    // A millionth of the impulse of one gravity over a step: far below any real load.
    ctx.residual_floor = 1e-6 * ctx.def.step * 9.81 * std::sqrt(mass) + 1e-300;
    StepStats& s = ctx.stats;
    s.bodies = static_cast<std::int32_t>(ctx.bodies.moving.size());
    s.interactions = ctx.interactions.count();
    s.equations = ctx.bodies.dofs + ctx.interactions.row_count;
    s.islands = ctx.system.islands.count;
    s.matrix_nnz = ctx.system.symbolic.matrix_nnz;
    s.factor_nnz = ctx.system.symbolic.factor_nnz;
    s.factor_flops = ctx.system.symbolic.flops;
    ++s.growths;
    if (ctx.collider.count() > 0) {
        ctx.collider.prepare(ctx.bodies, ctx.interactions, ctx.def.step);
        ctx.collider.surfaces(ctx.def.step, ctx.contacts);
    }
    ctx.topology_changed = false;
}

void prestep(StepContext&) noexcept {}

void evaluate_rows(StepContext& ctx) noexcept {
    const View v = view(ctx);
    auto strip = [&](int i, int) noexcept { evaluate_strip(ctx, v, i); };
    ctx.pool.for_each(ctx.system.strips.count(), strip);
}

void assemble_rows(StepContext& ctx) noexcept {
    const View v = view(ctx);
    const assembly::Kernels& k = assembly::kernels();
    sweep(
        ctx,
        [&](int strip) {
            evaluate_strip(ctx, v, strip);
            each(ctx.system.strips.interactions(strip),
                 [&](std::int32_t a, std::int32_t b) { k.first_rhs(v, a, b); });
        },
        [&](std::int32_t a, std::int32_t b, int) {
            k.body_terms(v, a, b);
            k.first_body_rhs(v, a, b);
        });
    ctx.rhs_ready = true;
}

Status factor_and_solve(StepContext& ctx) noexcept {
    const View v = view(ctx);
    assembly::System& s = ctx.system;
    ++ctx.stats.factorisations;
    if (!ctx.rhs_ready) start_solve(ctx, v);
    ctx.rhs_ready = false;
    auto write = [&](int piece, double* panel) noexcept { s.write_blocks(v, piece, panel); };
    using Write = decltype(write);
    const factor::Fill fill{
        [](void* w, int piece, double* panel) noexcept { (*static_cast<Write*>(w))(piece, panel); },
        &write};
    if (s.numeric.factor_forward(s.symbolic, fill, v.solution, ctx.pool) > 0)
        return Status::wrong_pivot;
    Norms n;
    for (int i = 0; i <= ctx.def.refinements; ++i)
        n = correct(ctx, v, i == 0, i < ctx.def.refinements ? Next::solve : Next::measure);
    auto momentum = [&] {
        return std::sqrt(n.momentum) / std::max(std::sqrt(n.impulse), ctx.residual_floor);
    };
    // Stiff rows on very light bodies need one more; the residual says so.
    constexpr double kGood = 1e-12;
    for (int extra = 0; extra < 2 && ctx.def.refinements > 0 && momentum() > kGood; ++extra) {
        const Norms before = n;
        over(ctx, v.body_count,
             [&](std::int32_t a, std::int32_t b) { assembly::kernels().body_rhs(v, a, b); });
        n = correct(ctx, v, false, Next::measure);
        if (!(n.momentum < 0.25 * before.momentum)) break;
    }
    if (!std::isfinite(n.finite) || !std::isfinite(n.momentum)) return Status::not_finite;
    ctx.stats.momentum_residual = momentum();
    ctx.stats.constraint_residual = n.constraint;
    ctx.stats.violation_max = n.gap;
    ctx.stats.violation_worst = InteractionId{n.gap_id};
    ctx.stats.stretch_error_max = n.stretch;
    ctx.step_work = n.work;
    ctx.step_drag = n.drag;
    return Status::ok;
}

bool update_active_set(StepContext& ctx, int pass) noexcept {
    const View v = view(ctx);
    constexpr int kMaxPasses = 6;
    std::int32_t flips = 0;
    for (std::int32_t id : ctx.system.one_sided) {
        if (v.parted[id]) continue;
        const std::int32_t row = v.row_begin[id];
        const bool range = (v.flags[id] & model::kRange) != 0;
        if (range && v.g[row] == 0.0) continue;
        // A line pulls: λ < 0. A range pushes back: λ has the sign opposite to its violation.
        const double pull = range && v.g[row] < 0.0 ? -1.0 : 1.0;
        if (v.active[id] != 0.0) {
            if (pull * v.lambda[row] <= 0.0) continue;
            if (pass < kMaxPasses) v.active[id] = 0.0;
        } else {
            if (pull * (v.c[row] - row_speed(v, id)) >= 0.0) continue;
            // Switching back and forth ends at kMaxPasses and shows in flips_left.
            if (pass < kMaxPasses) v.active[id] = 1.0;
        }
        ++flips;
    }
    if (flips > 0) ctx.rhs_ready = false;
    ctx.stats.flips_left = pass < kMaxPasses ? 0 : flips;
    return flips > 0 && pass < kMaxPasses;
}

void integrate(StepContext& ctx) noexcept {
    const View v = view(ctx);
    ctx.drive += drive_work(ctx);
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
    for (std::size_t i = 0; i < ctx.system.breakable.size(); ++i) {
        const std::int32_t id = ctx.system.breakable[i];
        const double tension = -v.force_of_row[v.row_begin[id]];
        if (v.parted[id] || tension <= ctx.system.breaking_load[i]) continue;
        ctx.interactions.parted[at(id)] = 1;
        v.active[id] = 0.0;
        push_event(ctx, EventKind::line_break, id, tension);
    }
    for (std::size_t i = 0; i < ctx.active_before.size(); ++i) {
        const std::int32_t id = ctx.system.one_sided[i];
        const double now = v.active[id];
        if (now == ctx.active_before[i] || v.parted[id]) continue;
        const std::int32_t row = v.row_begin[id];
        if (v.flags[id] & model::kRange) {
            if (now != 0.0) push_event(ctx, EventKind::range, id, v.g[row]);
        } else {
            push_event(ctx, now != 0.0 ? EventKind::taut : EventKind::slack, id,
                       now != 0.0 ? -v.force_of_row[row] : 0.0);
        }
    }
    report_saturation(ctx);
    follow_winches(ctx);
    // Above this the solution no longer satisfies its own equations to engineering accuracy.
    constexpr double kResidualWarning = 1e-8;
    if (ctx.stats.momentum_residual > kResidualWarning)
        push_event(ctx, EventKind::warning, -1, ctx.stats.momentum_residual);
}

}  // namespace hawser::stepper
