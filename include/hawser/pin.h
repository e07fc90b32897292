// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file pin.h
/// Guide pins: bollards (post.h) that move up and down through a deck during the run.
///
/// ```cpp
/// world.add(hawser::PinDef{.name = "pin", .body = ship, .from = {-38, 1.2, 0.2},
///                          .to = {-38, 1.2, 2.2}, .radius = 0.15, .friction = 0.15});
/// world.set_system_signal("pin.up", 0.0);  // moves down at its speed
/// ```
/// The pin is a body on a prismatic joint with a motor of limited force. It has a cylinder for
/// contacts, and a bollard that engages and disengages wires. In the upper position its axis runs
/// from `from` to `to`. In the lower position it is displaced by its length, with its top at
/// `from`.
///
/// *Lower position*. Nothing on the deck touches the pin. While the pin moves down, a wire on it
/// keeps its position relative to the carrying body, which carries its weight. The wire is released
/// when the pin's top is below it.
///
/// *Upper position*. Wires at either side engage. A wire across the top is lifted, up to the
/// motor's force, and does not engage. If the wire is too heavy, the pin stops below it (event
/// `saturation` of NAME/slide/motor), and continues when the wire is gone.
///
/// Parts: body NAME, interactions NAME/slide and NAME/slide/motor, motor input NAME/speed, shape
/// and bollard NAME/post. Input "NAME.up": set position, from 0 (down) to 1 (up). Output
/// "NAME.height": present position, 0 to 1. The outputs of the bollard are "NAME/post.held" and so
/// on. Details: docs/deck_gear.md.

#include <hawser/id.h>
#include <hawser/math.h>
#include <hawser/shapes.h>

#include <cstdint>
#include <string>

namespace hawser {

class World;

/// Definition of a guide pin. World::add() copies it.
struct PinDef {
    std::string name{};  ///< Unique name among systems and bodies.
    BodyId body{};       ///< Body that carries the pin; not a lumped mass or scalar body. Required.
    Vec3 from{0.0, 0.0, 0.0};  ///< Foot of the axis in the upper position, in the frame of the body
                               ///< [m].
    Vec3 to{0.0, 0.0, 0.0};    ///< Top of the axis in the upper position, in the frame of the body
                               ///< [m]. Required.
    double radius = 0.0;       ///< Radius [m]. Required.
    double friction = 0.0;     ///< Friction coefficient μ of the wires [1].
    double efficiency = 1.0;   ///< Efficiency η of a pin with roller [1], as PostDef::efficiency.
    int wires = 2;             ///< Largest number of engaged wires, as PostDef::wires.
    double speed = 0.1;        ///< Speed up and down [m/s].
    double force = 2e5;        ///< Largest force of the motor [N].
    double density = 7850.0;   ///< Density of the solid pin [kg/m³].
    double margin = 1.0;       ///< Distance of contact detection [m], as ShapeDef::margin.
    MaterialId material{};     ///< Material of the surface.
    std::uint32_t group = 1, touches = ~0U;  ///< Collision groups and their mask, as in ShapeDef.
    bool up = true;                          ///< True: in the upper position at the start.
};

/// Add a pin; World::add() calls it.
/// @return the body of the pin.
/// @throws DefError if a required field is missing or a value is out of range, or if the name is
/// already used.
BodyId define(World& world, const PinDef& def);

}  // namespace hawser
