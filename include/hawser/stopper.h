// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file stopper.h
/// What takes a wire or chain on deck, holds it and lets it go again: shark jaws and chain
/// stoppers.
///
/// ```cpp
/// world.add(hawser::StopperDef{.name = "jaw", .body = ship, .point = {-34, 1, 1.2}, .reach = 0.6,
///                              .rated_load = 7.35e6});
/// world.set_system_signal("jaw.close", 1.0);  // takes what lies within its reach
/// world.set_system_signal("jaw.close", 0.0);  // lets it go
/// ```
/// *Take.* Of all wires of the world the material point that lies nearest to `point` is taken,
/// where it is no farther than `reach`. The wire gets a node there (World::insert_node()), or the
/// lump that is within 0.1 m is used, or, where elements have no mass of their own, the nearest one
/// that is within reach. It is held where it is: closing pulls at nothing but what moves.
///
/// *Hold.* A jaw (`pitch` 0) is a ball joint: it holds both ways. A chain stopper holds against
/// paying out alone: its node hangs on a link of 1 m without mass that runs inboard from it, goes
/// slack where chain is hauled in, and gives by 1 mm at the rated load. Hauled in by `pitch` its
/// pawl falls behind the next link: the node is held where it is then. Past 3 m it takes the point
/// that lies nearest instead.
/// ```
///     ══════o══════  ►  outboard          jaw: o is held to the body
///           │
///     link o├──────o══════  ►             chain stopper: the link pulls inboard, never pushes
///      (body)
/// ```
/// Above `rated_load` either opens. It has to be opened and closed to take again. Closed where
/// nothing is within reach, it stays closed on nothing, until it is opened and closed again. So
/// does one that closes on a node which another stopper holds: a node has one stopper. Two that are
/// to be closed at the start within 0.1 m of wire from each other are refused.
///
/// A stopper is a System (system.h). Signals, as "name.signal": input `close`, 1 or 0; outputs
/// `state` (StopperState as a number), `held`, the number of the wire that it holds, 1 the first of
/// World::wires(), 0: none; `load` [N]; `at` [m], the material coordinate of what it has taken,
/// from the wire's first end. The joint is the interaction NAME/hold. Events: `join` where it has
/// taken, with the distance from `point` [m]; `detach` where it lets go, `overload` where it opens
/// above its rated load, each with its load [N], one step before the joint goes; `missed` of its
/// body where it has taken nothing, with the distance of the nearest wire [m], which is within
/// `reach` where another stopper has it.
///
/// Limits: elements at drums, guides and posts are not taken, nor is chain by its shape: a stopper
/// for chain takes wire as well. A node that was put there goes when it may, once it is let go
/// (World::remove_node()). docs/wires.md, "Deck gear".

#include <hawser/id.h>
#include <hawser/math.h>

#include <cstdint>
#include <string>

namespace hawser {

class World;

/// What a stopper does.
enum class StopperState : std::uint8_t {
    open,     ///< Nothing is held.
    closing,  ///< It has found a wire, and holds it from the next step on.
    holding,  ///< It holds one.
    opening,  ///< It lets go in the next step.
    empty,    ///< Closed, with nothing in it: open and close it again.
    tripped,  ///< It has opened above its rated load: open and close it again.
};

struct StopperDef {
    std::string name{};             ///< Unique among systems.
    BodyId body{};                  ///< On which it stands. Required; no lump or scalar body.
    Vec3 point{0.0, 0.0, 0.0};      ///< Where wires are to lie, in the frame of the body [m].
    Vec3 outboard{-1.0, 0.0, 0.0};  ///< The way in which wire pays out, in that frame.
    double reach = 0.5;             ///< How far from there it takes wires [m].
    double rated_load = 0.0;        ///< Above which it opens [N]. Required.
    double pitch = 0.0;             ///< Of a chain stopper: two links of chain [m]; 0: a jaw.
    bool closed = false;            ///< At the start.
};

/// What World::add() of it calls. @throws DefError on what is missing or out of range, or a name
/// that is taken.
void define(World& world, const StopperDef& def);

}  // namespace hawser
