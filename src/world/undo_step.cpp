// SPDX-License-Identifier: Apache-2.0
/// Undo of the edits of systems in a failed step (state/model_undo.h).
#include <hawser/changes.h>

#include "step/step.h"
#include "world/impl.h"

#include <exception>
#include <new>
#include <utility>

namespace hawser {

Status WorldImpl::run_step() noexcept {
    use.mark_stepping(true);
    rotate_forces();
    const Status ended = step::step(ctx);
    unrotate_forces();
    use.mark_stepping(false);
    return ended;
}

bool WorldImpl::begin_edits() noexcept {
    if (undo.holds) return true;
    try {
        save_for_undo(undo);
    } catch (const std::bad_alloc&) {
        return false;
    }
    return true;
}

void WorldImpl::save_for_undo(StepUndo& u) const {
    u.model.keep(ctx);
    u.body_defs = body_defs;
    u.shape_defs = shape_defs;
    u.inputs = inputs;
    u.input_values = input_values;
    u.input_slots = input_slots;
    u.input_ids = input_ids;
    u.groups.copy(groups);
    u.body_names.copy(body_names);
    u.interaction_names.copy(interaction_names);
    u.input_names.copy(input_names);
    u.material_names.copy(material_names);
    u.shape_names.copy(shape_names);
    u.body_ids = body_ids;
    u.interaction_ids = interaction_ids;
    u.shape_ids = shape_ids;
    u.wires = wires.wires;
    u.wire_slots = wires.slots;
    u.wire_names.copy(wires.names);
    u.wire_ids = wires.ids;
    u.gear = gear;
    u.force_inputs = force_inputs;
    u.local_inputs = local_inputs;
    u.holds = true;
}

void WorldImpl::restore_undo(StepUndo& u) noexcept {
    u.holds = false;
    u.model.go_back(ctx);
    body_defs.swap(u.body_defs);
    shape_defs.swap(u.shape_defs);
    inputs.swap(u.inputs);
    input_values.swap(u.input_values);
    std::swap(input_slots, u.input_slots);
    input_ids.swap(u.input_ids);
    groups.restore_names(u.groups);
    body_names.restore_names(u.body_names);
    interaction_names.restore_names(u.interaction_names);
    input_names.restore_names(u.input_names);
    material_names.restore_names(u.material_names);
    shape_names.restore_names(u.shape_names);
    body_ids.swap(u.body_ids);
    interaction_ids.swap(u.interaction_ids);
    shape_ids.swap(u.shape_ids);
    wires.wires.swap(u.wires);
    std::swap(wires.slots, u.wire_slots);
    wires.names.restore_names(u.wire_names);
    wires.ids.swap(u.wire_ids);
    gear.swap(u.gear);
    force_inputs.swap(u.force_inputs);
    local_inputs.swap(u.local_inputs);
}

void WorldImpl::undo_step(std::size_t mark) noexcept {
    if (undo.holds) restore_undo(undo);
    systems.undo_step();
    if (listener != nullptr) listener->undone(mark);
}

/// Save the state, so that several edits can be undone together. Before the first step no copy is
/// needed, because all data are analysed at the start.
Attempt::Attempt(World& world, bool wanted) : world_(world) {
    WorldImpl& m = *world.impl_;
    const world::Using use(m.use, "add");
    if (!wanted || !m.ctx.state.started || m.attempt.holds) return;
    m.save_for_undo(m.attempt);
    mark_ = m.listener != nullptr ? m.listener->mark() : 0;
    exceptions_ = std::uncaught_exceptions();
    holds_ = true;
}

Attempt::~Attempt() {
    if (!holds_) return;
    WorldImpl& m = *world_.impl_;
    if (!failed_ && std::uncaught_exceptions() == exceptions_) {
        m.attempt.holds = false;
        return;
    }
    m.restore_undo(m.attempt);
    if (m.listener != nullptr) m.listener->undone(mark_);
}

}  // namespace hawser
