// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cable_parts.h
/// What a cable of the scene is made of once it is read.

#include "scene/description.h"

#include <cstddef>
#include <string>
#include <vector>

namespace hawser::scene {

struct CableEnd {
    enum class Kind { body, fixed, free };
    Kind kind = Kind::body;
    BodyId body;                   ///< The world body for a fixed end of links.
    Vec3 local{0.0, 0.0, 0.0};     ///< In the frame of `body` [m].
    Vec3 world{0.0, 0.0, 0.0};     ///< [m].
    Vec3 velocity{0.0, 0.0, 0.0};  ///< [m/s].
};

struct CableLayout {
    std::string name;
    std::string line_name;
    bool links = false;
    CableEnd from, to;
    std::size_t elements = 0;
    double length = 0.0;      ///< Unstretched, in all [m].
    double element = 0.0;     ///< Unstretched length of one element [m].
    std::vector<Vec3> nodes;  ///< elements + 1.
    /// Material coordinates between which they lie on its seabed [m]; NaN: they do not.
    double laid_from = kDefault, laid_to = kDefault;

    double mass_per_length = 0.0;  ///< [kg/m].
    double EA = 0.0;               ///< [N].
    double EI = 0.0;               ///< [N m²].
    double breaking_load = 0.0;    ///< [N]; 0 = never.
    std::size_t weak = 0;          ///< Its weak element, where weak_load is not 0.
    double weak_load = 0.0;        ///< [N]; 0: there is none.
    double axial_damping = kDefault;
    double drag = 0.0;              ///< [N s/m²].
    double submerged_factor = 1.0;  ///< Weight in water / weight in air.
    double diameter = 0.0;          ///< [m].
    std::string color;
    double radius = 0.0;  ///< Of links [m].
    bool tension_only = true;
    bool consistent_mass = false;  ///< As WireDef has it.
    double joint_compliance = kDefault;
    double joint_damping_time = kDefault;

    std::vector<std::string> groups{""};  ///< Of its bodies, shared out evenly.

    bool touches = false;  ///< Its elements have shapes like `contact`.
    ShapeDef contact;      ///< Its radius is that of the contact.

    BodyId drum;               ///< Of the winch, if any.
    double drum_radius = 0.0;  ///< [m].
};

}  // namespace hawser::scene
