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
/// *Engage*. The stopper engages the material point nearest to `point` of all wires of the world,
/// if its distance is at most `reach`. The wire gets a node there (WorldWires::insert_node()); a
/// node within 0.1 m is used instead. If elements have no mass, the nearest node within reach is
/// used. The node is held at its present position, so that closing causes no tension in a wire at
/// rest.
///
/// *Hold*. A jaw (`pitch` 0) is a ball joint and holds in both directions. A chain stopper holds in
/// the payout direction only. Its node hangs on a massless link of 1 m that runs inboard from it.
/// The link is slack when chain is hauled in, and yields 1 mm at the rated load. After hauling by
/// `pitch` the pawl engages the next link: the node is held at its new position. Beyond 3 m the
/// stopper engages the nearest point instead.
/// ```
///     ══════o══════  ►  outboard          jaw: o is held to the body
///           │
///     link o├──────o══════  ►             chain stopper: the link pulls inboard, never pushes
///      (body)
/// ```
/// *Open*. Above `rated_load` either type opens. It must be opened and closed before it engages
/// again. A stopper that closes with nothing in reach stays empty until it is opened and closed
/// again. The same applies if another stopper holds the node, since a node has at most one stopper.
/// Two stoppers that are closed at the start within 0.1 m of wire are rejected.
///
/// A stopper is a System (system.h). Input, as "name.signal": `close`, 1 or 0. Outputs: `state` is
/// the number of a StopperState, `held` the number of the engaged wire, 1 the first of
/// WorldWires::ids(), 0: none. Output `load` is the force [N], `at` the material coordinate of the
/// engaged point from the wire's first end [m]. The joint is the interaction NAME/hold.
///
/// Events: `join` on engagement, with the distance from `point` [m]. Event `detach` on release and
/// `overload` above the rated load, with the load [N], one step before the joint is removed. Event
/// `missed` of the body if nothing is engaged, with the distance of the nearest wire [m]. The
/// distance is within `reach` if another stopper holds that wire.
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
    open,     ///< Open.
    closing,  ///< A wire is found, and is held from the next step on.
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
