// SPDX-License-Identifier: Apache-2.0
/// Cutting of wires in two (hawser/wire.h, edit/wire_ends.h).
#include <hawser/world.h>

#include "context/push_event.h"
#include "context/wire_alerts.h"
#include "edit/node_pieces.h"
#include "edit/nodes.h"
#include "edit/wire_ends.h"
#include "split/split.h"
#include "world/checks.h"
#include "world/impl.h"

#include <algorithm>
#include <cctype>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hawser {
namespace {

/// Fraction of an element at its node within which a cut is at the node, so that no tiny element
/// remains.
constexpr double kNodeFraction = 1e-3;

/// Ratio to the next element below which a cut element at an end is joined with it. The light node
/// between them would move faster than a step resolves.
constexpr double kMinLengthRatio = 0.25;

/// Return the first unused name for a piece, such as "tow/2" if the wire tow or one of its pieces
/// is cut.
std::string next_name(const world::Names& names, const std::string& of) {
    std::string base = of;
    const std::size_t slash = of.rfind('/');
    if (slash != std::string::npos && slash + 1 < of.size() &&
        std::all_of(of.begin() + static_cast<std::ptrdiff_t>(slash) + 1, of.end(),
                    [](unsigned char c) { return std::isdigit(c) != 0; }))
        base.resize(slash);
    for (int k = 2;; ++k)
        if (std::string name = base + "/" + std::to_string(k); !names.contains(name)) return name;
}

/// The second piece of a wire, and the bodies on it. Capacity for both is reserved before the cut.
class SecondPiece {
  public:
    SecondPiece(const world::Wire& whole, std::string_view name, int bodies) {
        wire.begin(name, whole.owns);
        wire.trim = whole.trim;
        wire.nodes.reserve(whole.nodes.size() + 2);
        wire.lumps.reserve(whole.lumps.size() + 2);
        for (auto* list : {&wire.elements, &wire.bends}) list->reserve(whole.elements.size() + 2);
        wire.bends.reserve(whole.bends.size() + 2);
        wire.shapes.reserve(whole.shapes.size() + 2);
        constexpr std::size_t kMaxAddedBodies = 4;
        on_second_piece_.assign(at(bodies) + kMaxAddedBodies, 0);
    }
    /// Move the elements, nodes and other objects behind a cut from a wire to this second piece.
    /// @param second  First element of the piece.
    /// @param end  Its first node.
    void move_behind_cut(world::Wire& whole, InteractionId second, BodyId end,
                         const model::Interactions& in,
                         const collide::Collider& collider) noexcept {
        const auto k = std::find(whole.elements.begin(), whole.elements.end(), second) -
                       whole.elements.begin();
        wire.elements.assign(whole.elements.begin() + k, whole.elements.end());
        whole.elements.resize(static_cast<std::size_t>(k));
        wire.nodes.assign(1, end);
        wire.nodes.insert(wire.nodes.end(), whole.nodes.begin() + k + 1, whole.nodes.end());
        whole.nodes.resize(static_cast<std::size_t>(k) + 1);
        for (const BodyId id : wire.nodes) on_second_piece_[at(id.index)] = 1;
        move(whole.lumps, wire.lumps, [&](BodyId id) { return id.index; });
        move(whole.bends, wire.bends,
             [&](InteractionId id) { return in.body[kMaxInteractionBodies * at(id.index) + 1]; });
        move(whole.shapes, wire.shapes, [&](ShapeId id) {
            // A body may hold both pieces.
            const collide::Shape& s = collider.shapes()[at(id.index)];
            return s.body[s.held == 1 ? 0 : 1];
        });
        if (whole.owns) wire.lumps.push_back(end);
    }
    world::Wire wire;

