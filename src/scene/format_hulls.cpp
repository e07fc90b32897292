// SPDX-License-Identifier: Apache-2.0
/// Hulls in the sea of a scene (hawser/water_hull.h, hawser/hydro.h).
#include <hawser/water_hull.h>

#include "scene/format.h"

#include <vector>

namespace hawser::scene {
namespace {

using namespace make;

constexpr std::size_t kMaxFrequencies = 100'000, kMaxColumns = 100'000;

ShapePtr area_of_axes() {
    const ShapePtr one = number("an area", 0.0, 1e9);
    return choice("an area, or [x, y, z] of them", {one, list("three areas", one, 3, 3)});
}

ShapePtr strip_shape() {
    return object(
        "hull_strips", "a row of strips",
        "Drag of strips from one point to another: half of density, drag area and the square of "
        "the velocity along the axis.",
        {{"from", vector3("a point"), true, "", "m",
          "Begin of the row, from the centre of mass, in the body's frame."},
         {"to", vector3("a point"), true, "", "m", "End of it."},
         {"axis", vector3("a direction"), false, "[0, 1, 0]", "", "Axis along which they resist."},
         {"drag_area", number("an area", 0.0, 1e9), true, "", "m^2",
          "Drag coefficient times area of all of them, at the hull's design draught."},
         {"count", integer("a number", 1, 1000), false, "10", "", "Number of strips."}});
}

ShapePtr coefficients_shape() {
    const ShapePtr mode = integer("a motion", 1, 6);
    const ShapePtr pair = list("two motions", mode, 2, 2);
    const ShapePtr any = number("a number", -1e30, 1e30);
    const ShapePtr values = list("numbers, one a frequency", any, 1, kMaxFrequencies);
    const ShapePtr radiation = object(
        "radiation_pair", "a coefficient",
        "Added mass and damping of one motion by another, at each frequency.",
        {{"of", pair, true, "", "",
          "Motions 1 to 6: along x, y, z, about x, y, z. [i, j] is [j, i], too, unless that is "
          "given."},
         {"infinite", any, false, "0", "kg, kg m, kg m^2", "At infinite frequency."},
         {"zero", any, false, "0", "kg, kg m, kg m^2", "At frequency 0: for checks alone."},
         {"added_mass", values, false, "none", "kg, kg m, kg m^2", "At each frequency."},
         {"damping", values, false, "none", "N s/m, N s, N m s", "At each frequency."}});
    const ShapePtr force =
        object("wave_force", "a force of waves",
               "Force of one motion and direction, waves of amplitude 1 m: F = Re X e^(-iwt) if "
               "elevation at the reference is cos wt.",
               {{"of", mode, true, "", "", "Motion."},
                {"heading", integer("a direction", 0, 100'000), true, "", "",
                 "Which of headings_deg, from 0."},
                {"re", values, true, "", "N/m, N", "Real part, at each frequency."},
                {"im", values, true, "", "N/m, N", "Imaginary part."}});
    const ShapePtr drift =
        object("wave_drift", "a drift force",
               "Mean force of one motion and direction, over amplitude squared.",
               {{"of", mode, true, "", "", "Motion."},
                {"heading", integer("a direction", 0, 100'000), true, "", "",
                 "Which of headings_deg, from 0."},
                {"values", values, true, "", "N/m^2, N/m", "At each frequency."}});
    const ShapePtr stiffness =
        object("hull_stiffness", "a stiffness", "Of one motion by another, with that of weight.",
               {{"of", pair, true, "", "", "Motions; [i, j] is [j, i], too, unless that is given."},
                {"value", any, true, "", "N/m, N, N m", "Its value."}});
    return choice(
        "a file, or coefficients",
        {text("a file name"),
         object("coefficients_file", "a file of coefficients",
                "Coefficient file of WAMIT (.1), NEMOH (.tec), Capytaine (.nc) or BEMIO (.h5). "
                "Further files of the set are in the same folder.",
                {{"file", text("a file name"), true, "", "", "Relative to this one."},
                 {"density", positive("a density", 1e5), false, "1025", "kg/m^3",
                  "Density of water for files without dimensions."},
                 {"gravity", positive("a gravity", 1e3), false, "9.81", "m/s^2",
                  "Gravity for files without dimensions."},
                 {"length", positive("a length", 1e6), false, "of the .gdf, or 1", "m",
                  "ULEN of WAMIT."},
                 {"body_number", integer("a number", 0, 999), false, "0", "",
                  "Which of several bodies, from 0."}}),
         object(
             "wave_coefficients", "coefficients", "Written out, in SI units.",
             {{"frequencies", list("frequencies", positive("a frequency", 1e4), 1, kMaxFrequencies),
               true, "", "rad/s", "Frequencies, ascending."},
              {"radiation", list("a list of coefficients", radiation, 0, 36), false, "none", "",
               "Added mass and damping; pairs that are not there are 0."},
              {"headings_deg",
               list("directions", number("a direction", -400.0, 400.0), 1, kMaxColumns), false,
               "none", "deg", "Headings to which waves run, ascending."},
              {"excitation", list("a list of forces", force, 0, kMaxColumns), false, "none", "",
               "Forces of waves."},
              {"scattering", list("a list of forces", force, 0, kMaxColumns), false, "none", "",
               "Diffraction force only."},
              {"drift_forces", list("a list of forces", drift, 0, kMaxColumns), false, "none", "",
               "Mean forces of second order."},
              {"stiffness", list("a list of stiffnesses", stiffness, 0, 36), false, "none", "",
               "Hydrostatic, with that of weight."}})});
}

ShapePtr mesh_shape() {
    const ShapePtr corner = integer("a vertex", 0, 2'000'000);
    const ShapePtr points = list("a list of vertices", vector3("a vertex"), 4, kMaxElements);
    const ShapePtr triangles =
        list("a list of triangles", list("three vertices", corner, 3, 3), 4, kMaxElements);
    const ShapePtr pieces =
        list("three numbers [x, y, z]", integer("a number of pieces", 1, 1000), 3, 3);
    const ShapePtr half = list("three half sizes [x, y, z]", positive("a length", 1e4), 3, 3);
    return choice(
        "an OBJ, STL, GDF or DAT file, a box, or a mesh",
        {text("a file name"),
         object("hull_box", "a box", "A box as a mesh.",
                {{"box", half, true, "", "m", "Half sizes."},
                 {"pieces", pieces, false, "[1, 1, 1]", "", "Into which its sides are cut."}}),
         object("hull_mesh", "a mesh", "Triangles, counterclockwise seen from outside.",
                {{"vertices", points, true, "", "m", "Vertices in the frame of the mesh."},
                 {"triangles", triangles, true, "", "", "Corners by number, from 0."}})});
}

}  // namespace

ShapePtr water_hull_shape() {
    const ShapePtr number6 = number("a number", 0.0, kMaxDamping);
    return object(
        "water_hull", "a hull",
        "Hull of a rigid body for water pressure. Shapes for contacts are separate.",
        {{"body", body_ref(), true, "", "", "Which."},
         {"mesh", mesh_shape(), false, "none, with \"linear\"", "m",
          "Closed surface: a file .obj, .stl, .gdf or .dat relative to this one, a box, or the "
          "mesh "
          "itself."},
         {"deck", number("a height", -1e4, 1e4), false, "at the waterline", "m",
          "Of files that end at the waterline (.gdf, .dat): where walls up from there end."},
         {"offset", vector3("an offset"), false, "[0, 0, 0]", "m",
          "Of the mesh's origin from the centre of mass, in the body's frame."},
         {"scale", positive("a factor", 1e6), false, "1", "1", "Lengths of the mesh times this."},
         {"wave_pressure", boolean("true or false"), false, "true", "",
          "True: pressure of Airy's waves (Froude-Krylov); false: of still water up to the "
          "surface."},
         {"added_mass", list("six numbers", number6, 6, 6), false, "0", "kg, kg m^2",
          "Along and about the body's axes, at the centre of mass."},
         {"damping", list("six numbers", number6, 6, 6), false, "0", "N s/m, N m s",
          "Linear, along and about the same axes."},
         {"drag_area", area_of_axes(), false, "0", "m^2",
          "Drag coefficient times area along its axes, at the design draught; scaled by the wet "
          "projected area over that at the design draught."},
         {"wind_area", area_of_axes(), false, "0", "m^2",
          "The same for wind on the part above the water at the design draught."},
         {"design_draught", positive("a draught", 1e4), false, "as it floats", "m",
          "Draught at which the areas apply, upright, from the surface to the lowest point. "
          "Default: the draught at which the hull carries its body and the bodies joined to it. If "
          "it does not float, the draught at the start."},
         {"strips", list_of("a list of rows", strip_shape()), false, "none", "",
          "Rows of strips that resist drifting and turning."},
         {"coefficients", coefficients_shape(), false, "none", "",
          "Added mass, damping and forces of waves by frequency: a file or numbers."},
         {"negative_damping", word("a treatment", {"refuse", "truncate", "fit"}), false, "refuse",
          "",
          "Of damping that is not positive semi-definite by more than 5 % of its largest: truncate "
          "it from there on, or take the nearest matrices that are."},
         {"reference", vector3("a point"), false, "[0, 0, 0]", "m",
          "Reference point of the coefficients, relative to the centre of mass, in the body's "
          "frame."},
         {"radiation", word("a kind", {"convolution", "state_space", "constant", "none"}), false,
          "convolution", "", "Method for the memory of radiated waves, with coefficients."},
         {"memory", positive("a time", 1e5), false, "60", "s",
          "Time after which past motion has no effect any more."},
         {"order", integer("a number", 1, 200), false, "8", "", "Most states of a state space."},
         {"constant_period", positive("a period", 1e4), false, "none", "s",
          "Of the added mass and damping of \"constant\"."},
         {"excitation", word("a kind", {"none", "full", "scattering"}), false, "none", "",
          "Force of waves by coefficients: all of it, or on top of wave_pressure."},
         {"drift", boolean("true or false"), false, "false", "",
          "Mean and slow drift by the coefficients' table."},
         {"coriolis", boolean("true or false"), false, "false", "",
          "Coriolis and centripetal forces of the added mass, by Kirchhoff."},
         {"slow_time", number("a time", 0.0, 1e5), false, "16", "s",
          "Time constant of the four filters of the position at which the wave coefficients "
          "apply."},
         {"linear",
          object("linear_statics", "linear statics",
                 "Weight of displaced water and the coefficients' stiffness, instead of a mesh.",
                 {{"height", number("a height", -1e4, 1e4), true, "", "m",
                   "z of the centre of mass at rest, above still water."},
                  {"weight", positive("a weight", 1e15), false, "of the body", "N",
                   "Weight of the displaced water at rest."}}),
          false, "none", "", "Small motions about rest."}});
}

}  // namespace hawser::scene
