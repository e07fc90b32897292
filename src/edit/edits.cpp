// SPDX-License-Identifier: Apache-2.0
#include "edit/edits.h"

#include "assembly/kinetic.h"
#include "base/index.h"
#include "base/small.h"
#include "context/asleep.h"
#include "context/context.h"
#include "split/split.h"

#include <algorithm>
#include <cmath>

namespace hawser::edit {
namespace {

using generic::V3;

/// Return the position of an end of a line half a step before the current poses [m]. The body is
/// moved and rotated back with its velocity.
V3 end_at_half_step(const context::StepContext& ctx, std::int32_t id, std::size_t slot) noexcept {
    const model::Bodies& b = ctx.model.bodies;
    const auto body = at(ctx.model.interactions.body[kMaxInteractionBodies * at(id) + slot]);
    const int dof = b.dof(static_cast<int>(body));
    const double half = 0.5 * ctx.model.def.step;
    const double* v = dof > 0 ? &b.v[at(b.dof_begin[body])] : &b.v_fixed[6 * body];
    const V3 x = generic::load3(&b.x[3 * body]) - half * generic::load3(v);
    if (dof == 3) return x;
    const Vec3& point = ctx.model.interactions.def[at(id)].point[slot];
    const V3 arm = generic::load9(&b.r[9 * body]) * V3{point[0], point[1], point[2]};
    const V3 w = generic::load3(v + 3);
    // Rotate back by half: 2 atan(h|ω|/2).
    const double whole = 0.25 * ctx.model.def.step * ctx.model.def.step * dot(w, w);
    const V3 turn = (-half / (1.0 + std::sqrt(1.0 + whole))) * w;
    const V3 c = cross(turn, arm);
    return x + arm + (2.0 / (1.0 + dot(turn, turn))) * (c + cross(turn, c));
}

/// Return the elastic energy ½ (l − l₀)²/ε of a line half a step before the current poses [J], with
/// the distance l of its ends.
double energy_of_line(const context::StepContext& ctx, std::int32_t id) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    const auto row = at(in.row_begin[at(id)]);
    const double rest = in.rest_length[at(id)];
    if (in.parted[at(id)] || !model::holds_energy(in.epsilon[row], rest)) return 0.0;
    const double separation = norm(end_at_half_step(ctx, id, 1) - end_at_half_step(ctx, id, 0));
    const double longer = separation - (rest > 0.0 ? rest : in.def[at(id)].params[0]);
    if ((in.flags[at(id)] & model::kOneSided) && longer < 0.0) return 0.0;
    return 0.5 * longer * longer / in.epsilon[row];
}

void disturb_bodies(context::StepContext& ctx, std::int32_t id) noexcept {
    for (std::size_t b = 0; b < ctx.model.interactions.bodies[at(id)]; ++b)
        context::wake_island(ctx.model,
                             ctx.model.interactions.body[kMaxInteractionBodies * at(id) + b]);
}

/// Remove the entries of deleted contacts from an array with one entry per contact of the last
/// step.
template <class A>
void compact(A& array, const std::vector<std::uint8_t>& stays, std::size_t each) noexcept {
    std::size_t n = 0;
    for (std::size_t i = 0; each * (i + 1) <= array.size() && i < stays.size(); ++i) {
        if (stays[i] == 0) continue;
        for (std::size_t k = 0; k < each; ++k) array[each * n + k] = array[each * i + k];
        ++n;
    }
    array.resize(each * n);
}

}  // namespace

void forget_contacts(context::StepContext& ctx, std::int32_t shape) noexcept {
    const auto& kept = ctx.model.collider.last_contacts();
    std::vector<std::uint8_t>& stays = ctx.work.edits_stay;
    stays.resize(kept.size());  // reserve_edit() has reserved the capacity
    bool any = false;
    assembly::Contacts& c = ctx.model.system.contacts;
    for (std::size_t i = 0; i < kept.size(); ++i) {
        stays[i] = kept[i].shape[0] != shape && kept[i].shape[1] != shape;
        if (stays[i] != 0) continue;
        any = true;
        // Wake the bodies on both sides of the contact.
        for (const auto& side : c.memory[i].body)
            for (const std::int32_t b : side)
                if (b >= 0) context::wake_island(ctx.model, b);
    }
    if (!any) return;
    std::vector<collide::Contact>& shown = ctx.state.contacts.contacts;
    if (shown.size() == kept.size()) {
        std::size_t awake = 0;
        for (std::size_t i = 0; i < ctx.state.contacts.awake; ++i) awake += stays[i];
        ctx.state.contacts.awake = awake;
        compact(shown, stays, 1);
        compact(ctx.state.contact_impulse, stays, 3);
        compact(ctx.state.contact_sliding, stays, 1);
    }
    c.forget(stays);
    ctx.model.collider.forget_contacts(stays);
    ctx.work.stats.contacts = static_cast<std::int32_t>(shown.size());
}

