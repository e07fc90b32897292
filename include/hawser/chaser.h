// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file chaser.h
/// Chaser: a ring round a mooring chain or wire, with which a vessel recovers an anchor. A work
/// wire hauls the ring along the chain to the anchor and back.
///
/// ```cpp
/// world.add(hawser::ChaserDef{.name = "chaser", .body = ring, .reach = 1.0, .friction = 0.3});
/// world.set_system_signal("chaser.close", 1);  // engage the chain within reach
/// // … haul the ring by its wire, down the chain: "chaser.arrived" is 2 at the anchor …
/// world.set_system_signal("chaser.close", 0);  // release the chain
/// ```
/// ```
///                   work wire
///                  ╱
///     chain ═════( )═════════╗       ( ) the ring: an eye (guide.h) fixed to a rigid body, through
///                            ║           which the chain runs with Coulomb friction
///                          anchor
/// ```
/// *Engagement*. The ring engages the wire with the point nearest to its own, if the distance is at
/// most `reach`. The wire runs through the eye from then on. The eye starts at the wire's present
/// position, so that engagement causes no tension. Wires that are attached to the ring are
/// excluded. While no wire is within reach the ring waits, and the event `missed` is sent once,
/// with the distance [m].
///
/// *Run*. Nodes are removed and inserted at the eye as at a guide, so that the ring passes them.
/// The ring stops if no node can be removed: at an anchor, gear, a drum, another guide, or another
/// line type. It has arrived at an end of the wire if it stops there, or if less than `arrives` is
/// left. The event `range` of the ring reports this, with the remaining length [m].
///
/// *Release*. The two parts become one element again, with their length and tension.
///
/// A chaser is a System (system.h). Input, as "name.signal": `close`, 1 to engage, 0 to release.
/// Outputs:
/// - `state`: number of a ChaserState;
/// - `held`: number of the wire, 1 the first of WorldWires::ids(); 0: none;
/// - `at`: material coordinate of the eye from the wire's first end [m];
/// - `left`: length from the eye to the wire's last end [m];
/// - `arrived`: 1 at the first end, 2 at the last end, else 0;
/// - `before`, `behind`: tensions on the side of the first and of the last end [N];
/// - `angle`: angle by which the wire turns in the eye [rad];
/// - `speed`: speed of the wire through the ring [m/s].
///
/// The parts are those of a guide: NAME/slide, NAME/behind, NAME/friction. Events: `join` of the
/// ring on engagement, with the distance [m]; `detach` on release, with the larger tension [N].
///
/// Limits: those of guides (guide.h). The eye is a point, so that friction at the rims of a long
/// ring does not turn it. A wire that breaks at the ring stays in it.

#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/math.h>

#include <cstdint>
#include <string>

namespace hawser {

class World;

/// Operating state of a chaser.
enum class ChaserState : std::uint8_t {
    open,     ///< Released: no wire runs through the ring.
    waiting,  ///< Engagement is requested, but no wire is within reach.
    on,       ///< A wire runs through the ring.
};

/// Definition of a chaser. World::add() copies it.
struct ChaserDef {
    std::string name{};         ///< Unique name among systems. Required.
    BodyId body{};              ///< Rigid body of the ring. Required.
    Vec3 point{0.0, 0.0, 0.0};  ///< Centre of the eye, in the ring's frame [m].
    double reach = 1.0;         ///< Largest distance of an engaged wire from `point` [m].
    double friction = 0.3;      ///< Friction coefficient μ of the wire in the eye [1].
    double arrives = 2.0;       ///< Distance from an end of the wire at which it has arrived [m].
    double element = kDefault;  ///< Length of elements at the eye [m]; default: that of the engaged
                                ///< element.
    bool closed = false;        ///< True: engages a wire at the start (`close` is 1).
};

/// Add a chaser; World::add() calls it.
/// @throws DefError if a required field is missing or a value is out of range, or if the name is
/// already used.
void define(World& world, const ChaserDef& def);

}  // namespace hawser