  private:
    template <class Id, class F>
    void move(std::vector<Id>& from, std::vector<Id>& to, F&& body_of) noexcept {
        const auto is_behind = [&](Id id) {
            const std::int32_t body = body_of(id);
            return body >= 0 && at(body) < on_second_piece_.size() &&
                   on_second_piece_[at(body)] != 0;
        };
        for (const Id id : from)
            if (is_behind(id)) to.push_back(id);
        std::erase_if(from, is_behind);
    }
    std::vector<std::uint8_t> on_second_piece_;  ///< By body.
};

/// Return a body like the adjacent node, or like the nodes at the ends of an element.
BodyDef end_body(const World& w, const InteractionDef& element) {
    BodyDef out{.kind = BodyKind::lump, .position = w.pose(element.body[0]).position};
    out.mass = 1.0;
    for (std::size_t b = 2; b-- > 0;) {
        const BodyDef& end = w.body_def(element.body[b]);
        if (end.kind != BodyKind::lump) continue;
        out.gravity = end.gravity;
        out.group = end.group;
    }
    return out;
}

}  // namespace

void WorldImpl::divide_load(BodyId from, BodyId to, double share) noexcept {
    BodyDef &a = body_defs[at(from.index)], &b = body_defs[at(to.index)];
    b.force = share * a.force;
    a.force -= b.force;
    for (const BodyId id : {from, to})
        for (int i = 0; i < 3; ++i) add_up_force(id, i);
}

void WorldImpl::update_definition(BodyId lump) noexcept {
    body_defs[at(lump.index)].mass = ctx.model.bodies.mass[at(lump.index)];
    body_defs[at(lump.index)].linear_damping = edit::damping_of(ctx, lump.index);
}

/// Divide a wire at a node: attach the objects that begin at this node to the node `end`, which has
/// been added at the same position.
void WorldImpl::split_wire_at_node(const edit::NodeSurroundings& place, BodyId end) noexcept {
    model::Interactions& in = ctx.model.interactions;
    const BodyId node = ctx.model.bodies.id(place.node), far = in.def[at(place.second)].body[1];
    const edit::NodeFraction part = edit::fraction_of(ctx, node.index, place.first, place.second);
    edit::begin_edit(ctx);
    edit::split_node(ctx, node.index, end.index, part);
    divide_load(node, end, part.share);
    const ShapeId segment = segment_between(node.index, far.index);
    if (segment.valid()) move_segment(segment, 0, end);
    if (place.bend[1] >= 0) remove(in.id(place.bend[1]));
    edit::move_end(ctx, place.second, 0, end.index);
    if (place.bend[2] >= 0) in.rewire(place.bend[2], 0, end, ctx.model.bodies);
    for (const BodyId lump : {node, end}) {
        edit::update_elements_of_node(ctx, lump.index);
        update_definition(lump);
    }
}

InteractionId WorldImpl::element_at(BodyId node, std::size_t side) noexcept {
    edit::NodeSurroundings place{.node = node.index};
    (void)edit::complete_surroundings(ctx, place);
    return ctx.model.interactions.id(side == 0 ? place.first : place.second);
}

/// Join a short element at an end of a wire with the next element.
/// @param side  0: the end is the first end of the element, 1: its last one.
void WorldImpl::join_short_end(World& world, InteractionId end, std::size_t side) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    edit::NodeSurroundings place{.node = in.def[at(end.index)].body[1 - side].index};
    if (!edit::is_free_node(ctx, place.node) || !edit::complete_surroundings(ctx, place)) return;
    const std::int32_t next = side == 0 ? place.second : place.first;
    if (in.rest_length[at(end.index)] >= kMinLengthRatio * in.rest_length[at(next)]) return;
    try {
        const SilencedListener silenced(*this);
        (void)world.wires().remove_node(ctx.model.bodies.id(place.node), std::numbers::pi);
    } catch (const std::exception&) {
        return;  // an object that holds the node also keeps the element
    }
}

