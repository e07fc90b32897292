// SPDX-License-Identifier: Apache-2.0
/// Save and restore: a header that identifies the world's layout, then the arrays of the
/// state in a fixed order, then a checksum. Multipliers and slack flags belong to the state:
/// geometric stiffness and the active set start from them.
#include <hawser/world.h>

#include "base/hash.h"
#include "stepper/stages.h"
#include "world/identity.h"
#include "world/impl.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace hawser {
namespace {

using world::layout_of;
using world::parameters_of;

struct Header {
    char magic[8] = {'H', 'A', 'W', 'S', 'N', 'P', '1', '5'};
    std::uint64_t layout = 0;       ///< See layout_of().
    std::uint64_t parameters = 0;   ///< See parameters_of().
    std::uint64_t contacts = 0;     ///< Remembered from the last step.
    std::uint64_t resistances = 0;  ///< Those of them that resist rolling or spinning.
    std::uint64_t links = 0;        ///< Pairs of bodies that touched.
    std::uint64_t nodes = 0;        ///< Of the order of elimination.
    std::uint64_t chained = 0, units = 0, chains = 0;  ///< Nodes in chains, and so on.
    std::uint64_t grouped = 0;  ///< Bodies whose groups follow the state: all or none.
    std::uint64_t bytes = 0;    ///< Of the arrays that follow.
};

/// Bytes of one contact in the arrays that resize_contacts() sizes.
constexpr std::size_t kContactBytes =
    sizeof(collide::KeptContact) + sizeof(assembly::ContactMemory);
constexpr std::size_t kResistanceBytes = sizeof(assembly::ResistanceMemory);
constexpr std::size_t kLinkBytes = sizeof(assembly::Contacts::Link) + sizeof(std::int64_t);

/// Arrays of the state with an entry a contact; what was shown of contacts is gone.
void resize_contacts(stepper::StepContext& ctx, std::size_t count, std::size_t resistances) {
    ctx.collider.kept().resize(count);
    ctx.system.contacts.memory.resize(count);
    ctx.system.contacts.resistances.memory.resize(resistances);
    ctx.contacts.contacts.clear();
    ctx.contacts.awake = 0;
    ctx.contact_impulse.clear();
    ctx.contact_sliding.clear();
    ctx.stats.contacts = 0;
}

/// Arrays for an order of elimination.
factor::AnalysisState room_for_order(const Header& header) {
    factor::AnalysisState s;
    s.elimination.order.resize(header.nodes);
    s.between.resize(header.nodes);
    factor::Chains& c = s.elimination.chains;
    c.nodes.resize(header.chained);
    c.unit_begin.resize(header.units + 1);
    c.begin.resize(header.chains + 1);
    c.body_size.resize(header.chains);
    c.reach.resize(header.chains);
    return s;
}

/// Bytes of the order of elimination in the arrays.
std::uint64_t order_bytes(const Header& h) {
    constexpr std::uint64_t kNode = sizeof(std::int32_t) + 1;
    return kNode * h.nodes + sizeof(std::int32_t) * (h.chained + h.units + 1) +
           (sizeof(std::int32_t) + 2) * h.chains + sizeof(std::int32_t);
}

/// Groups that follow the state, which come first: how many images and copies there are depends
/// on them.
template <class Groups, class F>
void visit_groups(Groups& groups, F&& f) {
    f(groups.parts.part.data(), groups.parts.part.size() * sizeof(std::int32_t));
    f(&groups.parts.parts, sizeof groups.parts.parts);
    f(&groups.parts.worse_for, sizeof groups.parts.worse_for);
    f(&groups.made, sizeof groups.made);
    f(&groups.seen, sizeof groups.seen);
}

/// Visit every array of the state with f(pointer, bytes).
template <class Context, class Order, class F>
void visit_state(Context& ctx, std::vector<double>& inputs, Order& order, F&& f) {
    auto array = [&](auto& a) { f(a.data(), a.size() * sizeof(a[0])); };
    auto value = [&](auto& v) { f(&v, sizeof v); };
    visit_groups(ctx.regroup, f);
    array(ctx.bodies.x);
    array(ctx.bodies.q);
    // Kept, not computed anew: the integrator's kernel rounds as its instruction set does.
    array(ctx.bodies.r);
    array(ctx.bodies.v);
    array(ctx.bodies.v_start);
    array(ctx.bodies.v_fixed);
    array(ctx.bodies.spin_change);
    array(ctx.bodies.force);
    // Forms and the floors of rigid rows were chosen at these poses.
    array(ctx.analysed_x);
    array(ctx.analysed_r);
    array(ctx.bodies.asleep);
    array(ctx.bodies.quiet);
    array(ctx.interactions.lambda);
    array(ctx.interactions.force);
    array(ctx.interactions.active);
    array(ctx.interactions.parted);
    array(ctx.interactions.coarse);
    array(ctx.interactions.repeats);
    array(ctx.interactions.saturated);
    array(ctx.interactions.anchor);
    array(ctx.collider.kept());
    value(ctx.collider.kept_awake());
    array(ctx.system.contacts.memory);
    array(ctx.system.contacts.resistances.memory);
    array(ctx.system.contacts.links);
    array(ctx.system.contacts.link_used);
    value(ctx.cuts.asked);
    // Repaired again and again, the order of elimination depends on the past.
    array(order.elimination.order);
    array(order.between);
    array(order.elimination.chains.nodes);
    array(order.elimination.chains.unit_begin);
    array(order.elimination.chains.begin);
    array(order.elimination.chains.body_size);
    array(order.elimination.chains.reach);
    value(order.planned_flops);
    array(inputs);
    value(ctx.step);
    value(ctx.started);
    value(ctx.refine_unasked);
    value(ctx.work);
    value(ctx.drag);
    value(ctx.drive);
    value(ctx.friction);
    value(ctx.contact);
    value(ctx.damped);
    value(ctx.stats.event_count);
}

/// What the bytes say of groups. @return false where that cannot be.
bool read_groups(const stepper::StepContext& ctx, const std::byte* from, stepper::Regroup& out) {
    out.parts.part.resize(ctx.regroup.parts.part.size());
    visit_groups(out, [&](void* to, std::size_t n) {
        if (n > 0) std::memcpy(to, from, n);
        from += n;
    });
    for (std::size_t b = 0; b < out.parts.part.size(); ++b) {
        const std::int32_t part = out.parts.part[b];
        const bool moves = ctx.bodies.dof(static_cast<std::int32_t>(b)) > 0;
        if (moves ? part < 0 || part >= out.parts.parts : part != graph::kNoPart) return false;
    }
    return out.parts.part.empty() || out.parts.parts == ctx.regroup.parts.parts;
}

/// Groups as saved, and the images and copies that come of them. @return whether others were there.
bool take_groups(stepper::StepContext& ctx, const stepper::Regroup& saved) {
    if (ctx.regroup.parts.part == saved.parts.part) return false;
    ctx.regroup.parts.part = saved.parts.part;
    if (stepper::assign_groups(ctx) == 0) return false;
    ctx.topology_changed = true;
    stepper::prepare(ctx);
    return true;
}

/// Analyse at the poses at which the saved world was analysed; the state stays as it is.
void analyse_as_saved(stepper::StepContext& ctx, const factor::AnalysisState& order) {
    const auto x = ctx.bodies.x;
    const auto r = ctx.bodies.r;
    const auto active = ctx.interactions.active;
    ctx.bodies.x = ctx.analysed_x;
    ctx.bodies.r = ctx.analysed_r;
    stepper::analyse(ctx, &order);
    ctx.bodies.x = x;
    ctx.bodies.r = r;
    ctx.interactions.active = active;
}

}  // namespace

