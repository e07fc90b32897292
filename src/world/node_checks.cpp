// SPDX-License-Identifier: Apache-2.0
/// Checks for inserting and removing a node of a wire (hawser/wire.h).
#include "edit/node_pieces.h"
#include "edit/nodes.h"
#include "world/checks.h"
#include "world/impl.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace hawser {

/// Check that a node can be inserted in an element. @throws DefError with the remedy.
void WorldImpl::check_node(InteractionId element, double share, double mass) const {
    const model::Interactions& in = ctx.model.interactions;
    const std::size_t e = index_of(element);
    const world::Where where("interaction", in.def[e].name);
    if (!kind_info(in.def[e].kind).is(kWireElement) || in.parted[e] != 0)
        world::throw_def_error(where, "only elements of wires that are whole have nodes");
    if (systems.only_systems_edit_nodes(element))
        world::throw_def_error(where,
                               "its winch inserts nodes there; choose an element farther away");
    if (!(share > 0.0 && share < 1.0))
        world::throw_def_error(
            where, "a node needs a fraction between 0 and 1, not " + world::number(share));
    if (kind_info(in.def[e].kind).is(kWoundUp)) {
        if (!(mass > 0.0 && mass < 1e12))
            world::throw_def_error(where, "a drum pays it out: its mass must be given, not " +
                                              world::number(mass) + " kg");
        const auto lump = [&](std::size_t slot) {
            return edit::is_free_node(ctx, edit::end_of(ctx, element.index, slot));
        };
        if (lump(0) && lump(1))
            world::throw_def_error(where, "its fairlead must not be on a point mass");
    } else if (!std::isnan(mass)) {
        world::throw_def_error(where, "its mass is its own; leave it out");
    } else if (!(edit::mass_of_element(ctx, element.index) > 0.0)) {
        world::throw_def_error(where, "it has no mass for a new node (give it `mass`)");
    }
    if ((in.flags[e] & model::kFromLength) == 0)
        world::throw_def_error(where, "its compliance is not that of its length; leave it out");
}

/// Check that the elements on both sides of a node have one line type, so that one element can
/// replace both. Edits change rest lengths, so masses per length may differ slightly.
/// @throws DefError.
void WorldImpl::check_one_line_type(BodyId node, const edit::NodeSurroundings& place) const {
    constexpr double kSameMassTolerance = 0.1;
    const model::Interactions& in = ctx.model.interactions;
    const InteractionDef &a = in.def[at(place.first)], &b = in.def[at(place.second)];
    for (const std::int32_t id : {place.first, place.second})
        if (edit::is_at_drum(ctx, id)) return;  // has the line type of the other one
    const double x = a.get("mass") * b.get("length"), y = b.get("mass") * a.get("length");
    if (a.get("EA") == b.get("EA") && std::abs(x - y) <= kSameMassTolerance * std::max(x, y))
        return;
    world::throw_def_error(
        world::Where("body", body_defs[at(node.index)].name),
        "two line types meet at this node; remove nodes on either side of it instead");
}

/// Check that a node can be removed.
/// @return the adjacent element that remains.
/// @throws DefError with the remedy.
std::int32_t WorldImpl::check_node_removable(BodyId node, edit::NodeSurroundings& place,
                                             double bend) const {
    const world::Where where("body", body_defs[at(node.index)].name);
    if (body_defs[at(node.index)].kind != BodyKind::lump ||
        !edit::complete_surroundings(ctx, place))
        world::throw_def_error(where,
                               "it is no node between two elements of a wire, and nothing else");
    const bool second = edit::is_at_drum(ctx, place.second);
    if (second && edit::is_at_drum(ctx, place.first))
        world::throw_def_error(where, "drums pay out both of its elements");
    for (const std::int32_t id : {place.first, place.second}) {
        if (edit::is_at_drum(ctx, id)
                ? (ctx.model.interactions.flags[at(id)] & model::kFromLength) != 0
                : edit::mass_of_element(ctx, id) > 0.0 && edit::is_of_material(ctx, id))
            continue;
        world::throw_def_error(
            where, "its elements have no `mass`, or a compliance that does not match their length");
    }
    check_one_line_type(node, place);
    double own = 0.0;  // mass of the wire
    for (const std::int32_t id : {place.first, place.second})
        own += 0.5 * edit::mass_of_element(ctx, id);
    // The mass that a node kept between two drums or guides is removed with it. Elements may have
    // been ten times as long, on either side.
    constexpr double kMaxKeptMass = 10.0 * 2.0 * edit::kKeptMass;
    const bool drum = second || edit::is_at_drum(ctx, place.first);
    const double more = drum ? kMaxKeptMass : 1e-6;  // otherwise rounding
    if (body_defs[at(node.index)].mass > (1.0 + more) * own)
        world::throw_def_error(
            where, "it has " + world::number(body_defs[at(node.index)].mass - own) +
                       " kg of gear or a load in addition to the wire, which would be lost");
    if (!(bend >= 0.0))
        world::throw_def_error(where, "bend must be an angle, not " + world::number(bend));
    const std::int32_t stays = second ? place.second : place.first;
    if (systems.only_systems_edit_nodes(ctx.model.interactions.id(stays)))
        world::throw_def_error(where,
                               "its winch removes it when it hauls; choose one farther away");
    check_not_needed(node, ctx.model.interactions.id(stays));
    return stays;
}

}  // namespace hawser
