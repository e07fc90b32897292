// SPDX-License-Identifier: Apache-2.0
/// Data of a ship for DNV-ST-0111 (hawser/dp_capability.h).
#include <hawser/dp_capability.h>

#include "scene/format.h"

#include <string>
#include <vector>

namespace hawser::scene {
namespace {

using namespace make;

template <class Enum>
std::vector<std::string> dp_words(int count) {
    std::vector<std::string> out;
    for (int i = 0; i < count; ++i) out.emplace_back(to_string(static_cast<Enum>(i)));
    return out;
}

ShapePtr dp_number(double least, double most) { return number("a number", least, most); }

ShapePtr dp_name_list() { return list("a list of thrusters", name("a thruster"), 1, 100); }

ShapePtr dp_thruster_shape() {
    const ShapePtr rudder =
        object("dp_rudder", "a rudder of DNV-ST-0111", "Behind a shaft line, up to 30 degrees.",
               {{"area", positive("an area", 1e4), true, "", "m^2", "Movable area."},
                {"profile", word("a profile", dp_words<DpRudderProfile>(kDpRudderProfiles)), false,
                 "naca", "", "Its section."}});
    return object(
        "dp_thruster", "a thruster of DNV-ST-0111", "Thrust by power and diameter.",
        {{"name", name("a name"), true, "", "", "Unique in the ship."},
         {"kind", word("a kind", dp_words<DpThrusterKind>(kDpThrusterKinds)), false, "azimuth", "",
          "Its kind."},
         {"propeller", word("a propeller", dp_words<DpPropeller>(kDpPropellers)), false, "open", "",
          "Its propeller."},
         {"inlet", word("an inlet", dp_words<DpInlet>(kDpInlets)), false, "other", "",
          "Shape of a tunnel's inlet."},
         {"drive", word("a drive", dp_words<DpDrive>(kDpDrives)), false, "standard", "",
          "Mechanical efficiency: permanent_magnet of cycloidal thrusters, rim of others."},
         {"controllable", boolean("true or false"), false, "false", "",
          "Controllable pitch: less thrust astern of shafts."},
         {"point", vector3("a point"), true, "", "m",
          "Centre of the propeller: x ahead of half L_pp, y to port, z above the keel."},
         {"diameter", positive("a diameter", 100.0), true, "", "m", "Diameter of the propeller."},
         {"power", positive("a power", 1e9), true, "", "W", "Brake power."},
         {"rudder", rudder, false, "none", "", "Rudder behind the propeller of a shaft line."},
         {"forbidden_deg",
          list("a list of sectors", list("two angles", dp_number(-720.0, 720.0), 2, 2), 1, 20),
          false, "none", "deg",
          "Thrust directions from ahead, positive to port, besides zones of "
          "the standard."}});
}

}  // namespace

ShapePtr dp_ship_shape() {
    const ShapePtr board = object(
        "dp_switchboard", "a switchboard of DNV-ST-0111", "90 % of its power is for thrusters.",
        {{"name", name("a name"), false, "", "", "Its name."},
         {"power", positive("a power", 1e10), true, "", "W", "Generated."},
         {"thrusters", dp_name_list(), true, "", "", "Thrusters that it feeds."}});
    const ShapePtr failure =
        object("dp_failure", "a single failure of DNV-ST-0111", "Thrusters that it stops.",
               {{"name", name("a name"), true, "", "", "Its name."},
                {"thrusters", dp_name_list(), true, "", "", "Thrusters that stop."}});
    return object(
        "dp_ship", "a ship of DNV-ST-0111",
        "Level 1 capability, for `hawser inspect --dp-capability`. Origin: half L_pp, centre line, "
        "keel; x ahead, y to port, z up.",
        {{"length", positive("a length", 1e3), true, "", "m", "L_pp."},
         {"beam", positive("a length", 1e3), true, "", "m", "Beam at the waterline."},
         {"draught", positive("a length", 1e2), true, "", "m", "Draught."},
         {"surface_length", dp_number(0.0, 1e3), false, "length", "m",
          "L_os of the underwater body."},
         {"surface_x", dp_number(-1e3, 1e3), false, "0", "m",
          "Position of the centre of the underwater body along x."},
         {"bow_angle_deg", dp_number(0.0, 90.0), true, "", "deg",
          "Between waterline at the bow and centre line."},
         {"aft_waterplane", positive("an area", 1e6), true, "", "m^2",
          "Waterplane area aft of half L_pp."},
         {"frontal_area", positive("an area", 1e6), true, "", "m^2", "A_F above the water."},
         {"lateral_area", positive("an area", 1e6), true, "", "m^2", "A_L above the water."},
         {"lateral_x", dp_number(-1e3, 1e3), false, "0", "m", "Centre of lateral_area."},
         {"submerged_area", positive("an area", 1e6), true, "", "m^2", "A_L below the water."},
         {"submerged_x", dp_number(-1e3, 1e3), false, "0", "m", "Centre of submerged_area."},
         {"skegs", list("a list of points", list("x and y", dp_number(-1e3, 1e3), 2, 2), 1, 20),
          false, "none", "m", "Aft ends of skegs."},
         {"thrusters", list("a list of thrusters", dp_thruster_shape(), 1, 40), true, "", "",
          "Thrusters."},
         {"switchboards", list("a list of switchboards", board, 1, 40), false, "none: no limit", "",
          "Limits of power."},
         {"failures", list("a list of failures", failure, 1, 100), false, "each thruster alone", "",
          "Single failures."}});
}

ShapePtr dp_file_shape() {
    return object("", "data of a ship for DNV-ST-0111", "",
                  {{"$schema", text("a text"), false, "", "", "Ignored."},
                   {"name", name("a name"), false, "", "", "Of the ship."},
                   {"description", text("a text"), false, "", "", "Source and remarks."},
                   {"dp_capability", dp_ship_shape(), true, "", "", "Data."}});
}

}  // namespace hawser::scene
