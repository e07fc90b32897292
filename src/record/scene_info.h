// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file scene_info.h
/// Data of a scene for reports and pictures, in addition to its World.

#include <hawser/hawser.h>
#include <hawser/scene.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::record {

/// A cable: a row of bodies joined by elements that carry tension.
struct CableInfo {
    std::string name;
    std::string line_type;
    std::vector<BodyId> nodes;  ///< Nodes in order, ends included.
    std::vector<InteractionId>
        elements;                ///< Elements in order: stretch elements or joints between links.
    double EA = 0.0;             ///< Axial stiffness [N]; 0 = not elastic.
    double breaking_load = 0.0;  ///< Breaking load [N]; 0 = unspecified.
    double length = 0.0;         ///< Unstretched [m].
    double diameter = 0.0;       ///< Diameter [m]; 0 = unspecified.
    /// Material coordinates of the part that starts on its seabed [m]; NaN: no such part.
    double laid_from = kDefault, laid_to = kDefault;
    /// True if a bare drum keeps one element of it, which ends hauling
    /// (scene::Cable::drum_element).
    bool keeps_drum_element = false;
};

struct SceneInfo {
    std::string name;
    std::string path;
    std::string text;        ///< Self-contained document that rebuilds the world.
    std::uint64_t hash = 0;  ///< Hash of `text`.
    std::vector<CableInfo> cables;
    std::vector<std::int32_t> plot_cables;  ///< Cables with a plotted tension.
    std::vector<BodyId> plot_bodies;        ///< Bodies with a plotted motion.
    /// File and JSON pointer of each shape of the start (scene::Scene::shape_places).
    std::vector<std::string> shape_places;
};

/// Return the data of a scene that was read. The scene may be moved afterwards.
[[nodiscard]] SceneInfo make_scene_info(const scene::Scene& scene);

/// Return the tension in one element after the last step [N]. For a stretch, winch or distance row
/// it is minus the row's force. For a joint between links it is the magnitude of the force.
[[nodiscard]] double element_tension(const World& world, InteractionId element);

/// Return the bodies whose motion is reported: the plotted bodies of the scene, or without these
/// the rigid bodies that are not inside a cable.
[[nodiscard]] std::vector<BodyId> watched_bodies(const SceneInfo& scene, const World& world);

/// Return the body's own name, or "tow/2 node 17" for a node of a wire, or "body 17".
[[nodiscard]] std::string body_label(const World& world, BodyId body);
/// Return the interaction's own name, or "tow/2 stretch 17" for a part of a wire, or "stretch 17";
/// "-" for no interaction.
[[nodiscard]] std::string interaction_label(const World& world, InteractionId interaction);
/// Return the label of an event's or a finding's source: an interaction, a body, or "-".
[[nodiscard]] std::string position_label(const World& world, InteractionId interaction,
                                         BodyId body);
/// Return the origin of a name, such as " (made by "upper")" for "upper/slide1" of the route
/// "upper". Names with an origin come from a winch, crane, guide, post or route of the scene.
/// Return "" for names that the author wrote.
[[nodiscard]] std::string origin(const World& world, std::string_view name);
/// Return the kind of an interaction and its bodies: `the hinge "foot" between "ship" and "boom"`.
[[nodiscard]] std::string interaction_in_words(const World& world, InteractionId interaction);
/// Return "a", "a and b", or "a, b and c". For more than eight names, return the first eight and
/// the number of the others.
[[nodiscard]] std::string names_in_words(const std::vector<std::string>& names);
/// Return a name in double quotes.
[[nodiscard]] std::string name_in_quotes(const std::string& name);

}  // namespace hawser::record
