// SPDX-License-Identifier: Apache-2.0
/// Save and restore: a header that identifies the world's layout, the arrays of the state in a
/// fixed order, and a checksum. Multipliers and slack flags belong to the state, because geometric
/// stiffness and the active set start from them.
#include <hawser/world.h>

#include "base/hash.h"
#include "context/asleep.h"
#include "context/context.h"
#include "context/regroup_data.h"
#include "context/wire_alerts.h"
#include "split/split.h"
#include "step/prepare.h"
#include "step/ready.h"
#include "world/identity.h"
#include "world/impl.h"
#include "world/saved_state.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace hawser {
namespace {

using world::Header;
using world::layout_of;
using world::parameters_of;
using world::visit_groups;
using world::visit_state;

/// Return true if the numbers of entries of a header fit into a number of bytes.
bool fits_into(const Header& h, std::size_t bytes) {
    const auto fit = [&](std::uint64_t n, std::size_t size) { return n <= bytes / size; };
    return fit(h.contacts, sizeof(collide::KeptContact) + sizeof(assembly::ContactMemory)) &&
           fit(h.resistances, sizeof(assembly::ResistanceMemory)) &&
           fit(h.links, sizeof(assembly::Contacts::Link) + sizeof(std::int64_t)) &&
           fit(h.nodes, sizeof(std::int32_t) + 1) && fit(h.chained, sizeof(std::int32_t)) &&
           fit(h.units, sizeof(std::int32_t)) && fit(h.chains, sizeof(std::int32_t) + 2);
}

/// Resize the arrays of the state with one entry per contact, and clear the contacts for readers.
void resize_contacts(context::StepContext& ctx, std::size_t count, std::size_t resistances) {
    ctx.model.collider.last_contacts().resize(count);
    ctx.model.system.contacts.memory.resize(count);
    ctx.model.system.contacts.resistances.memory.resize(resistances);
    ctx.state.contacts.contacts.clear();
    ctx.state.contacts.awake = 0;
    ctx.state.contact_impulse.clear();
    ctx.state.contact_sliding.clear();
    ctx.work.stats.contacts = 0;
}

/// Read the saved groups. @return false if they are invalid.
bool read_groups(const context::StepContext& ctx, const std::byte* from, context::Regroup& out) {
    out.parts.part.resize(ctx.model.regroup.parts.part.size());
    visit_groups(out, [&](void* to, std::size_t n) {
        if (n > 0) std::memcpy(to, from, n);
        from += n;
    });
    for (std::size_t b = 0; b < out.parts.part.size(); ++b) {
        const std::int32_t part = out.parts.part[b];
        const bool moves = ctx.model.bodies.dof(static_cast<std::int32_t>(b)) > 0;
        if (moves ? part < 0 || part >= out.parts.parts : part != graph::kNoPart) return false;
    }
    return out.parts.part.empty() || out.parts.parts == ctx.model.regroup.parts.parts;
}

/// Apply saved groups with their ghost bodies and duplicated rows.
/// @return true if the groups differed.
bool apply_saved_groups(context::StepContext& ctx, const context::Regroup& saved) {
    if (ctx.model.regroup.parts.part == saved.parts.part) return false;
    ctx.model.regroup.parts.part = saved.parts.part;
    if (split::assign_groups(ctx.model) == 0) return false;
    ctx.state.changed = context::Changed::all;
    step::prepare(ctx);
    return true;
}

/// Analyse at the poses at which the saved world was analysed. The state is unchanged.
void analyse_as_saved(context::StepContext& ctx, const factor::AnalysisState& order) {
    const auto x = ctx.model.bodies.x;
    const auto r = ctx.model.bodies.r;
    const auto active = ctx.model.interactions.active;
    ctx.model.bodies.x = ctx.state.analysed_x;
    ctx.model.bodies.r = ctx.state.analysed_r;
    split::analyse(ctx, &order);
    ctx.model.bodies.x = x;
    ctx.model.bodies.r = r;
    ctx.model.interactions.active = active;
}

/// States of systems, restored to the old ones unless they are kept.
class SystemsAsSaved {
  public:
    SystemsAsSaved(world::Systems& systems, std::size_t bytes)
        : systems_(systems), saved_states_(bytes) {
        systems_.save(saved_states_.data());
    }
    ~SystemsAsSaved() {
        if (!kept_) systems_.restore(saved_states_.data());
    }
    SystemsAsSaved(const SystemsAsSaved&) = delete;
    SystemsAsSaved& operator=(const SystemsAsSaved&) = delete;
    void keep() noexcept { kept_ = true; }