std::vector<std::byte> World::save() const {
    Impl& m = *impl_;
    stepper::ready(m.ctx);
    Header header;
    header.layout = layout_of(m.ctx, m.inputs.size());
    header.parameters = parameters_of(m.ctx, m.inputs, m.shape_defs);
    header.contacts = m.ctx.collider.kept().size();
    header.resistances = m.ctx.system.contacts.resistances.memory.size();
    header.links = m.ctx.system.contacts.links.size();
    const factor::AnalysisState order = m.ctx.system.analysis.state();
    const factor::Chains& chains = order.elimination.chains;
    header.grouped = m.ctx.regroup.parts.part.size();
    header.nodes = order.elimination.order.size();
    header.chained = chains.nodes.size();
    header.units = chains.unit_begin.size() - 1;
    header.chains = chains.begin.size() - 1;
    visit_state(m.ctx, m.input_values, order,
                [&](const void*, std::size_t n) { header.bytes += n; });
    std::vector<std::byte> out(sizeof header + header.bytes + sizeof(std::uint64_t));
    std::byte* to = out.data();
    auto put = [&](const void* from, std::size_t n) {
        if (n > 0) std::memcpy(to, from, n);
        to += n;
    };
    put(&header, sizeof header);
    visit_state(m.ctx, m.input_values, order, put);
    const std::uint64_t sum = base::fnv1a(out.data(), out.size() - sizeof sum);
    put(&sum, sizeof sum);
    return out;
}

