// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file stopper.h
/// Shark jaws and chain stoppers, which hold a wire or chain on deck.
///
/// ```cpp
/// world.add(hawser::StopperDef{.name = "jaw", .body = ship, .point = {-34, 1, 1.2}, .reach = 0.6,
///                              .rated_load = 7.35e6});
/// world.set_system_signal("jaw.close", 1.0);  // engages a wire within reach
/// world.set_system_signal("jaw.close", 0.0);  // releases it
/// ```
/// *Engagement*. The stopper engages the point of any wire of the world that is nearest to `point`,
/// if the distance is at most `reach`. The wire gets a node there (WorldWires::insert_node()),
/// unless it has a node within 0.1 m. If its elements have no mass, the nearest node within reach
/// is used. The node is held at its present position, so that closing causes no tension in a wire
/// at rest.
///
/// *Hold*. A jaw (`pitch` 0) is a ball joint and holds in both directions. A chain stopper holds in
/// the payout direction only. A massless link of 1 m, which runs inboard from the node, holds the
/// node to the body. The link is slack when chain is hauled in, and yields 1 mm at the rated load.
/// After hauling by `pitch` the pawl engages the next link: the node is held at its new position.
/// After more than 3 m of hauling, the stopper engages the point nearest to `point` instead.
/// ```
///     ══════o══════  ►  outboard          jaw: o is held to the body
///           │
///     link o├──────o══════  ►             chain stopper: the link pulls inboard, never pushes
///      (body)
/// ```
/// *Opening*. Above `rated_load` a stopper opens by itself. It engages again only after `close` has
/// been 0 and then 1. The same applies to a stopper that closes with no wire in reach, and to one
/// whose nearest node is held by another stopper, since a node has at most one stopper. Two
/// stoppers that are closed at the start within 0.1 m of wire are rejected.
///
/// A stopper is a System (system.h). Input, as "name.signal": `close`, 1 or 0. Outputs:
/// - `state`: number of a StopperState;
/// - `held`: number of the engaged wire, 1 the first of WorldWires::ids(); 0: none;
/// - `load`: force of the wire on the stopper [N];
/// - `at`: material coordinate of the engaged point from the wire's first end [m].
///
/// The joint is the interaction NAME/hold. Its events: `join` on engagement, with the distance from
/// `point` [m]; `detach` on release and `overload` above the rated load, with the load [N], one
/// step before the joint is removed. Event of the body: `missed` if no wire is engaged, with the
/// distance of the nearest wire [m]. That distance is within `reach` if another stopper holds that
/// wire.
///
/// Limits: elements at drums, guides and bollards are not engaged. The shape of chain links has no
/// effect: a chain stopper also engages wire. An inserted node is removed after release, once this
/// is possible (WorldWires::remove_node()). Details: docs/deck_gear.md.

#include <hawser/id.h>
#include <hawser/math.h>

#include <cstdint>
#include <string>

namespace hawser {

class World;

/// Operating state of a stopper.
enum class StopperState : std::uint8_t {
    open,     ///< Open; no wire is engaged.
    closing,  ///< A wire is found; it is engaged from the next step on.
    holding,  ///< A wire is engaged.
    opening,  ///< The wire is released in the next step.
    empty,    ///< Closed without a wire; must be opened and closed again.
    tripped,  ///< Opened above its rated load; must be opened and closed again.
};

/// Definition of a stopper. World::add() copies it.
struct StopperDef {
    std::string name{};  ///< Unique name among systems.
    BodyId body{};  ///< Body that carries the stopper; not a lumped mass or scalar body. Required.
    Vec3 point{0.0, 0.0, 0.0};      ///< Position of the jaw, in the frame of the body [m].
    Vec3 outboard{-1.0, 0.0, 0.0};  ///< Payout direction of wire, in the frame of the body.
    double reach = 0.5;             ///< Largest distance of an engaged wire from `point` [m].
    double rated_load = 0.0;        ///< Load above which it opens [N]. Required.
    double pitch = 0.0;             ///< Chain stopper: length of two chain links [m]; 0: a jaw.
    bool closed = false;            ///< True: closed at the start.
};

/// Add a stopper; World::add() calls it.
/// @throws DefError if a required field is missing or a value is out of range, or if the name is
/// already used.
void define(World& world, const StopperDef& def);

}  // namespace hawser
