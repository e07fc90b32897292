// SPDX-License-Identifier: Apache-2.0
/// The sea of a scene (hawser/sea.h).
#include <hawser/sea.h>

#include "scene/format.h"

#include <vector>

namespace hawser::scene {
namespace {

using namespace make;

ShapePtr direction() { return number("an angle", -360.0, 360.0); }
ShapePtr area() {
    const ShapePtr one = number("an area", 0.0, 1e9);
    return choice("an area, or [x, y, z] of them", {one, list("three areas", one, 3, 3)});
}

ShapePtr wave_shape() {
    return object(
        "wave", "a wave", "A regular wave, or the waves of a spectrum.",
        {{"kind", word("a kind of waves", {"regular", "jonswap", "pierson_moskowitz"}), true, "",
          "", "One wave, or a spectrum."},
         {"height", positive("a height", 100.0), true, "", "m",
          "Crest to trough; of a spectrum significant, Hs."},
         {"period", positive("a period", 1e4), true, "", "s",
          "Of a spectrum that of its peak, Tp."},
         {"direction_deg", direction(), false, "0", "deg", "To which they run, from x towards y."},
         {"phase_deg", direction(), false, "0", "deg",
          "Of a regular wave, whose crest is at the origin at 0 s with 0."},
         {"gamma", number("a factor", 1.0, 20.0), false, "3.3", "1",
          "Peak enhancement of JONSWAP."},
         {"spreading", number("a power", 0.0, 200.0), false, "0: one direction", "1",
          "s of the directions' cos^2s of half the angle."},
         {"components", integer("a number", 1, kMaxWaveComponents), false, "200", "",
          "Of a spectrum; at most 400 of all waves."},
         {"seed", integer("a seed", 0, 2147483647), false, "1", "",
          "Of phases, frequencies and directions."},
         {"lowest", number("a ratio", 1e-3, 1.0), false, "0.5", "1",
          "Lowest frequency over that of the peak."},
         {"highest", number("a ratio", 1.001, 20.0), false, "4", "1",
          "Highest frequency over that of the peak."}});
}

ShapePtr wind_shape() {
    return object(
        "wind", "a wind", "Wind, by the profile of ISO 19901-1.",
        {{"speed", number("a speed", 0.0, 100.0), true, "", "m/s", "Mean of an hour at 10 m."},
         {"direction_deg", direction(), false, "0", "deg", "To which it blows, from x towards y."},
         {"gusts", boolean("true or false"), false, "false", "",
          "True: with those of the NPD spectrum, 1/600 to 0.5 Hz."},
         {"components", integer("a number", 1, kMaxWaveComponents), false, "100", "", "Of gusts."},
         {"seed", integer("a seed", 0, 2147483647), false, "1", "", "Of gusts."},
         {"density", positive("a density", 1e3), false, "1.225", "kg/m^3", "Of air."}});
}

ShapePtr water_body_shape() {
    const ShapePtr ratio = number("a coefficient", 0.0, 1e6);
    return object(
        "water_body", "a body in the water",
        "A point mass, or a body without a hull: forces act at its centre of mass.",
        {{"body", body_ref(), true, "", "", "Which."},
         {"drag_area", area(), false, "0", "m^2",
          "Drag coefficient times area along its axes, when all of it is wet."},
         {"wind_area", area(), false, "0", "m^2", "The same in the wind, when all of it is dry."},
         {"volume", number("a volume", 0.0, 1e9), false, "0", "m^3", "Displaced under water."},
         {"added_mass",
          choice("a coefficient, or [x, y, z] of them",
                 {ratio, list("three coefficients", ratio, 3, 3)}),
          false, "0", "1", "Along its axes, of the volume's mass of water."},
         {"height", positive("a height", 1e4), false, "of a ball of its volume", "m",
          "From its lowest to its highest point."}});
}

ShapePtr water_rod_shape() {
    const ShapePtr coefficient = number("a coefficient", 0.0, 1e3);
    return object(
        "water_rod", "a rod in the water",
        "A straight slender member of a rigid body, by Morison's formula: a leg, a brace, a spar, "
        "a boom, a pipe.",
        {{"body", body_ref(), true, "", "", "Which."},
         {"from", vector3("a point"), true, "", "m",
          "One end, from the centre of mass, in the body's frame."},
         {"to", vector3("a point"), true, "", "m", "The other end."},
         {"diameter", positive("a diameter", 1e3), true, "", "m", "Of drag."},
         {"displaced_area", number("an area", 0.0, 1e6), false, "of the diameter", "m^2",
          "Volume of water displaced per length; 0 in a hull, which displaces it already."},
         {"cd_normal", coefficient, false, "1.2", "1", "Drag across, on the diameter."},
         {"cd_tangential", coefficient, false, "0", "1", "Drag along, on the circumference."},
         {"ca_normal", coefficient, false, "1", "1",
          "Added mass across, of the displaced water's."},
         {"ca_tangential", coefficient, false, "0", "1", "Added mass along."},
         {"segments", integer("a number", 1, kMaxRodSegments), false, "8", "",
          "Equal ones, each with the water at its middle."}});
}

}  // namespace

ShapePtr sea_shape() {
    const ShapePtr level =
        object("sea_level", "a level", "Height of still water at a time; linear between two.",
               {{"time", number("a time", -1e12, 1e12), true, "", "s", "Ascending."},
                {"level", number("a level", -1e5, 1e3), true, "", "m", "Above z = 0."}});
    const ShapePtr current =
        object("sea_current", "a current", "At a depth; linear between two.",
               {{"depth", number("a depth", 0.0, 1e5), false, "0", "m",
                 "Below the surface of still water, ascending."},
                {"speed", number("a speed", 0.0, 50.0), true, "", "m/s", "Of the water."},
                {"direction_deg", direction(), false, "0", "deg",
                 "To which it flows, from x towards y."}});
    return object(
        "sea", "a sea",
        "Water and wind. Cables of lumps whose line type has \"cd_normal\" are in it. Signals: "
        "sea.waves, sea.current, sea.wind, sea.wind_direction, sea.level, sea.elevation, sea.gust, "
        "sea.tide.",
        {{"depth", positive("a depth", 1e5), true, "", "m", "The bottom is at z = -depth."},
         {"density", positive("a density", 1e5), false, "1025", "kg/m^3", "Of water."},
         {"level", list("a list of levels", level, 1, 100'000), false, "0", "m", "Tide."},
         {"waves", list("a list of waves", wave_shape(), 0, kMaxWaveComponents), false, "none", "",
          "They add up."},
         {"current", list("a list of currents", current, 0, 1000), false, "none", "", "By depth."},
         {"wind", wind_shape(), false, "none", "", "Wind."},
         {"gauge", list("two numbers [x, y]", number("a length", -1e7, 1e7), 2, 2), false, "[0, 0]",
          "m", "Where sea.elevation is measured."},
         {"convective", boolean("true or false"), false, "false", "",
          "True: accelerations of waves have (u·∇)u, too."},
         {"bodies", list_of("a list of bodies in the water", water_body_shape()), false, "none", "",
          "Small bodies."},
         {"hulls", list_of("a list of hulls", water_hull_shape()), false, "none", "", "Hulls."},
         {"rods", list_of("a list of rods", water_rod_shape()), false, "none", "",
          "Slender members of rigid bodies."},
         {"description", text("a text"), false, "", "", "Remarks."}});
}

std::vector<Field> line_water_fields() {
    return {
        {"cd_normal", number("a coefficient", 0.0, 1e3), false, "it is not in the water", "1",
         "Drag across, on the diameter; with it a cable of lumps is in the sea of its scene."},
        {"cd_tangential", number("a coefficient", 0.0, 1e3), false, "0", "1",
         "Drag along, on the circumference."},
        {"ca_normal", number("a coefficient", 0.0, 1e3), false, "1", "1",
         "Added mass across, of the displaced water's."},
        {"ca_tangential", number("a coefficient", 0.0, 1e3), false, "0", "1", "Added mass along."},
        {"displaced_area", number("an area", 0.0, 1e6), false, "of the diameter", "m^2",
         "Volume of water displaced per length."}};
}

}  // namespace hawser::scene
