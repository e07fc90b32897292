// SPDX-License-Identifier: Apache-2.0
/// Deck gear: shark jaws, chain stoppers, guide pins, hooks, chasers.
#include "scene/format.h"

#include <utility>
#include <vector>

namespace hawser::scene {

using namespace make;

ShapePtr stopper_shape() {
    return object(
        "stopper", "a stopper",
        "A shark jaw or chain stopper. It engages a cable within its reach, holds it and releases "
        "it: the signal NAME.close, 1 or 0. The holding joint is the interaction NAME/hold.",
        {{"name", name("a name"), true, "", "",
          "Unique among stoppers; of its signals, name.load."},
         {"on", body_ref(), true, "", "", "Body on which it is mounted."},
         {"point", vector3("a point"), true, "", "m",
          "Where cables are to lie, in the frame of the body."},
         {"outboard", vector3("a direction"), false, "[-1, 0, 0]", "1",
          "The way in which cable pays out, in that frame."},
         {"reach", positive("a length", 1e3), false, "0.5", "m",
          "Distance from the point within which it engages cables."},
         {"rated_load", positive("a force", 1e12), true, "", "N", "Above it the stopper opens."},
         {"pitch", number("a length", 0.0, 10.0), false, "0, a jaw", "m",
          "Pitch of a chain stopper, which prevents paying out only: length of chain hauled in "
          "until its pawl engages again, at least 0.05 m."},
         {"closed", boolean("true or false"), false, "false", "", "Whether it is at the start."},
         {"description", text("a text"), false, "", "", "Remarks."}});
}

ShapePtr pin_shape() {
    std::vector<Field> fields{
        {"name", name("a name"), true, "", "", "Unique among pins; of its signals, name.up."},
        {"on", body_ref(), true, "", "", "Body that it is on."},
        {"from", vector3("a point"), true, "", "m",
         "Foot of its axis when it is up, in the frame of the body."},
        {"to", vector3("a point"), true, "", "m", "Its top, in that frame."},
        {"radius", positive("a radius", 100.0), true, "", "m", "Of the pin."},
        {"friction", number("a coefficient", 0.0, 10.0), false, "0", "1",
         "Of cables that lie on it."},
        {"efficiency", number("an efficiency", 0.0, 1.0), false, "1", "1",
         "Of a pin with a roller: lesser tension over greater; above 0."},
        {"speed", positive("a speed", 100.0), false, "0.1", "m/s", "At which it goes up and down."},
        {"force", positive("a force", 1e12), false, "2e5", "N",
         "Largest force of its drive; must exceed its weight."},
        {"density", positive("a density", 1e6), false, "7850", "kg/m^3", "It is solid."},
        {"margin", number("a length", 0.0, 1e3), false, "1", "m",
         "How near to it cables are watched."},
        {"up", boolean("true or false"), false, "true", "", "Whether it is at the start."},
        {"description", text("a text"), false, "", "", "Remarks."}};
    const auto surface = surface_fields();
    fields.insert(fields.end(), surface.begin(), surface.end());
    return object("pin", "a pin",
                  "A guide pin that goes up and down through a deck, by the signal NAME.up, 1 up "
                  "to 0 down. It is a body on a slide with the post NAME/post.",
                  std::move(fields));
}

ShapePtr hook_shape() {
    return object(
        "hook", "a hook",
        "A hook at the end of a cable or on a body. It attaches loads by slings and releases them: "
        "the signal NAME.take is the number of a load, or its name in a timeline; 0: none. Its "
        "legs are the interactions NAME/leg1, NAME/leg2, ….",
        {{"name", name("a name"), true, "", "", "Unique among hooks; of its signals, name.load."},
         {"on", body_ref(), true, "", "",
          "Body that acts as the hook, or the last node of a cable (CABLE/number)."},
         {"point", vector3("a point"), false, "[0, 0, 0]", "m",
          "Point at which slings are attached, in the frame of the body."},
         {"loads", list("a list of loads", crane_load_shape(), 1, 1000), true, "", "",
          "Loads that it can attach."},
         {"take", body_ref(), false, "none", "", "Body of the load that hangs from the start."},
         {"strength", positive("a force", 1e30), false, "none", "N",
          "Above it the hook opens by itself."},
         {"latch", positive("a force", 1e30), false, "none", "N",
          "Load above which the hook does not open when it is ordered to."},
         {"description", text("a text"), false, "", "", "Remarks."}});
}

ShapePtr chaser_shape() {
    return object(
        "chaser", "a chaser",
        "A ring that is put round the cable within its reach, runs along it with friction, and is "
        "taken off again: the signal NAME.close, 1 or 0. Cables that are made fast to the ring are "
        "left out; others need \"consistent_mass\".",
        {{"name", name("a name"), true, "", "",
          "Unique among chasers; of its signals, name.arrived."},
         {"on", body_ref(), true, "", "", "The rigid body that is the ring."},
         {"point", vector3("a point"), false, "[0, 0, 0]", "m",
          "Of its middle, in the frame of the body."},
         {"reach", positive("a length", 1e3), false, "1", "m",
          "Distance from that point within which it engages cables."},
         {"friction", number("a coefficient", 0.0, 10.0), false, "0.3", "1", "Of the cable in it."},
         {"arrives", number("a length", 0.0, 1e6), false, "2", "m",
          "Nearer than this to an end of the cable it has arrived."},
         {"element", positive("a length", 1e6), false, "that of the cable", "m",
          "Of elements that come and go there."},
         {"closed", boolean("true or false"), false, "false", "",
          "Whether it is to be round a cable from the start."},
         {"description", text("a text"), false, "", "", "Remarks."}});
}

}  // namespace hawser::scene