void reserve_edit(context::StepContext& ctx) {
    base::reserve_more(ctx.state.edits.interactions, 1);
    ctx.work.edits_stay.reserve(ctx.model.collider.last_contacts().size());
    ctx.model.collider.reserve_more();
}

void begin_edit(context::StepContext& ctx) noexcept {
    ctx.state.changed = context::Changed::all;
    split::join_model(ctx.model);
    ctx.state.edits.any = ctx.state.edits.any || ctx.state.started;
}

void begin_shape_edit(context::StepContext& ctx) noexcept {
    // Cuts have ghost bodies, which have no shapes.
    const bool alone = ctx.state.started && ctx.state.changed != context::Changed::all &&
                       !split::may_split(ctx.model);
    begin_edit(ctx);
    if (alone) ctx.state.changed = context::Changed::shapes;
}

double energy_of_body(const context::StepContext& ctx, std::int32_t body) noexcept {
    const model::Bodies& b = ctx.model.bodies;
    const int dof = b.dof(body);
    if (!ctx.state.started || dof == 0) return 0.0;
    double energy = assembly::kinetic_energy_of(b, body, b.v.data());
    const double* v = &b.v[at(b.dof_begin[at(body)])];
    for (int k = 0; k < 3 && dof != 1 && b.weight[at(body)] != 0; ++k)
        energy -= b.mass[at(body)] * ctx.model.def.gravity[k] *
                  (b.x[3 * at(body) + at(k)] - 0.5 * ctx.model.def.step * v[k]);
    return energy;
}

double energy_of_interaction(const context::StepContext& ctx, std::int32_t id) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    if (!ctx.state.started || (in.flags[at(id)] & model::kFriction)) return 0.0;
    const KindInfo& kind = kind_info(in.def[at(id)].kind);
    if (kind.is(kAlongLine) && !kind.is(kWoundUp)) return energy_of_line(ctx, id);
    return in.elastic(id, ctx.model.bodies, ctx.model.def.step);
}

double piece_energy(const context::StepContext& ctx, std::int32_t id) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    const model::Bodies& b = ctx.model.bodies;
    const std::int32_t* body = &in.body[kMaxInteractionBodies * at(id)];
    if (!ctx.state.started || !(in.pair_mass[at(id)] > 0.0) || in.parted[at(id)] != 0 ||
        !ctx.model.system.consistent_mass || b.dof(body[0]) != 3 || b.dof(body[1]) != 3)
        return 0.0;
    const double *v0 = &b.v[at(b.dof_begin[at(body[0])])], *v1 = &b.v[at(b.dof_begin[at(body[1])])];
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) sum += (v1[k] - v0[k]) * (v1[k] - v0[k]);
    return 0.5 * in.pair_mass[at(id)] * sum;
}

void register_added_body(context::StepContext& ctx, std::int32_t body) noexcept {
    ctx.state.ledger.edited.given += energy_of_body(ctx, body);
}

void register_added_interaction(context::StepContext& ctx, std::int32_t id) noexcept {
    ctx.state.ledger.edited.given += energy_of_interaction(ctx, id) - piece_energy(ctx, id);
    if (ctx.state.started) ctx.state.edits.interactions.push_back(id);
    disturb_bodies(ctx, id);
}

void register_added_shape(context::StepContext& ctx, std::int32_t shape) noexcept {
    if (ctx.work.stats.asleep == 0) return;
    ctx.model.collider.for_each_overlapping(shape, ctx.model.bodies, ctx.model.def.step,
                                            [&](const collide::Shape& other) {
                                                for (const std::int32_t b : other.body)
                                                    if (b >= 0) context::wake_island(ctx.model, b);
                                            });
    for (const std::int32_t b : ctx.model.collider.shapes()[at(shape)].body)
        if (b >= 0) context::wake_island(ctx.model, b);
}

void remove_body(context::StepContext& ctx, std::int32_t body) noexcept {
    ctx.state.ledger.edited.given -= energy_of_body(ctx, body);
    if (ctx.model.bodies.asleep[at(body)] != 0) --ctx.work.stats.asleep;
    ctx.model.bodies.remove(body);
}

void remove_interaction(context::StepContext& ctx, std::int32_t id) noexcept {
    ctx.state.ledger.edited.given -= energy_of_interaction(ctx, id) - piece_energy(ctx, id);
    disturb_bodies(ctx, id);
    std::erase(ctx.state.edits.interactions, id);
    ctx.model.interactions.remove(id, ctx.model.bodies);
}

void remove_shape(context::StepContext& ctx, std::int32_t shape) noexcept {
    forget_contacts(ctx, shape);
    for (const std::int32_t b : ctx.model.collider.shapes()[at(shape)].body)
        if (b >= 0) context::wake_island(ctx.model, b);
    ctx.model.collider.remove(shape);
}

}  // namespace hawser::edit
