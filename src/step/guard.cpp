// SPDX-License-Identifier: Apache-2.0
#include "step/guard.h"

#include "base/index.h"
#include "contact/newton.h"
#include "context/copies.h"
#include "context/view.h"
#include "context/wires_data.h"
#include "solve/wire_energy.h"
#include "solve/wire_plan.h"
#include "solve/wires.h"
#include "step/assemble_rows.h"
#include "step/completion.h"
#include "step/contact.h"

#include <algorithm>
#include <utility>

namespace hawser::step {
namespace {

using assembly::View;

constexpr int kMaxRepeats = 7;     ///< See guard.h.
constexpr double kMayGain = 1e-3;  ///< Limit of the gain relative to the exchanged energy.

bool accepted(const context::Wires& w, std::size_t wire) noexcept {
    const context::WireGain& g = w.gain[wire];
    return !w.fast[wire] || g.gain <= kMayGain * g.exchanged + g.noise + w.energy_allowance[wire];
}

/// True if a bounded row belongs to a wire that was rejected in this step.
bool on_rejected_wire(const context::Model& model, std::int32_t id) noexcept {
    const context::Wires& w = model.wires;
    const std::int32_t wire = id < context::interaction_count(model) ? w.wire_of[at(id)] : -1;
    return wire >= 0 && w.level[at(wire)] != 0;
}

/// Restore the initial multipliers, on which the geometric stiffness depends, and the state of
/// lines. Lines of rejected wires keep their latest state.
/// @param warm  The repeated solve starts from the rejected solution: lines keep their state.
void restore_start(context::Model& model, context::Before& kept, bool warm) noexcept {
    model::Interactions& in = model.interactions;
    std::copy(kept.lambda.begin(), kept.lambda.end(), in.lambda.begin());
    // Joints whose force has grown within the step keep the stiffness of the larger force.
    for (const std::int32_t id : model.completion.joints)
        std::copy_n(&model.completion.lambda_with[at(in.row_begin[at(id)])], in.rows[at(id)],
                    &in.lambda[at(in.row_begin[at(id)])]);
    for (std::size_t i = 0; i < kept.active.size() && !warm; ++i) {
        const std::int32_t id = model.system.bounded[i];
        if (!on_rejected_wire(model, id)) in.active[at(id)] = kept.active[i];
    }
}

/// Exchange the active flags of bounded rows with those at the start of the step, except on
/// rejected wires.
void exchange_states(context::Model& model, context::Before& kept) noexcept {
    for (std::size_t i = 0; i < kept.active.size(); ++i) {
        const std::int32_t id = model.system.bounded[i];
        if (!on_rejected_wire(model, id))
            std::swap(model.interactions.active[at(id)], kept.active[i]);
    }
}

/// Mark the elements of wires whose replacement level requires bounded rows.
void replace(context::Model& model) noexcept {
    context::Wires& w = model.wires;
    constexpr int kFirstBound = 4;
    for (const std::int32_t id : w.element) {
        if (w.level[at(w.wire_of[at(id)])] < kFirstBound || model.interactions.parted[at(id)] ||
            model.system.rests(id))
            continue;
        w.replaced[at(id)] = 1;
        w.replacing = true;
    }
}

Status solve_again(context::StepContext& ctx) noexcept {
    ++ctx.work.stats.wire_repeats;
    // Few contacts change with the rejected wire: its solution is closer than the last step's.
    const bool warm = contact::save_contact_solution(ctx.model, ctx.work);
    solve::release_wires(ctx.model);
    restore_start(ctx.model, ctx.work.before, warm);
    replace(ctx.model);
    ctx.model.wires.again = true;
    Status status = Status::ok;
    if (ctx.model.collider.count() > 0) status = start_contacts(ctx, Phase::regular);
    if (status == Status::ok) {
        if (warm) contact::restart_newton(ctx);
        // Stiffness and right-hand side belong to the start of the step, as in the first solve: a
        // line that became slack in the rejected solution still has the stiffness of its tension.
        if (warm) exchange_states(ctx.model, ctx.work.before);
        assemble_rows(ctx);
        if (warm) exchange_states(ctx.model, ctx.work.before);
        status = solve_assembled(ctx);
    }
    ctx.model.wires.again = false;
    if (status != Status::ok) solve::release_wires(ctx.model);
    return status;
}

/// Set the next replacement of the rows of each rejected wire. @return true if at least one wire
/// has another replacement.
bool refuse(context::Model& model, const context::Before& kept) noexcept {
    context::Wires& w = model.wires;
    bool any = false;
    for (std::size_t k = 0; k < w.count(); ++k) {
        if (accepted(w, k) || w.level[k] >= kMaxRepeats) continue;
        const auto wire = static_cast<std::int32_t>(k);
        const bool first = w.level[k] == 0;
        solve::plan_wires(model, kept, wire);
        // For wires that may touch, the first plan fails about half of the time, so two are applied
        // at once (guard.h).
        if (first && solve::may_touch(model, wire)) solve::plan_wires(model, kept, wire);
        any = true;
    }
    return any;
}

}  // namespace

void keep_start_velocities(context::Model& model, const context::Before& kept) noexcept {
    if (!solve::on_guard(model)) return;
    context::Wires& w = model.wires;
    const View v = context::row_view(model);
    std::fill(w.fast.begin(), w.fast.end(), 0);
    if (!solve::find_fast_wires(model, kept)) return;
    for (const context::WirePart& p : w.parts) {
        if (!w.fast[at(p.wire)]) continue;
        for (std::int32_t i = p.node_elements_begin; i < p.node_elements_end; ++i) {
            const std::int32_t begin = v.dof_begin[w.lump[at(i)]];
            if (v.dof[w.lump[at(i)]] == 3) std::copy_n(v.v_ahead + begin, 3, v.v + begin);
        }
    }
}

Status guard_wires(context::StepContext& ctx) noexcept {
    ctx.model.wires.measured = false;
    if (!solve::on_guard(ctx.model)) return Status::ok;
    context::Wires& w = ctx.model.wires;
    std::fill(w.fast.begin(), w.fast.end(), 0);
    std::fill(w.level.begin(), w.level.end(), 0);
    const bool any_fast = solve::find_fast_wires(ctx.model, ctx.work.before);
    if (any_fast) {
        solve::measure_wires(ctx.model, ctx.pool);
        while (refuse(ctx.model, ctx.work.before)) {
            const Status status = solve_again(ctx);
            if (status != Status::ok) return status;
            (void)solve::find_fast_wires(ctx.model, ctx.work.before);
            solve::measure_wires(ctx.model, ctx.pool);
        }
    }
    ctx.model.wires.measured = any_fast;
    return Status::ok;
}

}  // namespace hawser::step
