// SPDX-License-Identifier: Apache-2.0
/// Addition and removal of objects of a world.
#include <hawser/world.h>

#include "world/checks.h"
#include "world/impl.h"
#include "world/lookup.h"
#include "world/parts.h"

#include <algorithm>
#include <span>
#include <string>
#include <utility>

namespace hawser {

using world::claim_name;
using world::reserve_name_for;

namespace {

/// Return the index for the next object: a vacant index, or the count if none is vacant.
std::int32_t next_index(std::int32_t vacant, int count) noexcept {
    return vacant < 0 ? count : vacant;
}

/// Store a definition at an index of a list, which may be its end. Capacity has been reserved.
template <class T>
void store_at(std::vector<T>& list, std::int32_t place, T&& value) noexcept {
    if (at(place) == list.size())
        list.push_back(std::forward<T>(value));
    else
        list[at(place)] = std::forward<T>(value);
}

template <class Id>
void insert_id(std::vector<Id>& ids, Id id) noexcept {
    ids.insert(std::lower_bound(ids.begin(), ids.end(), id), id);
}

template <class Id>
void erase_id(std::vector<Id>& ids, Id id) noexcept {
    ids.erase(std::lower_bound(ids.begin(), ids.end(), id));
}

void throw_if_above(std::size_t living, std::int32_t most, const char* what) {
    if (living >= at(most))
        throw DefError(std::string("too many ") + what + "; raise max_" + what + " = " +
                       std::to_string(most));
}

}  // namespace

BodyId World::add_body(const BodyDef& def) {
    const world::Using use(impl_->use, "add_body");
    world::check(def);
    Impl& m = *impl_;
    context::StepContext& c = m.ctx;
    throw_if_above(m.body_ids.size(), c.model.def.max_bodies, "bodies");
    BodyDef kept = def;
    base::reserve_more(m.body_defs, 1);
    base::reserve_more(m.body_ids, 1);
    base::reserve_more(c.model.regroup.by_hand, 1);
    base::reserve_more(c.model.cuts.group, 1);
    c.model.bodies.reserve_more();
    const std::int32_t place = next_index(c.model.bodies.vacant_slot_for(def.kind), body_count());
    std::int32_t group = -1;
    reserve_name_for(m.body_names, def.name, place, "body",
                     [&] { group = m.number_of_group(def.group); });
    // No call below throws.
    edit::begin_edit(c);
    (void)c.model.bodies.add(def);
    store_at(m.body_defs, place, std::move(kept));
    store_at(c.model.regroup.by_hand, place, std::int32_t{group});
    store_at(c.model.cuts.group, place, std::int32_t{group});
    edit::register_added_body(c, place);
    const BodyId id = c.model.bodies.id(place);
    insert_id(m.body_ids, id);
    if (m.listener != nullptr) m.listener->added(def);
    return id;
}

InteractionId World::add_interaction(const InteractionDef& def) {
    const world::Using use(impl_->use, "add_interaction");
    Impl& m = *impl_;
    context::StepContext& c = m.ctx;
    model::Interactions& all = c.model.interactions;
    world::check(def, c.model.bodies, body_count(),
                 std::span(all.def).first(at(interaction_count())), all.slots);
    throw_if_above(m.interaction_ids.size(), c.model.def.max_interactions, "interactions");
    InteractionDef d = def;
    world::fill_in(d, c);
    all.reserve_more(d.kind);
    base::reserve_more(m.interaction_ids, 1);
    edit::reserve_edit(c);
    const std::int32_t place = next_index(all.vacant_slot_for(d.kind), interaction_count());
    claim_name(m.interaction_names, d.name, place, "interaction");
    // No call below throws.
    const InteractionId id = m.store_interaction(std::move(d));
    if (m.listener != nullptr) m.listener->added(def);
    return id;
}

InteractionId WorldImpl::store_interaction(InteractionDef&& whole) noexcept {
    edit::begin_edit(ctx);
    model::Interactions& all = ctx.model.interactions;
    const std::int32_t place = all.add(std::move(whole), ctx.model.bodies, ctx.model.def.step);
    if (at(place) < ctx.model.cuts.coupling.size())
        ctx.model.cuts.coupling[at(place)] = ctx.model.def.coupling;
    edit::register_added_interaction(ctx, place);
    const InteractionId id = all.id(place);
    insert_id(interaction_ids, id);
    return id;
}

ShapeId World::add_shape(const ShapeDef& def) {
    const world::Using use(impl_->use, "add_shape");
    Impl& m = *impl_;
    world::check(def, m.ctx.model.bodies, body_count(), material_count());
    ShapeDef kept = def;
    base::reserve_more(m.shape_defs, 1);
    edit::reserve_edit(m.ctx);
    base::reserve_more(m.shape_ids, 1);
    const std::int32_t place = next_index(
        m.ctx.model.collider.slots.find_vacant([](std::int32_t) { return true; }), shape_count());
    reserve_name_for(m.shape_names, def.name, place, "shape",
                     [&] { m.ctx.model.collider.add(def, m.ctx.model.bodies); });
    // No call below throws.
    store_at(m.shape_defs, place, std::move(kept));
    edit::begin_shape_edit(m.ctx);
    edit::register_added_shape(m.ctx, place);
    const auto id = m.ctx.model.collider.slots.id<ShapeId>(place);
    insert_id(m.shape_ids, id);
    if (m.listener != nullptr) m.listener->added(def);
    return id;
}

std::span<const BodyId> World::bodies() const noexcept { return impl_->body_ids; }
std::span<const InteractionId> World::interactions() const noexcept {
    return impl_->interaction_ids;
}
std::span<const ShapeId> World::shapes() const noexcept { return impl_->shape_ids; }
bool World::alive(BodyId id) const noexcept {
    return id.index < body_count() && impl_->ctx.model.bodies.slots.names(id);
}
bool World::alive(InteractionId id) const noexcept {
    return id.index < interaction_count() && impl_->ctx.model.interactions.slots.names(id);
}
bool World::alive(ShapeId id) const noexcept { return impl_->ctx.model.collider.slots.names(id); }
bool World::alive(InputId id) const noexcept { return impl_->input_slots.names(id); }

void World::set_change_listener(ChangeListener* listener) noexcept { impl_->listener = listener; }

namespace {

/// Remove one object with everything attached to it.
/// @param call  Name of the function of World.
template <class Impl, class Id>
const Removed& remove_object(Impl& impl, Id id, const char* call) {
    const world::Using use(impl.use, call);
    (void)impl.index_of(id);
    impl.check_not_needed(id);
    impl.reserve_removal();
    impl.remove(id);
    if (impl.listener != nullptr) impl.listener->removed(id);
    return impl.sorted_removal();
}

}  // namespace

const Removed& World::remove_body(BodyId id) { return remove_object(*impl_, id, "remove_body"); }
const Removed& World::remove_interaction(InteractionId id) {
    return remove_object(*impl_, id, "remove_interaction");
}
const Removed& World::remove_shape(ShapeId id) { return remove_object(*impl_, id, "remove_shape"); }
const Removed& World::remove_input(InputId id) { return remove_object(*impl_, id, "remove_input"); }

/// Reserve capacity for the removal of all objects, because the removal of a hull may remove any of
/// them.
void WorldImpl::reserve_removal() {
    edit::reserve_edit(ctx);
    ctx.model.bodies.reserve_more();
    ctx.model.interactions.slots.reserve_more();
    input_slots.reserve_more();
    removed.bodies.reserve(body_ids.size());
    removed.interactions.reserve(interaction_ids.size());
    removed.shapes.reserve(shape_ids.size());
    removed.inputs.reserve(inputs.size());
    forget_removal();
}

void WorldImpl::forget_removal() noexcept {
    removed.bodies.clear();
    removed.interactions.clear();
    removed.shapes.clear();
    removed.inputs.clear();
}

namespace {

/// Append the id of a removed object to a list if there is capacity. Calls that undo their own
/// additions need no list.
template <class Id>
void append_if_capacity(std::vector<Id>& list, Id id) noexcept {
    if (list.size() < list.capacity()) list.push_back(id);
}

}  // namespace

const Removed& WorldImpl::sorted_removal() noexcept {
    std::sort(removed.interactions.begin(), removed.interactions.end());
    std::sort(removed.shapes.begin(), removed.shapes.end());
    std::sort(removed.inputs.begin(), removed.inputs.end());
    return removed;
}

/// Remove a body, its attached objects first.
void WorldImpl::remove(BodyId id) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    for (std::int32_t i = context::interaction_count(ctx.model); i-- > 0;) {
        const std::int32_t* body = &in.body[kMaxInteractionBodies * at(i)];
        if (std::find(body, body + in.bodies[at(i)], id.index) != body + in.bodies[at(i)])
            remove(in.id(i));
    }
    for (std::int32_t s = ctx.model.collider.count(); s-- > 0;) {
        const std::int32_t* body = ctx.model.collider.shapes()[at(s)].body;
        if (body[0] == id.index || body[1] == id.index)
            remove(ctx.model.collider.slots.id<ShapeId>(s));
    }
    for (std::int32_t k = input_slots.count(); k-- > 0;)
        if (inputs[at(k)].body == id) remove(input_slots.id<InputId>(k));
    edit::begin_edit(ctx);
    world::release(body_names, body_defs[at(id.index)].name);
    body_defs[at(id.index)] = {.kind = BodyKind::fixed, .gravity = false};
    ctx.model.regroup.by_hand[at(id.index)] = ctx.model.cuts.group[at(id.index)] = -1;
    edit::remove_body(ctx, id.index);
    erase_id(body_ids, id);
    append_if_capacity(removed.bodies, id);
}

