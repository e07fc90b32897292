// SPDX-License-Identifier: Apache-2.0
/// Vessels on bodies (hawser/vessel.h).
#include <hawser/vessel_ships.h>

#include "scene/field_shapes.h"
#include "scene/format.h"
#include "scene/vessels.h"

#include <string>
#include <utility>
#include <vector>

namespace hawser::scene {
namespace {

using namespace make;

template <class T>
std::vector<Field> vessel_fields() {
    std::vector<Field> fields;
    add_fields(fields, VesselTable<T>::kNumbers);
    return fields;
}

template <class T>
ShapePtr vessel_part(const char* id, const char* what, const char* doc,
                     std::vector<Field> more = {}) {
    std::vector<Field> fields = vessel_fields<T>();
    for (Field& field : more) fields.push_back(std::move(field));
    return object(id, what, doc, std::move(fields));
}

ShapePtr matrix_shape(double least) {
    const ShapePtr one = number("a number", least, 1e18);
    const ShapePtr any = number("a number", -1e18, 1e18);
    return choice(
        "six numbers, or six rows of them",
        {list("six numbers", one, 6, 6), list("six rows", list("six numbers", any, 6, 6), 6, 6)});
}

ShapePtr polynomial_shape() {
    const ShapePtr terms = map("terms by their letters", number("a number", -1e12, 1e12));
    return vessel_part<HullPolynomial>(
        "hull_polynomial", "polynomials of a hull",
        "Terms by letters: \"vvr\" is v^2 r; u v r p velocities, f heel, d rudder, n revolutions, "
        "b "
        "drift angle, V R D N B magnitudes, 0 a constant.",
        {{"scale", word("a scale", {"speed", "mass"}), false, "speed", "",
          "speed: 1/2 density area U^2 (moments times length), variables over U; mass: the mass "
          "(moments times length^2), variables in SI."},
         {"factor", number("a number", -1e12, 1e12), false, "1", "1",
          "Factor that multiplies all terms: 1e-5 for tables in units of 1e-5."},
         {"rudder_to_port", boolean("true or false"), false, "false", "",
          "The source counts rudder angles to port as positive."},
         {"own_coriolis", boolean("true or false"), false, "false", "",
          "The terms hold the Coriolis forces of the body's own mass, too."},
         {"x", terms, false, "none", "", "Terms of the force ahead."},
         {"y", terms, false, "none", "", "Terms of the force to starboard."},
         {"k", terms, false, "none", "", "Terms of the heeling moment, starboard down."},
         {"n", terms, false, "none", "", "Terms of the yawing moment, to starboard."}});
}

ShapePtr resistance_shape() {
    return vessel_part<HullResistance>(
        "hull_resistance", "a resistance", "A curve, or linear and quadratic coefficients.",
        {{"curve",
          list("a list of points",
               list("a speed and a force", number("a number", 0.0, kMaxVesselForce), 2, 2), 2,
               1000),
          false, "none", "m/s, N", "Speeds ascend from 0; linear between."}});
}

ShapePtr wind_shape() {
    std::vector<std::string> ships;
    for (int i = 1; i < kWindShipCount; ++i)
        ships.emplace_back(to_string(static_cast<WindShip>(i)));
    return vessel_part<WindLoad>(
        "vessel_wind", "wind on a ship", "Blendermann's coefficients, in the wind of the sea.",
        {{"ship", word("a kind of ship", ships), true, "", "", "Whose coefficients."}});
}

ShapePtr current_shape() {
    const ShapePtr point =
        list("an angle [deg] and three coefficients", number("a number", -1e3, 1e3), 4, 4);
    return vessel_part<CurrentLoad>(
        "current_load", "a current load",
        "Loads by the direction of the inflow: X = 1/2 density V^2 CX L T, "
        "Y = 1/2 density V^2 CY L T, N = 1/2 density V^2 CN L^2 T.",
        {{"points", list("a list of points", point, 2, 1000), true, "", "deg, 1, 1, 1",
          "Angle, CX, CY, CN; angles ascend from 0 (ahead) to 180, from starboard."}});
}

ShapePtr power_shape() {
    const ShapePtr generator = vessel_part<GeneratorDef>(
        "generator", "a generator", "Power source of a switchboard.",
        {{"name", name("a name"), true, "", "", "Fails by the signal VESSEL.NAME_failed."}});
    const ShapePtr board =
        object("switchboard", "a switchboard", "Its consumers use its generators together.",
               {{"name", name("a name"), true, "", "", "Fails by the signal VESSEL.NAME_failed."},
                {"generators", list("a list of generators", generator, 1, 100), true, "", "",
                 "Its generators."}});
    const ShapePtr consumer = vessel_part<ConsumerDef>(
        "consumer", "a consumer", "A propulsor, a load, or the power of another system.",
        {{"name", name("a name"), true, "", "", "Name of a propulsor or of a load."},
         {"board", name("a switchboard"), true, "", "", "Switchboard that feeds it."},
         {"priority", integer("a number", 1, 1000), false, "1", "", "1 is served first."},
         {"signal", text("SYSTEM.SIGNAL"), false, "none", "W",
          "Demand of another system, which is served and not limited."}});
    return vessel_part<PowerDef>(
        "vessel_power", "a power bus", "Switchboards, generators and consumers with priorities.",
        {{"boards", list("a list of switchboards", board, 1, 100), true, "", "", "Switchboards."},
         {"consumers", list("a list of consumers", consumer, 1, 1000), true, "", "", "Consumers."},
         {"tied", boolean("true or false"), false, "false", "",
          "The tie of all switchboards is closed at the start; the signal VESSEL.tie."}});
}

ShapePtr propulsor_shape() {
    const ShapePtr propeller = vessel_part<PropellerDef>(
        "propeller", "a propeller", "By its series, in open water.",
        {{"series", word("a series", {"wageningen_b", "ka4_70", "ka5_75"}), false, "wageningen_b",
          "", "Ka-series: in nozzle 19A."}});
    return vessel_part<PropulsorDef>(
        "propulsor", "a propulsor", "A propeller or an ideal thruster.",
        {{"name", name("a name"), true, "", "",
          "Of its order: the signal VESSEL.NAME, from -1 to 1."},
         {"kind", word("a kind", {"shaft", "azimuth", "tunnel", "cycloidal"}), false, "shaft", "",
          "Its kind."},
         {"point", vector3("a point"), false, "[0, 0, 0]", "m",
          "Point relative to the centre of mass, in the body's frame."},
         {"propeller", propeller, false, "none: ideal", "", "Its propeller."},
         {"controllable", boolean("true or false"), false, "false", "",
          "Pitch by the signal VESSEL.NAME_pitch."},
         {"ventilates", boolean("true or false"), false, "false", "",
          "It loses thrust and torque near the surface of the water."}});
}

ShapePtr rudder_shape() {
    return vessel_part<RudderDef>(
        "vessel_rudder", "a rudder", "With stall, in the slipstream of a propulsor.",
        {{"name", name("a name"), false, "rudder", "",
          "Of its order: the signal VESSEL.NAME, positive turns to starboard."},
         {"point", vector3("a point"), true, "", "m",
          "Point relative to the centre of mass, in the body's frame."},
         {"behind", name("a propulsor"), false, "none", "",
          "Propulsor whose slipstream reaches it."}});
}

}  // namespace

ShapePtr vessel_shape() {
    std::vector<std::string> ships;
    for (const char* each : kPublishedShips) ships.emplace_back(each);
    return object(
        "vessel", "a vessel", "A vessel: hull forces, propulsors and rudders of a body.",
        {{"name", name("a name"), true, "", "", "Of its signals, as NAME.rudder."},
         {"body", body_ref(), true, "", "", "A rigid body; its x axis points to the bow."},
         {"ship", word("a ship", ships), false, "none", "",
          "Published coefficients; other keys replace theirs. The body has the mass of the "
          "source."},
         {"depth", positive("a depth", 1e5), false, "1000", "m",
          "Depth of the water, for esso_190k."},
         {"origin", vector3("a point"), false, "[0, 0, 0]", "m",
          "O of the coefficients from the centre of mass, in the body's frame."},
         {"draught", number("a number", 0.0, kMaxVesselLength), false, "0", "m",
          "Draught; the current is taken at half of it."},
         {"density", positive("a density", 1e5), false, "1025", "kg/m^3",
          "Density of water where the scene has no sea."},
         {"added_mass", matrix_shape(0.0), false, "0", "kg, kg m, kg m^2",
          "At O: x ahead, y to starboard, z down."},
         {"coriolis", word("a kind", {"none", "planar", "full"}), false, "full", "",
          "Of the added mass: planar without the Munk moment (MMG)."},
         {"damping", matrix_shape(0.0), false, "0", "N s/m, N s, N m s", "Linear, at O."},
         {"restoring", matrix_shape(0.0), false, "0", "N/m, N, N m",
          "Restoring coefficients of heave, roll and pitch at O; symmetric."},
         {"resistance", resistance_shape(), false, "none", "", "Ahead and astern."},
         {"cross_flow",
          vessel_part<CrossFlow>("cross_flow", "a cross-flow drag", "By 20 strips along the hull."),
          false, "none", "", "Across and in yaw."},
         {"polynomial", polynomial_shape(), false, "none", "", "Hull forces by coefficients."},
         {"mmg",
          vessel_part<MmgStern>("mmg_stern", "a stern of the MMG method",
                                "Propeller and rudder (Yasukawa and Yoshimura 2015)."),
          false, "none", "", "Propeller and rudder of a coefficient set."},
         {"steering",
          vessel_part<SteeringDef>("vessel_steering", "a steering gear",
                                   "Rudder and revolutions of a coefficient set."),
          false, "none", "", "Signals NAME.rudder and NAME.rps."},
         {"wind", wind_shape(), false, "none", "", "Wind on the part above the water."},
         {"propulsors", list("a list of propulsors", propulsor_shape(), 1, 100), false, "none", "",
          "Propellers and thrusters."},
         {"rudders", list("a list of rudders", rudder_shape(), 1, 100), false, "none", "",
          "Rudders."},
         {"current", current_shape(), false, "none", "",
          "Current loads at low speed, instead of resistance and cross_flow."},
         {"power", power_shape(), false, "none", "", "Power bus that sheds load."},
         {"thruster_losses", boolean("true or false"), false, "false", "",
          "Thrusters lose thrust in the race of others."},
         {"control", vessel_control_shape(), false, "none", "",
          "Joystick, autopilot and dynamic positioning."},
         {"dp_capability", dp_ship_shape(), false, "none", "",
          "Data for `hawser inspect --dp-capability`; does not act."},
         {"description", text("a text"), false, "", "", "Source and remarks."}});
}

}  // namespace hawser::scene
