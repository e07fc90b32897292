// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file cable_parts.h
/// Data of a cable of the scene after reading.

#include "scene/description.h"

#include <cstddef>
#include <string>
#include <vector>

namespace hawser::scene {

struct CableEnd {
    enum class Kind { body, fixed, free };
    Kind kind = Kind::body;
    BodyId body;                   ///< Body of the end; the world body for a fixed end of links.
    Vec3 local{0.0, 0.0, 0.0};     ///< Point in the frame of `body` [m].
    Vec3 world{0.0, 0.0, 0.0};     ///< Position in the world [m].
    Vec3 velocity{0.0, 0.0, 0.0};  ///< Velocity [m/s].
};

/// A piece of a cable of one line type.
struct LayoutSection {
    CableSection line;
    double element = 0.0;  ///< Unstretched length of one element [m].
    double axial_damping = kDefault;
    double drag = 0.0;              ///< Drag per length [N s/m²].
    double submerged_factor = 1.0;  ///< Weight in water / weight in air.
    std::string color;
    LineWater water{};  ///< Water forces; diameter 0: the section is in air.
};

struct CableLayout {
    std::string name;
    bool links = false;
    CableEnd from, to;
    std::vector<LayoutSection> sections;  ///< Sections, at least one.
    std::size_t elements = 0;             ///< Number of elements of all sections.
    double length = 0.0;                  ///< Unstretched length of all sections [m].
    std::vector<Vec3> nodes;              ///< elements + 1.
    /// Material coordinates of the part on its seabed [m]; NaN: no such part.
    double laid_from = kDefault, laid_to = kDefault;

    std::size_t weak = 0;  ///< Index of its weak element, if weak_load is not 0.
    double weak_load =
        0.0;              ///< Breaking load of the weak element [N]; 0: there is no weak element.
    double radius = 0.0;  ///< Radius of links [m].
    bool tension_only = true;
    bool consistent_mass = false;  ///< As in WireDef.
    double joint_compliance = kDefault;
    double joint_damping_time = kDefault;

    std::vector<std::string> groups{""};  ///< Groups of its bodies, distributed evenly along it.

    bool touches = false;  ///< True if its elements have contact shapes like `contact` …
    bool to_ends = false;  ///< … and true if elements at bodies have them, too.
    ShapeDef contact;      ///< Contact shape; its radius is that of the cable.

    BodyId drum;               ///< Drum of the winch, if any.
    double drum_radius = 0.0;  ///< Radius of the drum [m].
    bool fed = false;          ///< True if the drum feeds elements (drum_feed.h).

    [[nodiscard]] const LayoutSection& first() const { return sections.front(); }
    /// Return the section of element i.
    [[nodiscard]] const LayoutSection& of(std::size_t i) const {
        std::size_t k = 0;
        for (; k + 1 < sections.size() && i >= sections[k].line.elements; ++k)
            i -= sections[k].line.elements;
        return sections[k];
    }
    /// Return the fraction of the length from the start to node i.
    [[nodiscard]] double length_fraction(std::size_t i) const {
        if (sections.size() == 1) return static_cast<double>(i) / static_cast<double>(elements);
        double up = 0.0;
        for (const LayoutSection& s : sections) {
            const std::size_t here = i < s.line.elements ? i : s.line.elements;
            up += s.element * static_cast<double>(here);
            i -= here;
        }
        return up / length;
    }
};

/// Read "resolution" of a cable with a layout (resolutions.cpp). @throws SceneError.
void read_resolution(Description& out, const CableLayout& cable, const Json& json,
                     const SourceLocation& cable_location);
/// Read the water forces on a cable of nodes. If some sections have drag, the others have no water
/// forces, and no part of the others may be in air. @throws SceneError.
void read_water(Description& out, const CableLayout& cable, const Document& document,
                const SourceLocation& location);

}  // namespace hawser::scene