void World::take_saved(std::span<const std::byte> bytes) {
    Impl& m = *impl_;
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
    if (header.parameters != parameters_of(m.ctx, m.inputs, m.shape_defs))
        throw DefError(
            "snapshot: it belongs to a world with other parameters (masses, inertias, points, "
            "lengths, stiffnesses, damping, gravity, ranges of inputs, method, coupling, sleep)");
    stepper::ready(m.ctx);
    const auto damaged = [] { return DefError("snapshot: the bytes are damaged (checksum)"); };
    if (sum != base::fnv1a(bytes.data(), bytes.size() - sizeof sum)) throw damaged();
    // What is no array of groups is refused before anything changes; what is wrong beyond it, by
    // going back.
    visit_groups(m.ctx.regroup, [&](const void*, std::size_t n) { size += n; });
    stepper::Regroup groups;
    if (header.grouped != m.ctx.regroup.parts.part.size() ||
        bytes.size() < sizeof header + size + sizeof sum ||
        !read_groups(m.ctx, bytes.data() + sizeof header, groups))
        throw damaged();
    std::vector<std::byte> before;
    if (groups.parts.part != m.ctx.regroup.parts.part) before = save();
    const bool regrouped = take_groups(m.ctx, groups);
    size = 0;
    factor::AnalysisState order;
    visit_state(m.ctx, m.input_values, order, [&](const void*, std::size_t n) { size += n; });
    // All but the contacts and the order has the size that this world has.
    constexpr std::uint64_t kMost = std::uint64_t{1} << 32;
    size -= m.ctx.collider.kept().size() * kContactBytes;
    size -= m.ctx.system.contacts.resistances.memory.size() * kResistanceBytes;
    size -= m.ctx.system.contacts.links.size() * kLinkBytes;
    size += std::min(header.contacts, kMost) * kContactBytes;
    size += std::min(header.resistances, kMost) * kResistanceBytes;
    size += std::min(header.links, kMost) * kLinkBytes;
    size -= order_bytes({});
    Header order_of = header;
    for (std::uint64_t* n : {&order_of.nodes, &order_of.chained, &order_of.units, &order_of.chains})
        *n = std::min(*n, kMost);
    size += order_bytes(order_of);
    if (header.bytes != size || bytes.size() != sizeof header + size + sizeof sum) {
        if (!before.empty()) restore(before);
        throw damaged();
    }
    const auto analysed_x = m.ctx.analysed_x;
    const auto analysed_r = m.ctx.analysed_r;
    const auto links = m.ctx.system.contacts.links;
    const auto asleep = m.ctx.bodies.asleep;
    const auto asked = m.ctx.cuts.asked;
    resize_contacts(m.ctx, header.contacts, header.resistances);
    m.ctx.system.contacts.links.resize(header.links);
    m.ctx.system.contacts.link_used.resize(header.links);
    order = room_for_order(header);
    const std::byte* from = bytes.data() + sizeof header;
    visit_state(m.ctx, m.input_values, order, [&](void* to, std::size_t n) {
        if (n > 0) std::memcpy(to, from, n);
        from += n;
    });
    const bool relinked = links != m.ctx.system.contacts.links;
    if (relinked) m.ctx.system.contacts.make_blocks();
    // Whatever the bytes say: what has no freedom is awake, and no more contacts than there are.
    m.ctx.collider.kept_awake() = std::min(m.ctx.collider.kept_awake(), header.contacts);
    stepper::check_asleep(m.ctx);
    m.ctx.refine_unasked = std::max(0, m.ctx.refine_unasked);
    if (regrouped || relinked || asked != m.ctx.cuts.asked || asleep != m.ctx.bodies.asleep ||
        m.ctx.analysed_x != analysed_x || m.ctx.analysed_r != analysed_r ||
        m.ctx.system.analysis.state() != order)
        analyse_as_saved(m.ctx, order);
    m.ctx.time = static_cast<double>(m.ctx.step) * m.ctx.def.step;
    m.ctx.stats.step = m.ctx.step;
    m.ctx.stats.time = m.ctx.time;
    // Parameters follow their inputs, lines their drums; the forces on bodies have just been read
    // as they were, which is not what an input said last if set_force() came after it.
    for (std::size_t i = 0; i < m.inputs.size(); ++i)
        if (m.inputs[i].interaction.valid()) m.apply_input(i, m.input_values[i]);
    for (const std::int32_t id : m.ctx.interactions.frictions)
        m.ctx.interactions.set_anchor(id, m.ctx.interactions.anchor[static_cast<std::size_t>(id)]);
    for (const std::int32_t id : m.ctx.interactions.winches)
        m.ctx.interactions.follow_length(id, m.ctx.bodies, m.ctx.def.step);
}

}  // namespace hawser