  private:
    world::Systems& systems_;
    std::vector<std::byte> saved_states_;
    bool kept_ = false;
};

/// Write the arrays of a saved state into the world. They must have been checked.
/// @throws DefError for an elimination order that does not belong to this system. The state is then
///        invalid.
void apply_saved_arrays(context::StepContext& ctx, std::vector<double>& inputs,
                        const Header& header, const std::byte* from, bool regrouped) {
    const auto analysed_x = ctx.state.analysed_x;
    const auto analysed_r = ctx.state.analysed_r;
    const auto links = ctx.model.system.contacts.links;
    const auto asleep = ctx.model.bodies.asleep;
    const auto asked = ctx.model.cuts.asked;
    resize_contacts(ctx, header.contacts, header.resistances);
    ctx.model.system.contacts.links.resize(header.links);
    ctx.model.system.contacts.link_used.resize(header.links);
    factor::AnalysisState order = world::allocate_order(header);
    visit_state(ctx, inputs, order, [&](void* to, std::size_t n) {
        if (n > 0) std::memcpy(to, from, n);
        from += n;
    });
    const bool relinked = links != ctx.model.system.contacts.links;
    if (relinked) ctx.model.system.contacts.make_blocks();
    context::check_asleep(ctx.model, ctx.work.stats);
    context::update_wire_flags(ctx.model);
    if (regrouped || relinked || asked != ctx.model.cuts.asked ||
        asleep != ctx.model.bodies.asleep || ctx.state.analysed_x != analysed_x ||
        ctx.state.analysed_r != analysed_r || ctx.model.system.analysis.state() != order)
        analyse_as_saved(ctx, order);
    // A world with another form of its equations plans a new order.
    const factor::AnalysisState now = ctx.model.system.analysis.state();
    if (now != order && now.elimination.order.size() == order.elimination.order.size())
        throw DefError("snapshot: its order of elimination is none of this world's");
}

}  // namespace

std::vector<std::byte> WorldStateView::save() const {
    std::vector<std::byte> out;
    save(out);
    return out;
}

std::vector<std::byte> WorldStateView::save_motion() const {
    const world::Using use(impl().use, "save_motion");
    std::vector<std::byte> out;
    impl().write_saved(out, false);
    return out;
}

void WorldStateView::save(std::vector<std::byte>& out) const {
    const world::Using use(impl().use, "save");
    impl().write_saved(out, true);
}

void WorldImpl::write_saved(std::vector<std::byte>& out, bool with_systems) {
    WorldImpl& m = *this;
    step::ready(m.ctx);
    Header header;
    header.layout = layout_of(m.ctx, m.inputs.size());
    header.parameters = parameters_of(m.ctx, m.body_defs, m.inputs, m.shape_defs);
    header.contacts = m.ctx.model.collider.last_contacts().size();
    header.resistances = m.ctx.model.system.contacts.resistances.memory.size();
    header.links = m.ctx.model.system.contacts.links.size();
    m.ctx.model.system.analysis.keep(m.saved_analysis);
    const factor::AnalysisState& order = m.saved_analysis.state;
    const factor::Chains& chains = order.elimination.chains;
    header.grouped = m.ctx.model.regroup.parts.part.size();
    header.nodes = order.elimination.order.size();
    header.chained = chains.nodes.size();
    header.units = chains.unit_begin.size() - 1;
    header.chains = chains.begin.size() - 1;
    visit_state(m.ctx, m.input_values, order,
                [&](const void*, std::size_t n) { header.bytes += n; });
    header.systems = with_systems ? m.systems.layout() : world::Systems::no_layout();
    header.system_bytes = with_systems ? m.systems.state_bytes() : 0;
    out.resize(sizeof header + header.bytes + header.system_bytes + sizeof(std::uint64_t));
    m.remove_user_forces();  // input forces follow from their values
    std::byte* to = out.data();
    auto put = [&](const void* from, std::size_t n) {
        if (n > 0) std::memcpy(to, from, n);
        to += n;
    };
    put(&header, sizeof header);
    visit_state(m.ctx, m.input_values, order, put);
    m.add_up_forces();
    if (with_systems) m.systems.save(to);
    to += header.system_bytes;
    const std::uint64_t sum = base::checksum(out.data(), out.size() - sizeof sum);
    put(&sum, sizeof sum);
}

