// SPDX-License-Identifier: Apache-2.0
/// Structure of a world, and construction of a world from it (hawser/structure.h).
#include <hawser/world.h>

#include "world/checks.h"
#include "world/identity.h"
#include "world/impl.h"

#include "base/hash.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace hawser {
namespace {

/// Return a body that occupies an index until all objects have their indices. @param room  Degrees
/// of freedom.
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

template <class Def>
void copy_slots(Placed<Def>& to, const base::Slots& from) {
    const auto count = to.defs.size();
    to.generations.assign(from.generations().begin(),
                          from.generations().begin() + static_cast<std::ptrdiff_t>(count));
    for (const std::int32_t k : from.vacant())
        if (at(k) < count) to.vacant.push_back(k);
}

/// Replace the generations of ids by the current generations of their indices.
template <class Id>
void renew_ids(std::vector<Id>& ids, const base::Slots& slots) noexcept {
    for (Id& id : ids) id = slots.id<Id>(id.index);
}

template <class Def>
void check(const Placed<Def>& from, const char* what) {
    const auto throw_def_error = [&](const char* why) {
        throw DefError(std::string("structure: ") + what + " " + why);
    };
    if (from.generations.size() != from.defs.size())
        throw_def_error("have as many generations as slots");
    for (const std::int32_t g : from.generations)
        if (g < 0) throw_def_error("have generations from 0 on");
    std::int32_t last = -1;
    for (const std::int32_t k : from.vacant) {
        if (k <= last || at(k) >= from.defs.size())
            throw_def_error("have their vacant slots in order");
        last = k;
    }
}

template <class Def>
bool is_vacant(const Placed<Def>& from, std::size_t place) {
    return std::binary_search(from.vacant.begin(), from.vacant.end(),
                              static_cast<std::int32_t>(place));
}

}  // namespace

Structure WorldImpl::structure() const {
    Structure out;
    const auto& bodies = ctx.model.bodies;
    for (std::int32_t b = 0; b < context::body_count(ctx.model); ++b)
        out.bodies.defs.push_back(bodies.slots.holds(b) ? body_defs[at(b)]
                                                        : placeholder(bodies.room[at(b)]));
    copy_slots(out.bodies, bodies.slots);
    const model::Interactions& in = ctx.model.interactions;
    for (std::int32_t i = 0; i < context::interaction_count(ctx.model); ++i) {
        InteractionDef& d = out.interactions.defs.emplace_back();
        d.kind = in.def[at(i)].kind;
        if (in.gone(i)) continue;
        d = in.def[at(i)];
        // A default compliance follows the length, as it does here.
        if (in.flags[at(i)] & model::kFromLength) d.compliance[0] = kDefault;
        for (int r = 0; r < in.rows[at(i)]; ++r)
            out.compliances.push_back(in.defined[at(in.row_begin[at(i)] + r)]);
        if (kind_info(d.kind).is(kWoundUp)) out.radii.push_back(in.defined_radius[at(i)]);
    }
    copy_slots(out.interactions, in.slots);
    const collide::Materials& materials = ctx.model.collider.materials;
    for (int i = 1; i < materials.count(); ++i) out.materials.push_back(materials.def(i));
    out.pairs.assign(materials.pairs().begin(), materials.pairs().end());
    const base::Slots& shapes = ctx.model.collider.slots;
    for (std::int32_t s = 0; s < ctx.model.collider.count(); ++s)
        out.shapes.defs.push_back(shapes.holds(s) ? shape_defs[at(s)] : ShapeDef{});
    copy_slots(out.shapes, shapes);
    for (std::size_t k = 0; k < inputs.size(); ++k)
        out.inputs.defs.push_back(input_slots.holds(static_cast<std::int32_t>(k)) ? inputs[k]
                                                                                  : InputDef{});
    copy_slots(out.inputs, input_slots);
    for (std::size_t k = 0; k < wires.wires.size(); ++k) out.wires.defs.push_back(wires.wires[k]);
    copy_slots(out.wires, wires.slots);
    out.gear = gear;
    out.coupling = ctx.model.cuts.coupling;
    return out;
}

