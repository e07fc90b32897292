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

/// A piece of a cable of one line type.
struct LayoutSection {
    CableSection line;
    double element = 0.0;  ///< Unstretched length of one element [m].
    double axial_damping = kDefault;
    double drag = 0.0;              ///< [N s/m²].
    double submerged_factor = 1.0;  ///< Weight in water / weight in air.
    std::string color;
    LineWater water{};  ///< Diameter 0: it is in air.
};

struct CableLayout {
    std::string name;
    bool links = false;
    CableEnd from, to;
    std::vector<LayoutSection> sections;  ///< At least one.
    std::size_t elements = 0;             ///< In all.
    double length = 0.0;                  ///< Unstretched, in all [m].
    std::vector<Vec3> nodes;              ///< elements + 1.
    /// Material coordinates between which they lie on its seabed [m]; NaN: they do not.
    double laid_from = kDefault, laid_to = kDefault;

    std::size_t weak = 0;    ///< Its weak element, where weak_load is not 0.
    double weak_load = 0.0;  ///< [N]; 0: there is none.
    double radius = 0.0;     ///< Of links [m].
    bool tension_only = true;
    bool consistent_mass = false;  ///< As WireDef has it.
    double joint_compliance = kDefault;
    double joint_damping_time = kDefault;

    std::vector<std::string> groups{""};  ///< Of its bodies, shared out evenly.

    bool touches = false;  ///< Its elements have shapes like `contact` …
    bool to_ends = false;  ///< … and so do those that end on a body.
    ShapeDef contact;      ///< Its radius is that of the contact.

    BodyId drum;               ///< Of the winch, if any.
    double drum_radius = 0.0;  ///< [m].
    bool fed = false;          ///< The drum feeds elements (drum_feed.h).

    [[nodiscard]] const LayoutSection& first() const { return sections.front(); }
    /// Section that element i belongs to.
    [[nodiscard]] const LayoutSection& of(std::size_t i) const {
        std::size_t k = 0;
        for (; k + 1 < sections.size() && i >= sections[k].line.elements; ++k)
            i -= sections[k].line.elements;
        return sections[k];
    }
    /// Share of the length up to node i.
    [[nodiscard]] double share(std::size_t i) const {
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

/// "resolution" of a cable that has been laid out (resolutions.cpp). @throws SceneError.
void read_resolution(Description& out, const CableLayout& cable, const Json& json,
                     const Place& cable_place);
/// What water does to a cable of lumps. A section without drag in one that has some has no water:
/// no part of it may be in air. @throws SceneError.
void read_water(Description& out, const CableLayout& cable, const Document& document,
                const Place& place);

}  // namespace hawser::scene
