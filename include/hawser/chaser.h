// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file chaser.h
/// A chaser: a ring round a mooring chain or wire, hauled along it to the anchor by a work wire and
/// brought back.
///
/// ```cpp
/// world.add(hawser::ChaserDef{.name = "chaser", .body = ring, .reach = 1.0, .friction = 0.3});
/// world.set_system_signal("chaser.close", 1);  // round the chain that lies within its reach
/// // … haul the ring by its wire, down the chain: "chaser.arrived" is 2 at the anchor …
/// world.set_system_signal("chaser.close", 0);  // off the chain again
/// ```
/// ```
///                   work wire
///                  ╱
///     chain ═════( )═════════╗       ( ) the ring: an eye (guide.h) fixed to a rigid body, through
///                            ║           which the chain runs with Coulomb friction
///                          anchor
/// ```
/// *Take.* The wire of which a point lies nearest to the ring's point, within `reach`, runs through
/// an eye from then on, where it passes: taking pulls at nothing. Wires that are made fast to the
/// ring are left out. Until one is within reach the ring stays beside it: event `missed` once, with
/// the distance.
///
/// *Run.* Elements come and go at the eye as at a guide, so that the ring passes lumps. It stops
/// where no node can go: next to an anchor, gear, a drum, another guide, another line type. It has
/// arrived at an end of the wire where it stops, or where less than `arrives` is left to it: event
/// `range` of the ring, with the material that is left [m].
///
/// *Let go.* The two parts become one element again, of the material and at the tension that they
/// had.
///
/// A chaser is a System (system.h). Signals, as "name.signal": input `close`, 1 or 0; outputs
/// `state` (ChaserState as a number); `held`, the number of the wire, 1 the first of
/// World::wires(), 0: none; `at` [m], the material coordinate of the eye from the wire's first end,
/// `left` [m], what is left to its last end; `arrived`, 1 at the first end and 2 at the last one,
/// 0: neither; `before`, `behind` [N], the tensions on both sides; `angle` [rad] by which the wire
/// turns in it; `speed` [m/s] of the wire through the ring. Parts are those of a guide: NAME/slide,
/// NAME/behind, NAME/friction. Events: `join` of the ring where it has taken, with the distance;
/// `detach` where it lets go, with the larger tension.
///
/// Limits: those of guides (guide.h). The eye is a point: a chain that rubs on both rims of a long
/// ring does not turn it. A wire that parts at the ring stays in it.

#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/math.h>

#include <cstdint>
#include <string>

namespace hawser {

class World;

/// What a chaser does.
enum class ChaserState : std::uint8_t {
    open,     ///< Round nothing, and it is to be.
    waiting,  ///< It is to be round a wire, and none is within reach.
    on,       ///< A wire runs through it.
};

struct ChaserDef {
    std::string name{};         ///< Unique among systems. Required.
    BodyId body{};              ///< The ring. Required; a rigid body.
    Vec3 point{0.0, 0.0, 0.0};  ///< Of its middle, in its frame [m].
    double reach = 1.0;         ///< How far from there it takes wires [m].
    double friction = 0.3;      ///< μ of the wire in it.
    double arrives = 2.0;       ///< Nearer than this to an end of the wire it has arrived [m].
    double element = kDefault;  ///< Of what comes and goes there [m]; kDefault: as it takes it.
    bool closed = false;        ///< Whether it is to be round a wire from the start.
};

/// What World::add() of it calls. @throws DefError on what is missing or out of range, or a name
/// that is taken.
void define(World& world, const ChaserDef& def);

}  // namespace hawser