/// Make the bodies. All indices are filled in order and vacated afterwards, because an addition
/// would use a vacant one.
void WorldImpl::make_bodies(World& self, const Placed<BodyDef>& from) {
    check(from, "bodies");
    for (const BodyDef& def : from.defs) self.add_body(def);
    for (const std::int32_t b : from.vacant) (void)self.remove_body(BodyId{b});
    ctx.model.bodies.slots.set_generations(from.generations);
    renew_ids(body_ids, ctx.model.bodies.slots);
}

void WorldImpl::make_shapes(World& self, const Structure& from) {
    check(from.shapes, "shapes");
    for (const MaterialDef& def : from.materials) self.add_material(def);
    for (const MaterialPairDef& pair : from.pairs) self.add_material_pair(pair);
    // On any body: a sphere that touches nothing.
    ShapeDef none{.kind = ShapeKind::sphere, .body = {}, .radius = 1.0};
    for (const BodyId b : body_ids)
        if (ctx.model.bodies.kind[at(b.index)] != BodyKind::scalar) none.body = b;
    for (std::size_t s = 0; s < from.shapes.defs.size(); ++s)
        self.add_shape(is_vacant(from.shapes, s) ? none : from.shapes.defs[s]);
    for (const std::int32_t s : from.shapes.vacant) (void)self.remove_shape(ShapeId{s});
    ctx.model.collider.slots.set_generations(from.shapes.generations);
    renew_ids(shape_ids, ctx.model.collider.slots);
}

void WorldImpl::make_interactions(World& self, const Placed<InteractionDef>& from) {
    check(from, "interactions");
    model::Interactions& in = ctx.model.interactions;
    for (std::size_t i = 0; i < from.defs.size(); ++i) {
        if (is_vacant(from, i)) {
            in.reserve_more(from.defs[i].kind);
            in.append_empty(from.defs[i].kind);
            continue;
        }
        InteractionDef d = from.defs[i];
        d.load = {};  // an interaction that loads it may have a later index
        self.add_interaction(d);
    }
    for (const std::int32_t i : from.vacant) in.slots.vacate(i);
    in.slots.set_generations(from.generations);
    renew_ids(interaction_ids, in.slots);
    for (const InteractionId id : interaction_ids) {
        const auto& loads = from.defs[at(id.index)].load;
        if (loads[0].interaction.valid() || loads[1].interaction.valid()) {
            for (const FrictionLoad& load : loads)
                if (load.interaction.valid()) (void)index_of(load.interaction);
            in.set_loads(id.index, loads);
        }
    }
}

void WorldImpl::move_defined(const Structure& from) {
    if (from.compliances.empty() && from.radii.empty()) return;
    model::Interactions& in = ctx.model.interactions;
    std::size_t row = 0, drum = 0;
    const auto next = [](const std::vector<double>& list, std::size_t& k, double most) {
        if (k >= list.size() || !(std::abs(list[k]) <= most))
            throw DefError("structure: compliances or radii do not match its interactions");
        return list[k++];
    };
    constexpr double kMaxCompliance = 1e30, kMaxRadius = 1e3;
    for (const InteractionId id : interaction_ids) {
        for (int r = 0; r < in.rows[at(id.index)]; ++r)
            in.defined[at(in.row_begin[at(id.index)] + r)] =
                next(from.compliances, row, kMaxCompliance);
        if (kind_info(in.def[at(id.index)].kind).is(kWoundUp))
            in.defined_radius[at(id.index)] = next(from.radii, drum, kMaxRadius);
    }
}

void WorldImpl::make_inputs(World& self, const Placed<InputDef>& from) {
    check(from, "inputs");
    for (std::size_t k = 0; k < from.defs.size(); ++k) {
        if (!is_vacant(from, k)) {
            self.add_input(from.defs[k]);
            continue;
        }
        inputs.emplace_back();
        input_values.push_back(0.0);
        input_slots.reserve_more();
        (void)input_slots.append();
    }
    for (const std::int32_t k : from.vacant) input_slots.vacate(k);
    input_slots.set_generations(from.generations);
    renew_ids(input_ids, input_slots);
}

