// SPDX-License-Identifier: Apache-2.0
/// Lines over posts and sheaves.
#include "scene/format.h"

#include <utility>
#include <vector>

namespace hawser::scene {
namespace {

using namespace make;

ShapePtr end_shape() {
    return object("route_end", "an end of a route", "Where a line over posts and sheaves ends.",
                  {{"body", body_ref(), true, "", "", "Body that it is made fast to, or led from."},
                   {"point", vector3("a point"), false, "[0, 0, 0]", "m", "Point in its frame."},
                   {"drum", text("a body name"), false, "it is made fast", "",
                    "Scalar body behind the point that pays the line out."},
                   {"radius", number("a length", -1e3, 1e3), false, "0", "m",
                    "Line per unit of the drum's coordinate."}});
}

ShapePtr place_shape() {
    return object(
        "route_place", "a turning point of a route", "Turning point of a line.",
        {{"body", body_ref(), true, "", "", "Body that it belongs to."},
         {"point", vector3("a point"), false, "[0, 0, 0]", "m",
          "Eye, or centre of the wheel, in the frame of the body."},
         {"axis", vector3("an axis"), false, "[0, 1, 0]", "1", "Axis of the wheel, in that frame."},
         {"radius", number("a radius", -1e3, 1e3), false, "0, an eye", "m",
          "The line turns about the axis where it is above 0, else against it."},
         {"friction", number("a coefficient", 0.0, 10.0), false, "0", "1",
          "Friction coefficient of the line at the turning point."},
         {"efficiency", number("an efficiency", 0.0, 1.0), false, "1", "1",
          "Efficiency of a sheave: lesser tension over greater; above 0."},
         {"inertia", number("an inertia", 0.0, 1e12), false, "0", "kg m^2",
          "Moment of inertia of a sheave."},
         {"turns", integer("a number of turns", 0, 100), false, "0", "1",
          "Whole turns more round the wheel."},
         {"angle", number("an angle", 0.0, 1e3), false, "as it lies", "rad",
          "Angle by which the line turns, including whole turns; it determines the friction."}});
}

}  // namespace

ShapePtr guide_shape() {
    return object(
        "guide", "a guide",
        "Turning point of a cable: a stern roller, a bollard, a fairlead. It divides the element "
        "that passes it. The coordinate of the scalar body NAME/slide is the length that has run "
        "through.",
        {{"name", name("a name"), true, "", "", "Unique among guides; of its signals, name.angle."},
         {"cable", text("a cable name"), true, "", "", "Cable that runs over it."},
         {"on", body_ref(), true, "", "", "Body that it belongs to."},
         {"point", vector3("a point"), false, "[0, 0, 0]", "m",
          "Eye, or centre of the wheel, in the frame of the body."},
         {"axis", vector3("an axis"), false, "[0, 1, 0]", "1", "Axis of the wheel, in that frame."},
         {"radius", number("a radius", -1e3, 1e3), false, "0, an eye", "m",
          "To the middle of the cable, which turns about the axis where it is above 0, seen from "
          "its first end, else against it."},
         {"friction", number("a coefficient", 0.0, 10.0), false, "0", "1",
          "Friction coefficient of the cable on it."},
         {"efficiency", number("an efficiency", 0.0, 1.0), false, "1", "1",
          "Efficiency of a roller: lesser tension over greater; above 0."},
         {"inertia", number("an inertia", 0.0, 1e12), false, "0", "kg m^2",
          "Moment of inertia of a roller that turns with the cable."},
         {"turns", integer("a number of turns", 0, 100), false, "0", "1",
          "Whole turns more round it."},
         {"element", number("a length", 0.0, kMostLength), false, "that of the cable", "m",
          "Of elements that come behind it; 0: no node runs through."},
         {"closed", boolean("true or false"), false, "true", "",
          "False: without an upper roller; the cable leaves it where it would pull, and comes back "
          "(events lift_off, lay_on). Needs a radius."},
         {"description", text("a text"), false, "", "", "Remarks."}});
}

ShapePtr route_shape() {
    return object(
        "route", "a route",
        "A line without mass over bollards, eyes and sheaves: a hoist, a tackle. Its parts are the "
        "interactions NAME/part1, NAME/part2, …. NAME/friction1 is the friction at the first "
        "turning point, and the scalar body NAME/slide1 the length that has run through it.",
        {{"name", name("a name"), true, "", "",
          "First part of the names of all that it is made of."},
         {"EA", positive("a stiffness", kMaxForce), true, "", "N", "Axial stiffness."},
         {"first", end_shape(), true, "", "", "End at which it begins."},
         {"places", list("a list of turning points", place_shape(), 1, 256), true, "", "",
          "Turning points, in order."},
         {"last", end_shape(), true, "", "", "End at which it ends."},
         {"length", positive("a length", kMostLength), false, "as it lies with \"tension\"", "m",
          "Without tension."},
         {"tension", number("a force", 0.0, kMaxForce), false, "0", "N", "Tension at the start."},
         {"breaking_load", positive("a force", kMaxForce), false, "never", "N",
          "A part between two bodies breaks above this tension."},
         {"damping_time", number("a time", 0.0, 1e12), false, "two steps", "s",
          "Damping time of all parts."},
         {"description", text("a text"), false, "", "", "Remarks."}},
        {{"length", "tension"}});
}

}  // namespace hawser::scene
