// SPDX-License-Identifier: Apache-2.0
/// Shapes, materials and contacts of a world.
#include <hawser/world.h>

#include "world/checks.h"
#include "world/impl.h"
#include "world/lookup.h"

#include <string>
#include <utility>

namespace hawser {

const char* to_string(ShapeKind kind) noexcept {
    constexpr const char* kNames[] = {"sphere", "capsule",     "box",  "cylinder",
                                      "plane",  "heightfield", "hull", "mesh"};
    return kNames[static_cast<std::size_t>(kind)];
}

using world::lookup;
using world::reserve_name_for;

namespace {

/// Set the moments of a contact with rolling or torsional resistance.
void add_resistance(const context::StepContext& ctx, std::size_t i, ContactView& v) {
    const assembly::Contacts& contacts = ctx.model.system.contacts;
    if (v.asleep) {
        if (const auto* m = contacts.resistances.find(static_cast<std::int32_t>(i)); m != nullptr)
            for (int k = 0; k < 3; ++k) v.moment[k] = m->lambda[k] / ctx.model.def.step;
        return;
    }
    if (i >= contacts.count() || contacts.rows[i].resistance < 0) return;
    const double* axis = contacts.rows[i].axis;
    const auto& law = contacts.resistances.laws[at(contacts.rows[i].resistance)];
    const auto in_world = [&](const double* x, int k) {
        return axis[k] * x[0] + axis[3 + k] * x[1] + axis[6 + k] * x[2];
    };
    for (int k = 0; k < 3; ++k) {
        v.moment[k] = in_world(law.lambda, k) / ctx.model.def.step;
        v.turn_target[k] = in_world(law.b, k);
    }
    v.rolling = law.rolling;
    v.torsional = law.torsional;
    v.turn_softness = law.sigma;
}

}  // namespace

MaterialId World::add_material(const MaterialDef& def) {
    const world::Using use(impl_->use, "add_material");
    Impl& m = *impl_;
    world::check(def, m.ctx.model.def.nonsmooth);
    const int index = material_count();
    reserve_name_for(m.material_names, def.name, index, "material",
                     [&] { m.ctx.model.collider.materials.add(def); });
    m.ctx.state.changed = context::Changed::all;
    if (m.listener != nullptr) m.listener->added(def);
    return MaterialId{index};
}

void World::add_material_pair(const MaterialPairDef& def) {
    const world::Using use(impl_->use, "add_material_pair");
    world::check(def, material_count(), impl_->ctx.model.def.nonsmooth);
    impl_->ctx.model.collider.materials.add_pair(def);
    impl_->ctx.state.changed = context::Changed::all;
    if (impl_->listener != nullptr) impl_->listener->added(def);
}

int World::material_count() const noexcept { return impl_->ctx.model.collider.materials.count(); }
const MaterialDef& World::material_def(MaterialId id) const {
    if (id.index < 0 || id.index >= material_count())
        throw DefError("there is no material with id " + std::to_string(id.index));
    return impl_->ctx.model.collider.materials.def(id.index);
}
MaterialId World::find_material(std::string_view name) const noexcept {
    return MaterialId{lookup(impl_->material_names, name)};
}
std::span<const MaterialPairDef> World::material_pairs() const noexcept {
    return impl_->ctx.model.collider.materials.pairs();
}
int World::shape_count() const noexcept { return impl_->ctx.model.collider.count(); }
const ShapeDef& World::shape_def(ShapeId id) const {
    return impl_->shape_defs[impl_->index_of(id)];
}
ShapeId World::find_shape(std::string_view name) const noexcept {
    return impl_->ctx.model.collider.slots.id<ShapeId>(lookup(impl_->shape_names, name));
}

std::vector<ContactView> World::contacts() const {
    std::vector<ContactView> out;
    contacts(out);
    return out;
}

void World::pressing(ShapeId id, std::vector<ShapeId>& out) const {
    const collide::Collider& collider = impl_->ctx.model.collider;
    const auto& memory = impl_->ctx.model.system.contacts.memory;
    const auto shape = static_cast<std::int32_t>(impl_->index_of(id));
    out.clear();
    for (std::size_t i = 0; i < collider.last_contacts().size() && i < memory.size(); ++i) {
        const std::int32_t* pair = collider.last_contacts()[i].shape;
        const double* lambda = memory[i].lambda;
        if ((pair[0] != shape && pair[1] != shape) ||
            (lambda[0] == 0.0 && lambda[1] == 0.0 && lambda[2] == 0.0))
            continue;
        out.push_back(collider.slots.id<ShapeId>(pair[pair[0] == shape ? 1 : 0]));
    }
}

void World::touching(std::vector<std::uint8_t>& out) const {
    const collide::Collider& collider = impl_->ctx.model.collider;
    out.assign(at(body_count()), 0);
    for (const collide::KeptContact& contact : collider.last_contacts())
        for (const std::int32_t side : contact.shape) {
            const collide::Shape& shape = collider.shapes()[at(side)];
            if (shape.body[1] < 0) continue;
            for (const std::int32_t body : shape.body)
                if (body < body_count()) out[at(body)] = 1;
        }
}

void World::contacts(std::vector<ContactView>& out) const {
    const context::StepContext& ctx = impl_->ctx;
    out.clear();
    out.reserve(ctx.state.contacts.contacts.size());
    for (std::size_t i = 0; i < ctx.state.contacts.contacts.size(); ++i) {
        const collide::Contact& c = ctx.state.contacts.contacts[i];
        ContactView v;
        for (int k = 0; k < 2; ++k) v.shape[k] = ctx.model.collider.slots.id<ShapeId>(c.shape[k]);
        v.force.setZero();
        for (int k = 0; k < 3; ++k) {
            v.point[k] = 0.5 * (c.on[0][k] + c.on[1][k]);
            v.normal[k] = c.normal[k];
            const std::size_t j = 3 * i + at(k);
            if (j < ctx.state.contact_impulse.size())
                v.force[k] = ctx.state.contact_impulse[j] / ctx.model.def.step;
        }
        v.gap = c.gap;
        v.asleep = i >= ctx.state.contacts.awake;
        if (const auto& rows = ctx.model.system.contacts; i < rows.cones.size()) {
            const nonsmooth::Cone& cone = rows.cones[i];
            v.friction = cone.friction;
            v.softness[0] = cone.sigma_n;
            v.softness[1] = cone.sigma_t;
            const double* axis = rows.rows[i].axis;
            for (int k = 0; k < 3; ++k)
                v.target[k] =
                    axis[k] * cone.b[0] + axis[3 + k] * cone.b[1] + axis[6 + k] * cone.b[2];
        }
        add_resistance(ctx, i, v);
        v.sliding = i < ctx.state.contact_sliding.size() && ctx.state.contact_sliding[i] != 0;
        out.push_back(v);
    }
}

}  // namespace hawser
