// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file pin.h
/// Guide pins: posts (post.h) that go up and down through a deck while wires run.
///
/// ```cpp
/// world.add(hawser::PinDef{.name = "pin", .body = ship, .from = {-38, 1.2, 0.2},
///                          .to = {-38, 1.2, 2.2}, .radius = 0.15, .friction = 0.15});
/// world.set_system_signal("pin.up", 0.0);  // goes down, at its speed
/// ```
/// The pin is a body on a slide, driven by a motor of limited force, with a cylinder that wires
/// touch and a post that takes and lets go of them. `from` and `to` are the ends of its axis when
/// it is up; down it has gone by its length, so that its top is at `from`.
///
/// *Down* it touches nothing above the deck. A wire that lies on a pin that goes down keeps its
/// place, borne by the body that the pin is on, until the pin's top is below it: then it is let go.
/// *Up*, it takes what comes to lie on either side of it. A wire that lies across its top is lifted
/// by it as far as its force goes, not taken: where the wire is too heavy the pin stops under it
/// (event `saturation` of NAME/slide/motor), and goes on once the wire is off it.
///
/// Parts: body NAME, interactions NAME/slide and NAME/slide/motor, the input NAME/speed of
/// the motor, shape and post NAME/post. Signals: input
/// "NAME.up", where it is to go, 1 up to 0 down; output "NAME.height", where it is, 1 up to 0 down;
/// those of the post as "NAME/post.held". docs/wires.md, "Deck gear".

#include <hawser/id.h>
#include <hawser/math.h>
#include <hawser/shapes.h>

#include <cstdint>
#include <string>

namespace hawser {

class World;

struct PinDef {
    std::string name{};        ///< Unique among systems and bodies.
    BodyId body{};             ///< On which it is. Required; no lump or scalar body.
    Vec3 from{0.0, 0.0, 0.0};  ///< Foot of its axis when it is up, in the frame of the body [m].
    Vec3 to{0.0, 0.0, 0.0};    ///< Its top [m]. Required.
    double radius = 0.0;       ///< [m]. Required.
    double friction = 0.0;     ///< μ of wires that lie on it.
    double efficiency = 1.0;   ///< η of a pin with a roller, as PostDef has it.
    int wires = 2;             ///< As PostDef has it.
    double speed = 0.1;        ///< At which it goes up and down [m/s].
    double force = 2e5;        ///< Largest of its motor [N].
    double density = 7850.0;   ///< Of the pin, which is solid [kg/m³].
    double margin = 1.0;       ///< As ShapeDef has it [m].
    MaterialId material{};     ///< Of its surface.
    std::uint32_t group = 1, touches = ~0U;  ///< As ShapeDef has them.
    bool up = true;                          ///< At the start.
};

/// What World::add() of it calls. @return its body. @throws DefError on what is missing or out of
/// range, or a name that is taken.
BodyId define(World& world, const PinDef& def);

}  // namespace hawser
