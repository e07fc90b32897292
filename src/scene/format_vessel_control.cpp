// SPDX-License-Identifier: Apache-2.0
/// Control of vessels (hawser/vessel_control.h).
#include "scene/field_shapes.h"
#include "scene/format.h"
#include "scene/vessel_control.h"

#include <string>
#include <utility>
#include <vector>

namespace hawser::scene {
namespace {

using namespace make;

ShapePtr control_number(double least, double most) { return number("a number", least, most); }

}  // namespace

ShapePtr vessel_control_shape() {
    std::vector<std::string> modes;
    for (int i = 0; i < kControlModes; ++i)
        modes.emplace_back(to_string(static_cast<ControlMode>(i)));
    const ShapePtr zone =
        object("control_zone", "a forbidden zone", "Thrust directions that an azimuth avoids.",
               {{"propulsor", name("a propulsor"), true, "", "", "An azimuth."},
                {"from_deg", control_number(-720.0, 720.0), true, "", "deg",
                 "First angle of the sector, from ahead, clockwise seen from above."},
                {"to_deg", control_number(-720.0, 720.0), true, "", "deg",
                 "Last angle of the sector; above from_deg."}});
    const ShapePtr failure =
        object("control_failure", "a failure of propulsors", "Propulsors that it stops.",
               {{"name", name("a name"), true, "", "", "Its name."},
                {"propulsors", list("a list of propulsors", name("a propulsor"), 1, 100), true, "",
                 "", "Propulsors that stop."}});
    std::vector<Field> fields{
        {"mode", word("a mode", modes), false, "off", "", "Mode at the start."},
        {"bandwidth", vector3("three frequencies"), false, "[0.1, 0.1, 0.1]", "rad/s",
         "Bandwidths of surge, sway and yaw in closed loop; above 0."},
        {"observer", boolean("true or false"), false, "true", "",
         "Wave filter and estimate of velocities."},
        {"wind", boolean("true or false"), false, "true", "", "Wind feed-forward."},
        {"lines", list("a list of lines", name("a line"), 1, 100), false, "none", "",
         "Interactions, or cables that end at the vessel: tension feed-forward."},
        {"target", body_ref(), false, "none", "", "Body that the mode follow keeps to."},
        {"zones", list("a list of zones", zone, 1, 100), false, "none", "",
         "Forbidden zones of azimuths."},
        {"failures", list("a list of failures", failure, 1, 100), false, "each propulsor alone", "",
         "Failures that the consequence analysis assumes."}};
    add_fields(fields, ControlTable::kNumbers);
    return object("vessel_control", "the control of a vessel",
                  "Joystick, autopilot and dynamic positioning: signal VESSEL.mode.",
                  std::move(fields));
}

}  // namespace hawser::scene