/// Return true if a drum or guide has the mass of an element of a wire.
bool WorldImpl::is_carried(const world::Wire& wire, std::size_t element) const noexcept {
    return systems.carried_mass(wire.elements[element]) != 0.0;
}

/// Find the point of a cut near an element with is_carried(), whose nodes have no mass to divide.
/// The cut is in the nearest element beyond, at a quarter of its length.
/// @param node  Index of the node at the cut.
/// @param s  Material coordinate of the cut [m].
/// @return the element, and the fraction of its length at which the cut lies.
std::pair<InteractionId, double> WorldImpl::cut_outside_carried(const world::Wire& wire,
                                                                std::size_t node,
                                                                double s) const noexcept {
    constexpr double kFractionBeyond = 0.25;
    const model::Interactions& in = ctx.model.interactions;
    std::size_t first = node, last = node;  // range of carried elements
    while (first > 0 && is_carried(wire, first - 1)) --first;
    while (last < wire.elements.size() && is_carried(wire, last)) ++last;
    double begin = 0.0, end = 0.0;
    for (std::size_t k = 0; k < last; ++k) {
        const InteractionId element = wire.elements[k];
        const bool exists = in.slots.names(element);
        const double length = exists ? in.rest_length[at(element.index)] : 0.0;
        if (k < first) begin += length;
        end += length;
    }
    const bool before = first > 0 && (last == wire.elements.size() || s - begin < end - s);
    if (before) return {wire.elements[first - 1], 1.0 - kFractionBeyond};
    // If all are carried, the node is returned and its check reports the reason.
    if (last == wire.elements.size()) return {wire.elements[std::min(node, last - 1)], 0.0};
    return {wire.elements[last], kFractionBeyond};
}

WireId WorldWires::cut(WireId id, double s) {
    const world::Using use(impl().use, "cut");
    const Attempt attempt(*world_, impl().undoes_as_whole());
    const world::Wire& wire = impl().wire(id);
    const std::string where = world::label("wire", wire.name);
    const model::Interactions& in = impl().ctx.model.interactions;
    const double whole = length(id);
    if (!(s > 0.0 && s < whole))
        world::throw_def_error(where, "s = " + world::number(s) +
                                          " m is not within it; give more than 0 and less than its "
                                          "length, " +
                                          world::number(whole) + " m");
    std::size_t k = 0;
    double begin = 0.0, length = 0.0;
    for (;; ++k) {
        length = world_->alive(wire.elements[k]) ? in.rest_length[at(wire.elements[k].index)] : 0.0;
        if (s < begin + length || k + 1 == wire.elements.size()) break;
        begin += length;
    }
    const InteractionId element = wire.elements[k];
    const double share = (s - begin) / length;
    const bool accepts_node = world_->alive(element) && world_->intact(element) &&
                              edit::mass_of_element(impl().ctx, element.index) > 0.0 &&
                              edit::is_of_material(impl().ctx, element.index);
    if (accepts_node && share > kNodeFraction && share < 1.0 - kNodeFraction)
        return cut(element, share);
    if (wire.elements.size() == 1)
        world::throw_def_error(where,
                               "it is one element without mass of its own, in which no node can be "
                               "put; give it more elements, or detach() an end");
    if (k == 0 || (share > 0.5 && k + 1 < wire.elements.size())) ++k;
    if (impl().is_carried(wire, k - 1) || impl().is_carried(wire, k)) {
        const auto [beside, at_fraction] = impl().cut_outside_carried(wire, k, s);
        return cut(beside, at_fraction);
    }
    if (!world_->alive(wire.elements[k - 1]) || !world_->alive(wire.elements[k]))
        world::throw_def_error(where, "s = " + world::number(s) + " m is at a gap in it");
    return cut(wire.elements[k], 0.0);
}