void WorldImpl::make_wires(const Placed<WirePieces>& from) {
    check(from, "wires");
    for (std::size_t k = 0; k < from.defs.size(); ++k) {
        world::Wire& wire = wires.wires.emplace_back();
        static_cast<WirePieces&>(wire) = from.defs[k];
        wires.slots.reserve_more();
        const std::int32_t place = wires.slots.append();
        if (is_vacant(from, k)) continue;
        const std::string where = world::label("wire", wire.name);
        if (wire.elements.empty() || wire.nodes.size() != wire.elements.size() + 1)
            world::throw_def_error(where, "it has a node more than elements");
        for (const InteractionId id : wire.elements)
            if (ctx.model.interactions.slots.names(id) &&
                !kind_info(ctx.model.interactions.def[at(id.index)].kind).is(kWireElement))
                world::throw_def_error(where, "it is made of elements of wires");
        world::claim_name(wires.names, wire.name, place, "wire");
    }
    for (const std::int32_t k : from.vacant) wires.slots.vacate(k);
    wires.slots.set_generations(from.generations);
    for (std::int32_t k = 0; k < wires.slots.count(); ++k)
        if (wires.slots.holds(k)) wires.ids.push_back(wires.slots.id<WireId>(k));
}

void WorldImpl::make(World& self, const Structure& from) {
    make_bodies(self, from.bodies);
    make_shapes(self, from);
    make_interactions(self, from.interactions);
    move_defined(from);
    make_inputs(self, from.inputs);
    make_wires(from.wires);
    gear = from.gear;
    if (from.coupling.size() > from.interactions.defs.size())
        throw DefError("structure: there are more couplings than interactions");
    ctx.model.cuts.coupling = from.coupling;
}

Structure WorldStateView::structure() const {
    const world::Using use(impl().use, "structure");
    return impl().structure();
}

std::uint64_t WorldStateView::identity() const {
    const world::Using use(impl().use, "identity");
    const WorldImpl& m = impl();
    const std::uint64_t both[2] = {
        world::layout_of(m.ctx, m.inputs.size()),
        world::parameters_of(m.ctx, m.body_defs, m.inputs, m.shape_defs)};
    return base::checksum(both, sizeof both, base::kFnvStart);
}

void WorldState::restore(const Structure& made_of, std::span<const std::byte> bytes) {
    WorldImpl::restore(*world_, made_of, bytes);
}

/// Restore a saved structure and state. They are first restored in a separate world, to which the
/// systems are moved. If the state is rejected, the systems are moved back and this world is
/// unchanged.
void WorldImpl::restore(World& self, const Structure& made_of, std::span<const std::byte> bytes) {
    std::unique_ptr<WorldImpl> before;  // outlives its lock
    const world::Using use(self.impl_->use, "restore");
    WorldImpl& m = *self.impl_;
    World out(m.ctx.model.def);
    WorldImpl& o = *out.impl_;
    o.make(out, made_of);
    o.outputs = m.outputs;
    o.systems.move_systems(m.systems);
    try {
        o.outputs.bind(o.systems.signals());
        o.restore_saved_bytes(out, bytes, false);
    } catch (...) {
        m.systems.move_systems(o.systems);
        throw;
    }
    if (o.systems.count() > 0) o.ctx.actors = &o.systems;
    o.systems.discard_actions();
    o.outputs.forget_figures();
    o.listener = m.listener;
    std::swap(o.ctx.state.events, m.ctx.state.events);
    std::swap(o.ctx.trace, m.ctx.trace);
    before = std::move(self.impl_);
    self.impl_ = std::move(out.impl_);
    if (o.listener != nullptr) o.listener->restored(made_of, bytes);
}

}  // namespace hawser
