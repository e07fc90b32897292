// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file drum_feed.h
/// Drum feeds: wire with nodes that a bare drum pays out and hauls in. A bare drum is a scalar body
/// that the user drives; a complete winch is in winch.h.
///
/// ```
///     drum (scalar body, coordinate θ)
///        o ───── fairlead ── element at the drum ── node ── element ── node ── wire …
///                            rest length l₀ + r (θ − θ₀)
/// ```
/// A WinchStretch makes the rest length of the element at the drum follow the drum: r is its
/// radius, l₀ and θ₀ are the values at the start. A drum feed adds nodes, loads and an end stop.
///
/// *Nodes*. When the element at the drum has 1.5 times the length `element`, a node is inserted.
/// When 0.25 times the length is left, the nearest node is removed. Wire that is paid out therefore
/// has mass, contacts and shape.
///
/// *Loads*. Half of the mass, weight and drag of the element at the drum acts on its node, half on
/// the fairlead. The drum carries the weight along the wire.
///
/// *End stop*. When no node is left to remove, the element keeps a least length:
/// - with elements fed: min(max(g (10 h)², 10 h v), ¼ `element`), at least 2 % of its length, with
///   the transverse speed v of the load. At 1/60 s this is at least 0.27 m. A load that swings on a
///   shorter element turns further than a step follows.
/// - with one element (`element` = 0): 2 % of its length (kLeastOfDrumElement).
/// Hauling stops there: the drum is braked, and the event `hauled_in` is reported once. Paying out
/// is free.
///
/// Limits: one radius, no layers, unlimited store; a winch (winch.h) has layers, capacity, motor
/// and brake. The brake of the end stop is a damper of 1000 J/h, with the drum's inertia J and the
/// step h. A motor of torque Q therefore turns the drum at Q h/(1000 J) [rad/s] while the wire
/// stands.
///
/// ```cpp
/// world.add(hawser::DrumFeedDef{.name = "hoist_feed", .wire = wire, .element = 2.0,
///                               .mass_per_length = 3.2});
/// ```

#include <hawser/id.h>
#include <hawser/interactions.h>

#include <string>

namespace hawser {

class World;

/// Definition of the feed of a wire whose end lies on a bare drum (WorldWires::spool()).
/// World::add() copies it.
struct DrumFeedDef {
    std::string name{};            ///< Unique name among systems. Required.
    WireId wire{};                 ///< Wire whose end lies on the drum. Required.
    int end = 0;                   ///< End on the drum: 0 the first, 1 the last.
    double element = kDefault;     ///< Length of the elements paid out [m]; default: that of the
                                   ///< element at the drum. 0: no nodes, only the end stop.
    double mass_per_length = 0.0;  ///< Mass of the wire per length [kg/m]. Required unless
                                   ///< `element` is 0.
};

/// Add a drum feed; World::add() calls it.
/// @throws DefError if the wire's end does not lie on a drum, or if the name is already used
/// @throws DefError if nodes are required but the wire's elements have no mass
/// (WireDef::consistent_mass)
void define(World& world, const DrumFeedDef& def);

}  // namespace hawser