void WorldImpl::remove(InteractionId id) noexcept {
    for (std::int32_t k = input_slots.count(); k-- > 0;)
        if (inputs[at(k)].interaction == id) remove(input_slots.id<InputId>(k));
    edit::begin_edit(ctx);
    world::release(interaction_names, ctx.model.interactions.def[at(id.index)].name);
    edit::remove_interaction(ctx, id.index);
    erase_id(interaction_ids, id);
    append_if_capacity(removed.interactions, id);
}

void WorldImpl::remove(ShapeId id) noexcept {
    edit::begin_shape_edit(ctx);
    world::release(shape_names, shape_defs[at(id.index)].name);
    shape_defs[at(id.index)] = {};
    edit::remove_shape(ctx, id.index);
    erase_id(shape_ids, id);
    append_if_capacity(removed.shapes, id);
}

/// Remove an input. The value that it set remains.
void WorldImpl::remove(InputId id) noexcept {
    InputDef& def = inputs[at(id.index)];
    const InteractionId driven = def.interaction;
    world::release(input_names, def.name);
    std::erase(local_inputs, id.index);
    if (def.body.valid() && !def.local) {
        const int c = def.component;
        BodyDef& on = body_defs[at(def.body.index)];
        (c < 3 ? on.force[c] : on.torque[c - 3]) += input_values[at(id.index)];
        std::erase(force_inputs, ForceInput{def.body.index, c, id.index});
        add_up_force(def.body, c);
    }
    erase_id(input_ids, id);
    def = {};
    input_values[at(id.index)] = 0.0;
    input_slots.vacate(id.index);
    append_if_capacity(removed.inputs, id);
    const auto same = [&](const InputDef& other) { return other.interaction == driven; };
    if (!driven.valid() || std::any_of(inputs.begin(), inputs.end(), same)) return;
    edit::begin_edit(ctx);  // the interaction may take part in the end-of-step iteration now
    ctx.model.interactions.unmark_driven(driven.index);
}

}  // namespace hawser
