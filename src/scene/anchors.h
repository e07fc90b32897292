// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file anchors.h
/// Numbers of anchors and stability gauges in a scene (hawser/anchor.h, hawser/stability.h). Format
/// and reader use one table. Keys that end in _deg are degrees here and radians in definitions.

#include <hawser/anchor.h>
#include <hawser/stability.h>

#include "scene/vessels.h"

namespace hawser::scene {

template <>
struct VesselTable<AnchorDef> {
    static constexpr FieldInfo<AnchorDef> kNumbers[] = {
        {"mass", &AnchorDef::mass, "kg", "of the body", "Mass of the anchor, for its type.", 1e-3,
         1e9},
        {"uhc", &AnchorDef::uhc, "N", "of the type", "Ultimate holding capacity.", 1e-3, 1e12},
        {"fluke_length", &AnchorDef::fluke_length, "m", "(mass/120)^(1/3)", "Length of the fluke.",
         1e-3, 100.0},
        {"first", &AnchorDef::first, "1", "0.072",
         "Fraction of the capacity at zero drag distance.", 0.0, 1.0},
        {"drag_length", &AnchorDef::drag_length, "m", "20 fluke lengths in clay, 4 in sand",
         "Drag over which the rest of the capacity falls to 1/e.", 1e-3, 1e5},
        {"full_depth", &AnchorDef::full_depth, "m", "0", "Depth at full drag, exponential law.",
         0.0, 1e3},
        {"breakout", &AnchorDef::breakout, "1", "0.75 in clay, 0.17 in sand",
         "Vertical force that breaks it out, over its capacity.", 1e-6, 10.0},
        {"friction", &AnchorDef::friction, "1", "0.5",
         "Friction coefficient of a free anchor on the seabed.", 0.0, 10.0},
        {"weight", &AnchorDef::weight, "N", "of the body in the sea", "Submerged weight.", 0.0,
         1e12},
        {"seabed", &AnchorDef::seabed, "m", "of the sea, or the height at the start",
         "Height of the seabed.", -2e4, 2e4},
        {"touch", &AnchorDef::touch, "m", "0.5", "Height below which a free anchor is on it.", 0.0,
         100.0},
        {"set_after", &AnchorDef::set_after, "m", "half a fluke length",
         "Drag after which a free anchor is set.", 0.0, 1e4},
        {"drag", &AnchorDef::drag, "m", "0", "Drag at the start.", 0.0, 1e5}};
};

template <>
struct VesselTable<AnchorClay> {
    static constexpr FieldInfo<AnchorClay> kNumbers[] = {
        {"strength", &AnchorClay::strength, "Pa", "0", "Undrained shear strength at the seabed.",
         0.0, 1e9},
        {"gradient", &AnchorClay::gradient, "Pa/m", "0", "Its gradient with depth.", 0.0, 1e9},
        {"fluke_area", &AnchorClay::fluke_area, "m^2", "0",
         "Fluke area of the anchor, for the trajectory.", 0.0, 1e4},
        {"bearing", &AnchorClay::bearing, "1", "9", "Bearing factor N_e of the anchor.", 1e-3,
         100.0},
        {"fluke_angle_deg", &AnchorClay::fluke_angle, "degrees", "45",
         "Angle between the fluke and the line.", 1e-3, 80.0},
        {"first_depth", &AnchorClay::first_depth, "m", "1", "Depth of the point at no drag.", 1e-3,
         1e3},
        {"chain_width", &AnchorClay::chain_width, "m", "0",
         "Bearing width of the line: 2.5 bar diameters of chain, the diameter of wire.", 0.0, 10.0},
        {"chain_bearing", &AnchorClay::chain_bearing, "1", "12", "Bearing factor N_c of the line.",
         1e-3, 1e3},
        {"chain_friction", &AnchorClay::chain_friction, "1", "0",
         "Friction coefficient of the line along its curve in the soil.", 0.0, 2.0}};
};

template <>
struct VesselTable<StabilityDef> {
    static constexpr FieldInfo<StabilityDef> kNumbers[] = {
        {"thrust_height", &StabilityDef::thrust_height, "m", "half of the draught",
         "z of the thrust line in the frame of the body.", -1e3, 1e3},
        {"stern_x", &StabilityDef::stern_x, "m", "of the pin", "x of the stern.", -kMaxVesselLength,
         kMaxVesselLength},
        {"bollard_pull", &StabilityDef::bollard_pull, "N", "0", "Limits the worst angle.", 0.0,
         1e9},
        {"mass", &StabilityDef::mass, "kg", "of the body", "Displacement.", 1e-3, 1e15},
        {"gm", &StabilityDef::gm, "m", "of the hull's mesh",
         "Metacentric height of a ship without a mesh.", -1e3, 1e3},
        {"most_heel_deg", &StabilityDef::most_heel, "degrees", "15", "Largest static heel.", 1e-3,
         80.0},
        {"deck_edge_deg", &StabilityDef::deck_edge, "degrees", "none",
         "Heel with the deck edge in the water.", 1e-3, 90.0},
        {"flooding_deg", &StabilityDef::flooding, "degrees", "none", "Flooding angle.", 1e-3, 90.0},
        {"residual_area", &StabilityDef::residual_area, "m rad", "0.070", "Least residual area.",
         0.0, 10.0},
        {"residual_lever", &StabilityDef::residual_lever, "m", "0.2", "Least residual lever.", 0.0,
         100.0},
        {"freeboard", &StabilityDef::freeboard, "m", "0.005 of the length",
         "Freeboard at the stern.", 0.0, 100.0},
        {"gravity", &StabilityDef::gravity, "m/s^2", "9.81", "Acceleration of gravity.", 1e-3,
         100.0},
        {"warn", &StabilityDef::warn, "1", "0.8", "Utilisation of the warning.", 1e-3, 1.0},
        {"hysteresis", &StabilityDef::hysteresis, "1", "0.05",
         "Amount by which a value must fall below the level of an alarm before the alarm ends.",
         0.0, 0.5}};
};

/// Read the anchors and gauges of one scope, when all bodies and cables exist.
void expand_anchors(Description& out, const Scope& scope);
/// Add anchors and gauges to the world, after the sea. @throws SceneError if the world rejects one.
void add_anchors(World& world, const Description& from);

}  // namespace hawser::scene
