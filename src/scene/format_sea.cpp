// SPDX-License-Identifier: Apache-2.0
/// The sea of a scene (hawser/sea.h).
#include <hawser/sea.h>

#include "scene/field_shapes.h"
#include "scene/format.h"
#include "scene/sea_fields.h"

#include <utility>
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
    std::vector<Field> fields{{"kind",
                               word("a kind of waves", {"regular", "jonswap", "pierson_moskowitz"}),
                               true, "", "", "One wave, or a spectrum."}};
    add_fields(fields, kWaveFields);
    return object("wave", "a wave", "A regular wave, or the waves of a spectrum.",
                  std::move(fields));
}

ShapePtr wind_shape() {
    std::vector<Field> fields;
    add_fields(fields, kWindFields);
    return object("wind", "a wind", "Wind, by the profile of ISO 19901-1.", std::move(fields));
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
          "Height from its lowest to its highest point."}});
}

ShapePtr water_rod_shape() {
    std::vector<Field> fields{{"body", body_ref(), true, "", "", "Which."},
                              {"from", vector3("a point"), true, "", "m",
                               "One end, from the centre of mass, in the body's frame."},
                              {"to", vector3("a point"), true, "", "m", "The other end."},
                              {"diameter", positive("a diameter", 1e3), true, "", "m",
                               "Diameter to which drag is referred."}};
    add_fields(fields, kLineWaterFields);
    fields.push_back({"segments", integer("a number", 1, kMaxRodSegments), false, "8", "",
                      "Equal ones, each with the water at its middle."});
    return object(
        "water_rod", "a rod in the water",
        "A straight slender member of a rigid body, by Morison's formula: a leg, a brace, a spar, "
        "a boom, a pipe.",
        std::move(fields));
}

}  // namespace

ShapePtr sea_shape() {
    const ShapePtr level =
        object("sea_level", "a level", "Height of still water at a time; linear between two.",
               {{"time", number("a time", -1e12, 1e12), true, "", "s", "Time; the times ascend."},
                {"level", number("a level", -1e5, 1e3), true, "", "m", "Level above z = 0."}});
    const ShapePtr current =
        object("sea_current", "a current", "At a depth; linear between two.",
               {{"depth", number("a depth", 0.0, 1e5), false, "0", "m",
                 "Depth below the surface of still water; depths ascend."},
                {"speed", number("a speed", 0.0, 50.0), true, "", "m/s", "Speed of the water."},
                {"direction_deg", direction(), false, "0", "deg",
                 "Direction to which the current flows, from x towards y."}});
    return object(
        "sea", "a sea",
        "Water and wind. They act on cables of nodes whose line type has \"cd_normal\". Signals: "
        "sea.waves, sea.current, sea.wind, sea.wind_direction, sea.level, sea.elevation, sea.gust, "
        "sea.tide.",
        {{"depth", positive("a depth", 1e5), true, "", "m", "The bottom is at z = -depth."},
         {"density", positive("a density", 1e5), false, "1025", "kg/m^3", "Density of water."},
         {"level", list("a list of levels", level, 1, 100'000), false, "0", "m", "Tide."},
         {"waves", list("a list of waves", wave_shape(), 0, kMaxWaveComponents), false, "none", "",
          "Waves; their elevations add up."},
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
    std::vector<Field> fields;
    add_fields(fields, kLineWaterFields);
    for (Field& field : fields) {
        if (field.name == "cd_normal") {
            field.fallback = "it is not in the water";
            field.doc =
                "Drag across, on the diameter; with it a cable of lumps is in the sea of its "
                "scene.";
        } else if (field.name == "displaced_area") {
            field.doc = "Volume of water displaced per length.";
        }
    }
    return fields;
}

}  // namespace hawser::scene
