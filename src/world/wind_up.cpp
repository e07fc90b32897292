// SPDX-License-Identifier: Apache-2.0
/// Winding of the end of a wire onto a drum.
#include <hawser/world.h>

#include "context/asleep.h"
#include "context/context.h"
#include "edit/edits.h"
#include "edit/node_pieces.h"
#include "world/checks.h"
#include "world/impl.h"
#include "world/parts.h"

#include <span>
#include <utility>

namespace hawser {

void WorldWires::set_mass(BodyId lump, double mass) {
    const world::Using use(impl().use, "set_mass");
    const std::size_t b = impl().index_of(lump);
    BodyDef& def = impl().body_defs[b];
    const std::string where = world::label("body", def.name);
    if (def.kind != BodyKind::lump)
        world::throw_def_error(where, "it is not a node; only nodes change mass");
    if (!(mass > 0.0 && mass <= 1e12))
        world::throw_def_error(where, "mass = " + world::number(mass) + " kg; give a positive one");
    context::StepContext& c = impl().ctx;
    edit::begin_edit(c);
    c.state.ledger.edited.given -= edit::energy_of_body(c, lump.index);
    const double scale = mass / def.mass;
    def.mass = c.model.bodies.mass[b] = mass;
    for (int k = 0; k < 3; ++k) {
        def.linear_damping[k] = c.model.bodies.damping[6 * b + at(k)] *= scale;
        def.force[k] *= scale;
        impl().add_up_force(lump, k);
    }
    c.state.ledger.edited.given += edit::energy_of_body(c, lump.index);
    // Elements store the mass of the lighter of their ends.
    model::Interactions& in = c.model.interactions;
    for (const InteractionId id : impl().interaction_ids)
        for (std::size_t slot = 0; slot < in.bodies[at(id.index)]; ++slot)
            if (in.def[at(id.index)].body[slot] == lump)
                in.rewire(id.index, slot, lump, c.model.bodies);
    context::wake_island(c.model, lump.index);
    if (impl().listener != nullptr) impl().listener->set_mass(lump, mass);
}

InteractionId WorldWires::spool(WireId id, int end, BodyId drum, double radius) {
    const world::Using use(impl().use, "wires().spool");
    const Attempt attempt(*world_, impl().undoes_as_whole());
    const world::Wire& wire = impl().wire(id);
    const std::string where = world::label("wire", wire.name);
    if (end != 0 && end != 1) world::throw_def_error(where, "end must be 0, the first one, or 1");
    const std::size_t place = end == 0 ? 0 : wire.elements.size() - 1;
    const InteractionId old = wire.elements[place];
    if (!world_->alive(old))
        world::throw_def_error(where, "the element at this end has been removed");
    if (!world_->intact(old)) world::throw_def_error(where, "the element at this end has parted");
    InteractionDef d = world_->interaction_def(old);
    if (kind_info(d.kind).is(kWoundUp))
        world::throw_def_error(where, "this end lies on a drum already; one drum an end");
    if (!world_->alive(drum) || world_->body_def(drum).kind != BodyKind::scalar)
        world::throw_def_error(where, "its drum must be a scalar body");
    if (!(radius >= -1e3 && radius <= 1e3))
        world::throw_def_error(where,
                               "radius = " + world::number(radius) + " m; give -1000 to 1000");
    const auto& in = impl().ctx.model.interactions;
    const double mass = edit::mass_of_element(impl().ctx, old.index);
    const BodyId beyond = d.body[end == 0 ? 1 : 0];
    const bool gives = mass > 0.0 && world_->body_def(beyond).kind == BodyKind::lump;
    if (gives && !(world_->body_def(beyond).mass > 0.5 * mass))
        world::throw_def_error(where,
                               "the lump next to the drum has less than half of the element");
    const InteractionDef stretch = d;
    d.kind = InteractionKind::WinchStretch;
    d.params.fill(kDefault);
    for (const char* same : {"length", "EA", "tension_only", "breaking_load"})
        d.set(same, stretch.get(same));
    d.body[2] = drum;
    d.set("radius", radius).set("drum_zero", world_->pose(drum).position.x());
    // A compliance derived from the length follows it.
    if ((in.flags[at(old.index)] & model::kFromLength) != 0) d.compliance[0] = kDefault;
    // All checks are done and capacity is reserved before the old element is removed.
    InteractionDef whole = d;
    world::check(whole, impl().ctx.model.bodies, world_->body_count(),
                 std::span(in.def).first(at(world_->interaction_count())), in.slots);
    world::fill_in(whole, impl().ctx);
    impl().check_not_needed(old);
    impl().reserve_removal();
    impl().ctx.model.interactions.reserve_more(d.kind);
    // No call below throws: the name moves with its table node.
    world::Names::Map::node_type name = impl().interaction_names.extract_name(d.name);
    impl().remove(old);
    if (impl().listener != nullptr) impl().listener->removed(old);
    const InteractionId out = impl().store_interaction(std::move(whole));
    impl().interaction_names.insert_at(std::move(name), out.index);
    if (impl().listener != nullptr) impl().listener->added(d);
    (void)impl().sorted_removal();
    impl().wires.wires[at(id.index)].elements[place] = out;
    if (gives) set_mass(beyond, world_->body_def(beyond).mass - 0.5 * mass);
    return out;
}

}  // namespace hawser
