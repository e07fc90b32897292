// SPDX-License-Identifier: Apache-2.0
#include "assembly/system.h"

#include "base/index.h"
#include "model/arms.h"

#include <algorithm>

namespace hawser::assembly {
namespace {

/// True if the force of an interaction is bounded. Motors without a range do not count, unless an
/// input may set a range.
bool is_bounded(const model::Interactions& in, int id) {
    const int flags = in.flags[at(id)];
    if (flags & (model::kOneSided | model::kRange | model::kFriction)) return true;
    return (flags & model::kMotor) &&
           ((flags & model::kByInput) || in.low[at(id)] > -model::kUnbounded ||
            in.high[at(id)] < model::kUnbounded || in.power[at(id)] < model::kUnbounded);
}

}  // namespace

void System::analyse(const model::Bodies& bodies, model::Interactions& interactions,
                     const WorldDef& def, int threads, const factor::AnalysisState* state) {
    find_resting(bodies, interactions);
    reserve(bodies, interactions);
    find_capstans(interactions, def);
    strips.build(dof_, rests_, interactions);
    build_incidence(bodies, interactions);
    find_islands(interactions);
    interaction_offset_.assign(at(interactions.count()), -1);
    body_offset_.assign(at(bodies.count()), -1);
    evaluate(bodies, interactions, def);
    split_damping(bodies, interactions, def.step);
    soften_sides(bodies, interactions, def.step);
    choose_forms(bodies, interactions, def);
    find_order(bodies, interactions, state);
    place(bodies, interactions, threads);
}

void System::find_resting(const model::Bodies& bodies, const model::Interactions& in) {
    dof_.resize(at(bodies.count()));
    for (int b = 0; b < bodies.count(); ++b)
        dof_[at(b)] = static_cast<std::uint8_t>(bodies.asleep[at(b)] ? 0 : bodies.dof(b));
    rests_.assign(at(in.count()), 0);
    for (const std::int32_t id : in.slots.vacant()) rests_[at(id)] = 1;
    for (int i = 0; i < in.count(); ++i)
        for (int b = 0; b < in.bodies[at(i)]; ++b)
            rests_[at(i)] |= bodies.asleep[at(in.body[at(kMaxInteractionBodies * i + b)])];
    for (const std::int32_t id : left_out) rests_[at(id)] = 1;
}

void System::reserve(const model::Bodies& bodies, model::Interactions& in) {
    constexpr std::size_t kSlack = 8;  // as in lay_out_rows()
    lay_out_rows(bodies, in);
    body_block_.resize(2 * at(bodies.dofs) + kSlack);
    for (base::Array<double>* a : {&a_, &v_new_}) a->assign(at(bodies.dofs) + kSlack, 0.0);
    for (base::Array<double>* a : {&spin_momentum_, &spin_next_})
        a->assign(3 * at(bodies.count()) + kSlack, 0.0);
    for (base::Array<double>* a : {&c_next_, &rate_}) a->assign(at(in.row_count) + kSlack, 0.0);
    turning.assign(at(bodies.count()), 0);
    momentum_.assign(keeps_momentum ? at(bodies.dofs) + kSlack : 0, 0.0);
    find_bounded(in);
}

/// Find the interactions with a bounded force, and those that can break.
void System::find_bounded(const model::Interactions& in) {
    bounded.clear();
    breakable.clear();
    breaking_load.clear();
    for (int i = 0; i < in.count(); ++i) {
        if (rests(i)) continue;
        if (is_bounded(in, i)) bounded.push_back(i);
        if (in.flags[at(i)] & model::kBreakable) {
            breakable.push_back(i);
            breaking_load.push_back(in.breaking[at(i)]);
        }
    }
}

void System::find_islands(const model::Interactions& in) {
    std::vector<std::int32_t>&member_begin = member_begin_, &members = members_;
    member_begin.assign(1, 0);
    members.clear();
    for (int i = 0; i < in.count(); ++i) {
        for (int b = 0; b < in.bodies[at(i)] && !rests(i); ++b)
            members.push_back(in.body[at(kMaxInteractionBodies * i + b)]);
        member_begin.push_back(static_cast<std::int32_t>(members.size()));
    }
    for (const Contacts::Link& l : contacts.links) {
        members.insert(members.end(), {l.first, l.second});
        member_begin.push_back(static_cast<std::int32_t>(members.size()));
    }
    island_finder_.find(dof_, member_begin, members, islands);
}

namespace {

/// Set the pointers of a view to arrays of bodies.
void show_bodies(model::Bodies& bodies, View& v) noexcept {
    v.body_count = bodies.count();
    v.dof_count = bodies.dofs;
    v.kind = reinterpret_cast<const std::uint8_t*>(bodies.kind.data());
    v.dof_begin = bodies.dof_begin.data();
    v.x = bodies.x.data();
    v.q = bodies.q.data();
    v.r = bodies.r.data();
    v.v = bodies.v.data();
    v.v_start = bodies.v_start.data();
    v.v_ahead = bodies.v_start.data();
    v.v_fixed = bodies.v_fixed.data();
    v.v_before = bodies.v_before.empty() ? bodies.v_fixed.data() : bodies.v_before.data();
    v.spin_free = bodies.spin_free.data();
    v.spin_change = bodies.spin_change.data();
    v.mass = bodies.mass.data();
    v.inertia = bodies.inertia.data();
    v.inv_inertia = bodies.inv_inertia.data();
    v.principal = bodies.principal.data();
    v.force = bodies.force.data();
    v.drag_after = bodies.drag_after.data();
    v.drag_before = bodies.drag_before.data();
    v.weight = bodies.weight.data();
}

/// Set the pointers of a view to arrays of interactions and their rows.
void show_interactions(model::Interactions& in, View& v) noexcept {
    v.interaction_count = in.count();
    v.body = in.body.data();
    v.bodies = in.bodies.data();
    v.rows = in.rows.data();
    v.flags = in.flags.data();
    v.row_begin = in.row_begin.data();
    v.jac_begin = in.jac_begin.data();
    v.arms = in.arms.data();
    v.active = in.active.data();
    v.held = in.held.data();
    v.low = in.low.data();
    v.high = in.high.data();
    v.upper = in.upper.data();
    v.parted = in.parted.data();
    v.lightness = in.lightness.data();
    v.flagged = in.flagged.data();
    v.completed = in.completed.data();
    v.vibration = in.vibration.data();
    v.rest_length = in.rest_length.data();
    v.epsilon = in.epsilon.data();
    v.upsilon = in.upsilon.data();
    v.recall = in.recall.data();
    v.sigma = in.sigma.data();
    v.inv_sigma = in.inv_sigma.data();
    v.row_flags = in.row_flags.data();
    v.g = in.g.data();
    v.c = in.c.data();
    v.residual = in.residual.data();
    v.lambda = in.lambda.data();
    v.multiplier = in.multiplier.data();
    v.force_of_row = in.force.data();
    v.jacobian = in.jacobian.data();
}

}  // namespace

void System::show_own(View& v) noexcept {
    v.dof = dof_.data();
    v.spin_momentum = spin_momentum_.data();
    v.spin_next = spin_next_.data();
    v.turning = turning.data();
    v.body_block = body_block_.data();
    v.a = a_.data();
    v.v_new = v_new_.data();
    v.momentum = keeps_momentum ? momentum_.data() : nullptr;
    v.geo = geo_slot_.data();
    v.c_next = c_next_.data();
    v.rate = rate_.data();
    v.geo_record = geo_record_.data();
    v.geo_force = geo_force_.data();
    v.contact_block = contacts.block_value.data();
    v.contact_block_used = contacts.block_used.data();
    v.contact_impulse = contacts.impulse.empty() ? nullptr : contacts.impulse.data();
    v.incident_begin = incident_begin_.data();
    v.incident = incident_.data();
    v.links = links_.data();
    v.among_nodes = among_nodes_.data();
    v.pair_mass = pair_mass_.empty() ? nullptr : pair_mass_.data();
    v.body_offset = body_offset_.data();
    v.interaction_offset = interaction_offset_.data();
    v.solution = solution_.data();
}

View System::view(model::Bodies& bodies, model::Interactions& in, const WorldDef& def) noexcept {
    static_assert(sizeof(BodyKind) == 1);
    View v{};
    v.h = def.step;
    for (int i = 0; i < 3; ++i) v.gravity[i] = def.gravity[i];
    v.geometric_stiffness = def.geometric_stiffness;
    v.rotation_damping = def.rotation_damping;
    show_bodies(bodies, v);
    show_interactions(in, v);
    show_own(v);
    return v;
}

std::size_t System::bytes() const noexcept {
    using base::bytes;
    return analysis.bytes() + numeric.bytes() + bytes(ops) + bytes(lane_ops) + bytes(column_slot_) +
           bytes(step_begin_) + bytes(pieces_by_slot_) + bytes(member_of_node_) +
           bytes(contact_begin_) + bytes(contact_order_) + sharer_.bytes() + history_.bytes() +
           bytes(ops_before_) + bytes(lane_ops_before_) + bytes(step_ops_) + bytes(steps_before_) +
           bytes(piece_ops_) + bytes(op_slot_) + bytes(lane_slot_) + bytes(skew_ops_) +
           bytes(capstans) + bytes(capstan_entries) + bytes(geo_slot_) + bytes(incident_) +
           bytes(incident_of_) + bytes(incident_begin_) + bytes(body_offset_) +
           bytes(interaction_offset_) + bytes(body_block_) + bytes(a_) + bytes(v_new_) +
           bytes(momentum_) + bytes(spin_momentum_) + bytes(spin_next_) + bytes(c_next_) +
           bytes(rate_) + bytes(turning) + bytes(geo_record_) + bytes(geo_force_) +
           bytes(solution_) + bytes(rests_) + bytes(dof_) + bytes(kept_) + bytes(links_) +
           bytes(among_nodes_) + bytes(pair_mass_) + bytes(node_of_body) +
           bytes(node_of_interaction) + bytes(body_before_) + bytes(interaction_before_) +
           bytes(old_of_new_) + bytes(cursor_) + bytes(side_mobility_) + bytes(member_begin_) +
           bytes(members_) + island_finder_.bytes() + bytes(islands.label) + edge_dealer_.bytes() +
           bytes(edge_from_) + bytes(edge_to_) + bytes(next_.size) + bytes(next_.sign) +
           bytes(next_.start) + bytes(next_.adjacent) + strips.bytes() + contacts.bytes();
}

}  // namespace hawser::assembly
