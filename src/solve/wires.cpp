// SPDX-License-Identifier: Apache-2.0
#include "solve/wires.h"

#include "base/index.h"
#include "context/copies.h"
#include "context/wire_alerts.h"
#include "context/wires_data.h"

#include <algorithm>
#include <cmath>

namespace hawser::solve {
namespace {

constexpr std::int32_t kPartSize = 64;  ///< Number of elements or nodes in one part.
/// Steps after which all but a third of a loss no longer comes back. The stiffness takes energy
/// from a vibration with few steps per period and returns it a quarter of a period later. This
/// exceeds the limit of the guard.
constexpr double kAllowanceSteps = 240.0;

bool is_element(const context::Model& model, std::int32_t id) {
    const model::Interactions& in = model.interactions;
    if (in.gone(id)) return false;
    const KindInfo& kind = kind_info(in.kinds[at(id)]);
    if (!kind.is(kAlongLine) || kind.is(kWoundUp)) return false;
    // A rod is not an element; a spring between two points is.
    if (!kind.is(kWireElement) &&
        !(in.epsilon[at(in.row_begin[at(id)])] > model::kElasticCompliance))
        return false;
    const std::int32_t* body = &in.body[at(kMaxInteractionBodies * id)];
    return model.bodies.dof(body[0]) == 3 || model.bodies.dof(body[1]) == 3;
}

/// Return the smallest index that is connected with index i (union-find).
std::int32_t root_of(std::vector<std::int32_t>& joined, std::int32_t i) {
    while (joined[at(i)] != i) {
        joined[at(i)] = joined[at(joined[at(i)])];
        i = joined[at(i)];
    }
    return i;
}

/// Assign elements with common nodes to one wire. The result for each interaction is the first
/// element of its wire; −1: not an element.
void join_elements(const context::Model& model, std::int32_t count, context::WireWork& work) {
    const model::Interactions& in = model.interactions;
    std::vector<std::int32_t>& joined = work.joined;
    joined.resize(at(count));
    work.of_body.assign(at(model.bodies.count()), -1);
    for (std::int32_t id = 0; id < count; ++id) {
        joined[at(id)] = is_element(model, id) ? id : -1;
        for (int b = 0; b < 2 && joined[at(id)] >= 0; ++b) {
            const std::int32_t body = in.body[at(kMaxInteractionBodies * id + b)];
            if (model.bodies.dof(body) != 3) continue;
            std::int32_t& first = work.of_body[at(body)];
            if (first < 0) first = id;
            const std::int32_t p = root_of(joined, first), q = root_of(joined, id);
            joined[at(std::max(p, q))] = std::min(p, q);
        }
    }
    for (std::int32_t id = 0; id < count; ++id)
        if (joined[at(id)] >= 0) joined[at(id)] = root_of(joined, id);
}

/// List the elements by wire: wires by their first element, elements ascending.
void list_elements(std::int32_t count, context::WireWork& work) {
    context::Wires& made = work.made;
    made.wire_of.assign(at(count), -1);
    made.place.assign(at(count), -1);
    std::vector<std::int32_t>& begin = work.begin;
    begin.assign(1, 0);
    for (std::int32_t id = 0; id < count; ++id) {
        if (work.joined[at(id)] < 0) continue;
        std::int32_t& wire = made.wire_of[at(id)];
        // that of the first element, which has the lowest index
        wire = made.wire_of[at(work.joined[at(id)])];
        if (wire < 0) {
            wire = static_cast<std::int32_t>(begin.size()) - 1;
            begin.push_back(0);
        }
        ++begin[at(wire) + 1];
    }
    for (std::size_t k = 1; k < begin.size(); ++k) begin[k] += begin[k - 1];
    made.element.resize(at(begin.back()));
    work.cursor.assign(begin.begin(), begin.end() - 1);
    for (std::int32_t id = 0; id < count; ++id) {
        if (made.wire_of[at(id)] < 0) continue;
        made.place[at(id)] = work.cursor[at(made.wire_of[at(id)])]++;
        made.element[at(made.place[at(id)])] = id;
    }
}

/// List the nodes of each wire, and divide elements and nodes into tasks.
void make_parts(const context::Model& model, context::WireWork& work) {
    context::Wires& w = work.made;
    const model::Interactions& in = model.interactions;
    work.seen.assign(at(model.bodies.count()), 0);
    w.lump.clear();
    w.parts.clear();
    for (std::size_t k = 0; k + 1 < work.begin.size(); ++k) {
        const std::int32_t element = work.begin[k], end = work.begin[k + 1];
        const auto lump = static_cast<std::int32_t>(w.lump.size());
        for (std::int32_t e = element; e < end; ++e)
            for (int b = 0; b < 2; ++b) {
                const std::int32_t body = in.body[at(kMaxInteractionBodies * w.element[at(e)] + b)];
                if (model.bodies.dof(body) != 3 || work.seen[at(body)]) continue;
                work.seen[at(body)] = 1;
                w.lump.push_back(body);
            }
        const auto node_elements_end = static_cast<std::int32_t>(w.lump.size());
        for (std::int32_t e = element, l = lump; e < end || l < node_elements_end;
             e += kPartSize, l += kPartSize)
            w.parts.push_back({static_cast<std::int32_t>(k), std::min(e, end),
                               std::min(e + kPartSize, end), std::min(l, node_elements_end),
                               std::min(l + kPartSize, node_elements_end)});
    }
}

}  // namespace

bool on_guard(const context::Model& model) noexcept {
    return model.wires.count() > 0 && !context::has_cuts(model) &&
           model.def.geometric_stiffness > 0.0;
}

void release_wires(context::Model& model) noexcept {
    context::Wires& w = model.wires;
    if (!w.replacing) return;
    for (const std::int32_t id : w.element) {
        if (!w.replaced[at(id)]) continue;
        w.replaced[at(id)] = 0;
        if (!(model.interactions.flags[at(id)] & model::kOneSided))
            model.interactions.active[at(id)] = 1.0;
    }
    w.replacing = false;
}

namespace {

/// Transfer the state of wires (energy allowance, flags, recoil) after their elements have changed.
/// Each element keeps its part of the state of its former wire.
void transfer_wire_state(const context::Model& model, const context::State& state,
                         context::WireWork& work) {
    const context::Wires& w = model.wires;
    context::Wires& made = work.made;
    if (w.wire_of == made.wire_of && state.edits.interactions.empty()) {
        made.energy_allowance = w.energy_allowance;
        made.flag_steps = w.flag_steps;
        made.recoil = w.recoil;
        return;
    }
    if (!state.edits.any) return;
    std::vector<std::int32_t>& had = work.had;
    had.assign(w.count(), 0);
    for (const std::int32_t wire : w.wire_of)
        if (wire >= 0) ++had[at(wire)];
    const std::vector<std::int32_t>& added = state.edits.interactions;
    for (std::size_t k = 0; k + 1 < work.begin.size(); ++k) {
        std::int32_t first = -1, kept = 0;
        bool one = true;
        for (std::int32_t e = work.begin[k]; e < work.begin[k + 1]; ++e) {
            const std::int32_t id = made.element[at(e)];
            const bool is_new = at(id) >= w.wire_of.size() ||
                                std::find(added.begin(), added.end(), id) != added.end();
            const std::int32_t wire = is_new ? -1 : w.wire_of[at(id)];
            if (wire < 0) continue;
            one = one && (first < 0 || wire == first);
            if (first < 0) first = wire;
            ++kept;
            made.energy_allowance[k] += w.energy_allowance[at(wire)] / had[at(wire)];
            made.flag_steps[k] = std::max(made.flag_steps[k], w.flag_steps[at(wire)]);
            made.recoil[k] = context::longer_recoil(made.recoil[k], w.recoil[at(wire)]);
        }
        // Keep the exact bits if it is still the same wire.
        if (kept > 0 && one && kept == had[at(first)])
            made.energy_allowance[k] = w.energy_allowance[at(first)];
    }
}

}  // namespace

void make_wires(context::Model& model, const context::State& state, context::WireWork& work) {
    const std::int32_t count = context::interaction_count(model);
    join_elements(model, count, work);
    context::Wires& made = work.made;
    list_elements(count, work);
    const std::size_t wires = work.begin.size() - 1;
    made.energy_allowance.assign(wires, 0.0);
    made.flag_steps.assign(wires, 0);
    made.recoil.assign(wires, 0);
    transfer_wire_state(model, state, work);
    made.fast.assign(wires, 0);
    made.level.assign(wires, 0);
    made.gain.assign(wires, {});
    make_parts(model, work);
    made.part_gain.assign(made.parts.size(), {});
    made.pull.assign(made.element.size(), 0.0);
    made.holds.assign(made.element.size(), 0);
    made.replaced.assign(at(model.interactions.count()), 0);
    made.again = made.replacing = made.measured = made.stale = false;
    std::swap(model.wires, made);
    context::update_wire_flags(model);
}

void remember_gains(context::Model& model) noexcept {
    context::Wires& w = model.wires;
    for (std::int32_t& left : w.recoil) {
        if (left <= 0) continue;
        --left;
        if (left == 0) w.stale = true;
    }
    if (w.stale) context::update_wire_flags(model);
    if (!on_guard(model)) return;
    const bool any_fast = w.measured;
    constexpr double kept = 1.0 - 1.0 / kAllowanceSteps;
    const std::int32_t flag_steps = context::max_flag_steps(model.def.step);
    for (std::size_t k = 0; k < w.count(); ++k) {
        const double lost = any_fast && w.fast[k] ? -w.gain[k].gain : 0.0;
        w.energy_allowance[k] =
            std::isfinite(lost) ? kept * std::max(0.0, w.energy_allowance[k] + lost) : 0.0;
        const std::int32_t before = w.flag_steps[k];
        w.flag_steps[k] = any_fast && w.level[k] > 0 ? flag_steps : std::max(0, before - 1);
        if ((before > 0) != (w.flag_steps[k] > 0)) w.stale = true;
    }
    if (w.stale) context::update_wire_flags(model);
}

}  // namespace hawser::solve
