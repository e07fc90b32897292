// SPDX-License-Identifier: Apache-2.0
#include "stepper/completion.h"

#include "base/index.h"
#include "graph/bridges.h"
#include "stepper/bounds.h"
#include "stepper/contact.h"
#include "stepper/newton.h"
#include "stepper/rows.h"
#include "stepper/stages.h"
#include "stepper/step.h"
#include "stepper/sweeps.h"
#include "stepper/timer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hawser::stepper {
namespace {

using assembly::Turning;
using assembly::View;

/// A round's change below which the step has ended [m/s or rad/s], of bodies that turn by up to
/// kSlowTurn [rad/s]; of faster ones with the cube of that. Near singular poses of closed loops
/// less would only add rounding, but who asks for solutions below kSolution gets it.
constexpr double kTurning = 1e-7, kSlowTurn = 5.0, kSolution = 1e-10;
constexpr int kMostRounds = 12;
constexpr double kGap = 1e-4;                 ///< Largest gap that a step may leave [m or rad].
constexpr double kResolved = 1.5;             ///< s up to which joints are completed.
constexpr double kTooFast = 2.0 * kResolved;  ///< s by the step's own force that ends a trial.
constexpr std::uint8_t kCoarse = 60;          ///< Steps for which one beyond is not.

/// s of a joint under its impulse, h² f max(r/I). @param lambdas  By row.
double swing_number(const StepContext& ctx, std::int32_t id, const double* lambdas) noexcept {
    const model::Interactions& in = ctx.interactions;
    const double* lambda = lambdas + in.row_begin[at(id)];
    double square = 0.0;
    for (int r = 0; r < std::min<int>(in.rows[at(id)], 3); ++r) square += lambda[r] * lambda[r];
    return ctx.def.step * std::sqrt(square) * in.swing[at(id)];
}

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

/// The equations take what they are about v₊.
void adopt(StepContext& ctx) noexcept {
    const View v = view(ctx);
    const std::vector<std::int32_t>& joints = ctx.completion.joints;
    over(ctx, static_cast<std::int32_t>(joints.size()), [&](std::int32_t a, std::int32_t b) {
        assembly::kernels().adopt_completed(v, joints.data(), a, b);
    });
    over(ctx, v.body_count,
         [&](std::int32_t a, std::int32_t b) { assembly::kernels().adopt_spins(v, a, b); });
}

/// What the equations are about v₊ as it stands. @return how much their right-hand sides changed.
Turning renew(StepContext& ctx) noexcept {
    const View v = view(ctx);
    const assembly::Strips& strips = ctx.system.strips;
    auto& parts = ctx.turnings;  // one a strip or group
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

/// Rounds with the factorisation at hand. @return how the last one ended; not finite or too large:
/// they did not converge.
Turning make_rounds(StepContext& ctx) noexcept {
    double first = 0.0;
    const double enough = kTurning * std::min(1.0, ctx.def.solution_tolerance / kSolution);
    const auto ended = [enough](const Turning& turning) {
        const double fast = std::max(1.0, turning.spin / kSlowTurn);
        return turning.change <= enough * fast * fast * fast;
    };
    Turning t = renew(ctx);
    for (int round = 0; round < kMostRounds && !ended(t); ++round) {
        adopt(ctx);
        continue_with_factor(ctx);
        ctx.losses_known = false;
        ++ctx.stats.completion_rounds;
        t = renew(ctx);
        if (round == 0) first = t.change;
        constexpr double kGrowth = 4.0;
        if (!std::isfinite(t.change) || (round > 1 && t.change > kGrowth * first)) {
            t.gap = 1e300;
            break;
        }
    }
    ctx.stats.completion_change = t.change;
    return t;
}

/// Solve the step again, with the joints that choose_completed() now chooses.
Status assemble_and_solve(StepContext& ctx) noexcept {
    if (ctx.collider.count() > 0)
        if (const Status s = start_contacts(ctx, Phase::regular); s != Status::ok) return s;
    assemble_rows(ctx);
    return solve_linear(ctx);
}

/// The same with all joints linearised once.
Status solve_linearised(StepContext& ctx) noexcept {
    ctx.completion.banned = true;
    ++ctx.stats.completion_failures;
    recall(ctx);
    return assemble_and_solve(ctx);
}

/// Joints whose force has grown within the step beyond what it was solved with: completed ones that
/// swing too fast now, and others whose stiffness was that of a much smaller force.
/// @return whether there are.
bool outgrown(StepContext& ctx) noexcept {
    Completion& c = ctx.completion;
    bool found = false;
    for (std::size_t k = 0; k < c.joints.size(); ++k) {
        const std::int32_t id = c.joints[k];
        // The force of what repeats others is not known before the filter.
        if (ctx.interactions.repeats[at(id)]) continue;
        const double now = swing_number(ctx, id, ctx.interactions.lambda.data());
        if (ctx.interactions.completed[at(id)]) {
            if (now <= kTooFast) continue;
            c.refused[k] = 1;
        } else {
            constexpr double kGrown = 1.5;
            const double with = swing_number(ctx, id, c.lambda_with.data());
            if (now <= kResolved || now <= kGrown * with) continue;
        }
        found = true;
    }
    return found;
}

/// Solve the step again with the stiffness of the forces that have been found, where they are
/// larger.
Status solve_with_new_forces(StepContext& ctx) noexcept {
    model::Interactions& in = ctx.interactions;
    Completion& c = ctx.completion;
    for (const std::int32_t id : c.joints) {
        const bool larger =
            swing_number(ctx, id, in.lambda.data()) > swing_number(ctx, id, c.lambda_with.data());
        const auto row = in.row_begin[at(id)];
        if (larger) std::copy_n(&in.lambda[at(row)], in.rows[at(id)], &c.lambda_with[at(row)]);
    }
    recall(ctx);
    ++ctx.stats.restiffened;
    for (const std::int32_t id : c.joints)
        std::copy_n(&c.lambda_with[at(in.row_begin[at(id)])], in.rows[at(id)],
                    &in.lambda[at(in.row_begin[at(id)])]);
    return assemble_and_solve(ctx);
}

/// A number in [−½, ½) that belongs to a row: without a pattern, and the same on every machine.
double drawn(std::int32_t row) noexcept {
    std::uint64_t x = static_cast<std::uint64_t>(row) + 1;
    x *= 0x9e3779b97f4a7c15;  // J. S. Steele et al., SplitMix (2014)
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return static_cast<double>((x ^ (x >> 31)) >> 11) * 0x1p-53 - 0.5;
}

/// u of K [u; −λ'] = [Gᵀλ; 0], into the solver's vector, for the impulses λ(row) of some joints.
template <class Lambda>
void push_joints(StepContext& ctx, const View& v, Lambda lambda) noexcept {
    const StageTimer timer(ctx, Stage::factor);
    std::fill_n(v.solution, ctx.system.symbolic.scalars, 0.0);
    for (const std::int32_t id : ctx.completion.looped) {
        double room[model::kArmRoom];
        const double* jac = packed_rows(v, id, room);
        for (int r = 0; r < v.rows[id]; ++r) {
            const double push = lambda(id, v.row_begin[id] + r);
            for (int b = 0; b < v.bodies[id]; ++b) {
                const std::int32_t body = v.body[kMaxInteractionBodies * id + b];
                for (int j = 0; j < v.dof[body]; ++j)
                    v.solution[v.body_offset[body] + j] += push * *jac++;
            }
        }
    }
    ctx.system.numeric.solve(ctx.system.symbolic, v.solution, ctx.pool);
    ++ctx.stats.substitutions;
    ctx.rhs_ready = false;
}

/// λ' of one joint then.
void read_filtered(const View& v, std::int32_t id, double* out) noexcept {
    double room[model::kArmRoom];
    const double* jac = packed_rows(v, id, room);
    for (int r = 0; r < v.rows[id]; ++r) {
        const double speed = along_row(v, id, jac, v.solution, v.body_offset);
        out[r] = v.interaction_offset[id] >= 0 ? v.solution[v.interaction_offset[id] + r]
                                               : speed * v.inv_sigma[v.row_begin[id] + r];
    }
}

/// Whether the filter changes the impulse λ(row) of a joint by more than a hundredth; `kept`: it
/// filtered.
template <class Lambda>
bool is_changed(const View& v, std::int32_t id, Lambda lambda, double* kept) noexcept {
    constexpr double kShare = 0.01;
    double all = 0.0, less = 0.0;
    read_filtered(v, id, kept);
    for (int r = 0; r < v.rows[id]; ++r) {
        const double whole = lambda(id, v.row_begin[id] + r), d = whole - kept[r];
        all += whole * whole;
        less += d * d;
    }
    return less > kShare * kShare * all;
}

/// Which joints in loops repeat others now: those of which impulses drawn at random lose something
/// in the filter.
void probe_loops(StepContext& ctx) noexcept {
    const View v = view(ctx);
    const auto random = [](std::int32_t, std::int32_t row) noexcept { return drawn(row); };
    push_joints(ctx, v, random);
    for (const std::int32_t id : ctx.completion.looped) {
        double kept[kMaxInteractionRows];
        ctx.interactions.repeats[at(id)] = is_changed(v, id, random, kept) ? 1 : 0;
    }
}

void take_self_stress(StepContext& ctx) noexcept {
    constexpr std::int64_t kEvery = 16;  // steps: loops that become singular do so gradually
    const std::vector<std::int32_t>& looped = ctx.completion.looped;
    if (looped.empty()) return;
    if (!ctx.started || ctx.step % kEvery == 0) probe_loops(ctx);
    std::uint8_t* repeats = ctx.interactions.repeats.data();
    if (std::none_of(looped.begin(), looped.end(), [&](std::int32_t id) { return repeats[id]; }))
        return;
    const View v = view(ctx);
    const auto impulse = [&](std::int32_t id, std::int32_t row) noexcept {
        return repeats[id] ? v.lambda[row] : 0.0;
    };
    push_joints(ctx, v, impulse);
    for (const std::int32_t id : looped) {
        double kept[kMaxInteractionRows];
        if (!repeats[id] || !is_changed(v, id, impulse, kept)) continue;
        ++ctx.stats.undetermined;
        for (int r = 0; r < v.rows[id]; ++r) {
            const std::int32_t row = v.row_begin[id] + r;
            // What the row's equation lacks by that is not a residual: the impulse moves nothing.
            v.residual[row] += v.sigma[row] * (v.lambda[row] - kept[r]);
            v.lambda[row] = kept[r];
        }
    }
}

/// Refinement, and rows at their bounds that rounds have moved across.
Status settle_free(StepContext& ctx) noexcept {
    constexpr int kMost = 4;
    Status status = Status::ok;
    for (int i = 0; i < kMost && status == Status::ok; ++i) {
        status = settle_rounds(ctx, ctx.stats.completion_rounds == 0);
        const std::int32_t before = ctx.stats.factorisations;
        if (status == Status::ok) status = settle_bounds(ctx);
        if (ctx.stats.factorisations == before || status != Status::ok) break;
        (void)make_rounds(ctx);
    }
    return status;
}

/// The same of contacts: their laws where rounds have moved them.
Status settle_touching(StepContext& ctx) noexcept {
    if (ctx.stats.completion_rounds == 0) return Status::ok;
    return settle_newton(ctx);
}

}  // namespace

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
                c.refused[at(k)] || !(swing_number(ctx, id, in.lambda.data()) <= kResolved);
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

Status complete(StepContext& ctx) noexcept {
    Status status = Status::ok;
    constexpr int kMostGrowths = 2;  // times that a step is solved again for them
    if (ctx.started)
        for (int i = 0; i < kMostGrowths && status == Status::ok && outgrown(ctx); ++i)
            status = solve_with_new_forces(ctx);
    if (ctx.completion.any && status == Status::ok) {
        const Turning t = make_rounds(ctx);
        if (!(t.gap <= kGap))
            status = solve_linearised(ctx);
        else if (ctx.system.contacts.count() > 0)
            status = settle_touching(ctx);
        else
            status = settle_free(ctx);
    }
    if (status == Status::ok) take_self_stress(ctx);
    return status;
}

void finish_completion(StepContext& ctx) noexcept {
    Completion& c = ctx.completion;
    for (std::size_t k = 0; k < c.joints.size(); ++k)
        ctx.interactions.coarse[at(c.joints[k])] = c.coarse_next[k];
}

}  // namespace hawser::stepper
