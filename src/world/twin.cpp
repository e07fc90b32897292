// SPDX-License-Identifier: Apache-2.0
/// A world of the same definitions, at the same places.
#include <hawser/world.h>

#include "world/impl.h"

#include <optional>
#include <vector>

namespace hawser {
namespace {

/// Something that weighs as many entries as what was there; it goes again when all has its place.
BodyDef placeholder(int room) {
    BodyDef def;
    def.kind = room == 6   ? BodyKind::rigid
               : room == 3 ? BodyKind::lump
               : room == 1 ? BodyKind::scalar
                           : BodyKind::fixed;
    def.mass = 1.0;
    def.inertia = Mat3::Identity();
    return def;
}

/// Ids with the generations that places have by now.
template <class Id>
void name_anew(std::vector<Id>& ids, const base::Places& places) noexcept {
    for (Id& id : ids) id = places.id<Id>(id.index);
}

}  // namespace

/// Places are filled in their order and emptied afterwards, since what is added would take an empty
/// one.
void World::Impl::copy_bodies(World& out) const {
    Impl& o = *out.impl_;
    const base::Places& places = ctx.model.bodies.places;
    const auto gone = [&](std::int32_t b) { return !places.holds(b); };
    for (std::int32_t b = 0; b < stepper::body_count(ctx.model); ++b)
        out.add_body(gone(b) ? placeholder(ctx.model.bodies.room[at(b)]) : body_defs[at(b)]);
    for (const std::int32_t b : places.vacant()) (void)out.remove_body(BodyId{b});
    o.ctx.model.bodies.places.set_generations(places.generations());
    name_anew(o.body_ids, o.ctx.model.bodies.places);
}

void World::Impl::copy_shapes(World& out) const {
    Impl& o = *out.impl_;
    const collide::Materials& materials = ctx.model.collider.materials;
    for (int i = 1; i < materials.count(); ++i) out.add_material(materials.def(i));
    for (const MaterialPairDef& pair : materials.pairs()) out.add_material_pair(pair);
    const base::Places& places = ctx.model.collider.places;
    // Of any body: a sphere that touches nothing.
    ShapeDef none{.kind = ShapeKind::sphere, .body = {}, .radius = 1.0};
    for (const BodyId b : body_ids)
        if (ctx.model.bodies.kind[at(b.index)] != BodyKind::scalar) none.body = b;
    for (std::int32_t s = 0; s < ctx.model.collider.count(); ++s)
        out.add_shape(places.holds(s) ? shape_defs[at(s)] : none);
    for (const std::int32_t s : places.vacant()) (void)out.remove_shape(ShapeId{s});
    o.ctx.model.collider.places.set_generations(places.generations());
    name_anew(o.shape_ids, o.ctx.model.collider.places);
}

void World::Impl::copy_interactions(World& out) const {
    const model::Interactions& in = ctx.model.interactions;
    model::Interactions& to = out.impl_->ctx.model.interactions;
    for (std::int32_t i = 0; i < stepper::interaction_count(ctx.model); ++i) {
        if (in.gone(i)) {
            to.make_room(in.def[at(i)].kind);
            to.append_empty(in.def[at(i)].kind);
            continue;
        }
        InteractionDef d = in.def[at(i)];
        // Then it follows the length, as it does here.
        if (in.flags[at(i)] & model::kFromLength) d.compliance[0] = kDefault;
        // What loads it may have a later place.
        d.load = {};
        out.add_interaction(d);
    }
    for (const std::int32_t i : in.places.vacant())
        if (i < stepper::interaction_count(ctx.model)) to.places.vacate(i);
    to.places.set_generations(in.places.generations());
    name_anew(out.impl_->interaction_ids, to.places);
    for (const InteractionId id : interaction_ids)
        if (in.def[at(id.index)].load[0].interaction.valid() ||
            in.def[at(id.index)].load[1].interaction.valid())
            to.set_loads(id.index, in.def[at(id.index)].load);
}

void World::Impl::copy_inputs(World& out) const {
    Impl& o = *out.impl_;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
        if (input_places.holds(static_cast<std::int32_t>(k))) {
            out.add_input(inputs[k]);
            continue;
        }
        o.inputs.emplace_back();
        o.input_values.push_back(0.0);
        o.input_places.make_room();
        (void)o.input_places.append();
    }
    for (const std::int32_t k : input_places.vacant()) o.input_places.vacate(k);
    o.input_places.set_generations(input_places.generations());
    name_anew(o.input_ids, o.input_places);
}

World World::twin(std::optional<Coupling> coupling) const {
    const world::Using use(impl_->use, "twin");
    const Impl& m = *impl_;
    WorldDef def = m.ctx.model.def;
    def.coupling = coupling.value_or(def.coupling);
    World out(def);
    m.copy_bodies(out);
    m.copy_shapes(out);
    m.copy_interactions(out);
    m.copy_inputs(out);
    out.impl_->wires = m.wires;
    out.impl_->gear = m.gear;
    for (std::size_t i = 0; i < m.systems.count(); ++i) {
        std::unique_ptr<System> copy = m.systems.at(i).clone();
        if (!copy)
            throw DefError("twin: system '" + std::string(m.systems.at(i).name()) +
                           "' cannot be copied; let its clone() make another one");
        out.add_system(std::move(copy));
    }
    out.impl_->outputs = m.outputs;
    out.impl_->outputs.bind(out.impl_->systems.signals());
    if (!coupling) out.impl_->ctx.model.cuts.coupling = m.ctx.model.cuts.coupling;
    out.copy_state(*this);
    return out;
}

}  // namespace hawser