void WorldImpl::restore_saved_bytes(World& self, std::span<const std::byte> bytes, bool variant) {
    WorldImpl& m = *this;
    Header header;
    const Header expected;
    std::uint64_t sum = 0, size = 0;
    if (bytes.size() < sizeof header + sizeof sum) throw DefError("snapshot: too short");
    std::memcpy(&header, bytes.data(), sizeof header);
    std::memcpy(&sum, bytes.data() + bytes.size() - sizeof sum, sizeof sum);
    if (std::memcmp(header.magic, expected.magic, sizeof header.magic) != 0)
        throw DefError("snapshot: not a Hawser snapshot of this version");
    if (header.layout != layout_of(m.ctx, m.inputs.size()))
        throw DefError(
            "snapshot: it belongs to a world with other bodies, interactions, inputs "
            "or another step");
    if (!variant && header.parameters != parameters_of(m.ctx, m.body_defs, m.inputs, m.shape_defs))
        throw DefError(
            "snapshot: it belongs to a world with other parameters (masses, inertias, points, "
            "lengths, stiffnesses, damping, gravity, ranges of inputs, method, coupling, sleep)");
    if (header.systems != m.systems.layout())
        throw DefError(
            "snapshot: it belongs to a world with other systems; add the same systems, in the same "
            "order and with states of the same size");
    step::ready(m.ctx);
    const auto damaged = [] { return DefError("snapshot: the bytes are damaged (checksum)"); };
    if (sum != base::checksum(bytes.data(), bytes.size() - sizeof sum)) throw damaged();
    // Errors found in the bytes alone are reported before any change. Other errors are reported
    // after an undo.
    visit_groups(m.ctx.model.regroup, [&](const void*, std::size_t n) { size += n; });
    context::Regroup regroup;
    if (header.grouped != m.ctx.model.regroup.parts.part.size() ||
        !fits_into(header, bytes.size()) || bytes.size() < sizeof header + size + sizeof sum ||
        !read_groups(m.ctx, bytes.data() + sizeof header, regroup))
        throw damaged();
    const bool regrouped = apply_saved_groups(m.ctx, regroup);
    world::SavedState state(m.ctx, m.input_values, header);
    size = state.size();
    const std::size_t system_bytes = m.systems.state_bytes();
    if (header.bytes != size || header.system_bytes != system_bytes ||
        bytes.size() != sizeof header + size + system_bytes + sizeof sum)
        throw damaged();
    state.read(bytes.subspan(sizeof header, size));
    world::check_state(m.ctx, m.inputs, state);
    SystemsAsSaved of_systems(m.systems, system_bytes);
    m.systems.restore(bytes.data() + sizeof header + size);
    m.systems.check_states(self);
    apply_saved_arrays(m.ctx, m.input_values, header, bytes.data() + sizeof header, regrouped);
    m.ctx.state.time = static_cast<double>(m.ctx.state.step) * m.ctx.model.def.step;
    m.ctx.work.stats.step = m.ctx.state.step;
    m.ctx.work.stats.time = m.ctx.state.time;
    // Parameters and forces follow their inputs, lines follow their drums.
    if (variant) {
        m.set_user_forces();
        m.ctx.state.monitor.state = {};
        m.ctx.state.monitor.verdict = {};
    } else {
        m.add_user_forces();
    }
    for (std::size_t i = 0; i < m.inputs.size(); ++i)
        if (m.inputs[i].interaction.valid()) m.apply_input(i, m.input_values[i]);
    for (const auto* list : {&m.ctx.model.interactions.frictions, &m.ctx.model.interactions.spans})
        for (const std::int32_t id : *list)
            m.ctx.model.interactions.set_anchor(
                id, m.ctx.model.interactions.anchor[static_cast<std::size_t>(id)]);
    for (const std::int32_t id : m.ctx.model.interactions.winches)
        m.ctx.model.interactions.update_length_at_drum(id, m.ctx.model.bodies,
                                                       m.ctx.model.def.step);
    of_systems.keep();
}

}  // namespace hawser