/// Check that a wire can be cut at a node.
/// @throws DefError with the remedy.
void WorldImpl::check_cut_at_node(const std::string& where, edit::NodeSurroundings& place) const {
    if (!edit::is_free_node(ctx, place.node) || !edit::complete_surroundings(ctx, place))
        world::throw_def_error(where,
                               "it does not begin at a node between two elements that nothing else "
                               "holds; cut it elsewhere, or detach() an end");
    for (const std::int32_t id : {place.first, place.second})
        if (systems.carried_mass(ctx.model.interactions.id(id)) != 0.0)
            world::throw_def_error(
                where,
                "the winch has the mass of what it pays out, and the lump next to it "
                "none to share; cut farther out, or detach() the end off the drum");
}

WireId WorldWires::cut(InteractionId element, double share) {
    const world::Using use(impl().use, "cut");
    const Attempt attempt(*world_, impl().undoes_as_whole());
    WorldImpl& m = impl();
    context::StepContext& c = m.ctx;
    model::Interactions& in = c.model.interactions;
    const std::size_t e = m.index_of(element);
    const InteractionDef def = in.def[e];
    const std::string where = world::label("interaction", def.name);
    if (!kind_info(def.kind).is(kWireElement) || in.parted[e] != 0)
        world::throw_def_error(where, "only elements of wires that are whole are cut");
    if (!(share >= 0.0 && share < 1.0))
        world::throw_def_error(
            where, "it is cut at a share from 0 to below 1, not " + world::number(share));
    m.update_wire_of(element);
    if (context::has_cuts(c.model)) edit::begin_edit(c);  // remove duplicated rows first
    edit::NodeSurroundings place{.node = def.body[0].index};
    if (share == 0.0) m.check_cut_at_node(where, place);
    m.reserve_removal();
    std::int32_t vacant = -1;
    world::Wire made;
    made.lumps.reserve(1);
    // Names are claimed last, and released if a node does not fit.
    std::optional<SecondPiece> second;
    const WorldImpl::Mark before = m.mark(def.body[0], def.body[1]);
    const context::Edited edited = c.state.ledger.edited;
    BodyId node = def.body[0];
    bool claimed = false;
    try {
        const WorldImpl::SilencedListener silenced(m);
        made.lumps.push_back(world_->add_body(end_body(*world_, def)));
        c.state.ledger.edited = edited;
        if (const world::Wire* wire = m.wire_with(element); wire != nullptr) {
            second.emplace(*wire, next_name(m.wires.names, wire->name), world_->body_count());
            vacant = m.reserve_wire_slot(second->wire.name);
            claimed = true;
        }
        if (share > 0.0) node = insert_node(element, share);
        m.reserve_removal();
    } catch (...) {
        if (claimed) world::release(m.wires.names, second->wire.name);
        m.take_back(before, made);
        throw;
    }
    // No call below throws.
    const BodyId end = made.lumps[0];
    // A taut wire is straight before the cut, so a node can be removed now; on a slack one later.
    if (share > 0.0)
        for (const std::size_t side : {0U, 1U})
            m.join_short_end(*world_, m.element_at(node, side), 1 - side);
    place = {.node = node.index};
    (void)edit::complete_surroundings(c, place);
    const double tension = edit::tension_of(c, place.first);
    context::begin_recoil(c.model, element.index, false);
    m.split_wire_at_node(place, end);
    context::push_event(c, EventKind::cut, place.first, tension);
    WireId out{};
    if (second) {
        world::Wire* wire = m.wire_with(in.id(place.first));
        second->move_behind_cut(*wire, in.id(place.second), end, in, c.model.collider);
        std::erase_if(wire->bends, [&](InteractionId id) { return !world_->alive(id); });
        out = m.put_wire(second->wire, vacant);
    }
    if (share > 0.0) {
        const InteractionId ends[] = {in.id(place.first), in.id(place.second)};
        m.join_short_end(*world_, ends[0], 1);
        m.join_short_end(*world_, ends[1], 0);
    }
    if (m.listener != nullptr) m.listener->cut(element, share);
    return out;
}

}  // namespace hawser
