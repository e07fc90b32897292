// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file scene_info.h
/// What reports and pictures need to know about a scene beyond its World.

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
    std::vector<BodyId> nodes;            ///< In order, ends included.
    std::vector<InteractionId> elements;  ///< In order: stretch elements or joints between links.
    double EA = 0.0;                      ///< Axial stiffness [N]; 0 = not elastic.
    double breaking_load = 0.0;           ///< [N]; 0 = not given.
    double length = 0.0;                  ///< Unstretched [m].
    double diameter = 0.0;                ///< [m]; 0 = not given.
    /// Material coordinates between which it starts on its seabed [m]; NaN: it does not.
    double laid_from = kDefault, laid_to = kDefault;
    /// True if a bare drum keeps one element of it, which ends hauling
    /// (scene::Cable::drum_element).
    bool keeps_one = false;
};

struct SceneInfo {
    std::string name;
    std::string path;
    std::string text;        ///< Self-contained document that rebuilds the world.
    std::uint64_t hash = 0;  ///< Of `text`.
    std::vector<CableInfo> cables;
    std::vector<std::int32_t> plot_cables;  ///< Cables whose tension deserves a curve.
    std::vector<BodyId> plot_bodies;        ///< Bodies whose motion deserves a curve.
    /// Of each shape of the start, file and JSON pointer (scene::Scene::shape_places).
    std::vector<std::string> shape_places;
};

/// Of a scene that was read; it may be moved afterwards.
[[nodiscard]] SceneInfo info_of(const scene::Scene& scene);

/// Tension in one element after the last step [N]: minus the force of a stretch, winch or
/// distance row, and the magnitude of the force of a joint between links.
[[nodiscard]] double element_tension(const World& world, InteractionId element);

/// Bodies whose motion is reported: those that the scene wants plotted, else the rigid bodies
/// that are not inside a cable.
[[nodiscard]] std::vector<BodyId> watched_bodies(const SceneInfo& scene, const World& world);

/// The body's own name, or "tow/2 node 17" of a lump of a wire, or "body 17".
[[nodiscard]] std::string body_label(const World& world, BodyId body);
/// The interaction's own name, or "tow/2 stretch 17" of a part of a wire, or "stretch 17"; "-" for
/// no interaction.
[[nodiscard]] std::string interaction_label(const World& world, InteractionId interaction);
/// Where an event or a finding is: an interaction, a body, or "-".
[[nodiscard]] std::string place_label(const World& world, InteractionId interaction, BodyId body);
/// " (made by "upper")" of a name that a winch, crane, guide, post or route of the scene made, such
/// as "upper/slide1" of the route "upper"; "" of names that the author wrote.
[[nodiscard]] std::string origin(const World& world, std::string_view name);
/// What it is and between whom: `the hinge "foot" between "ship" and "boom"`.
[[nodiscard]] std::string interaction_in_words(const World& world, InteractionId interaction);
/// "a", "a and b", "a, b and c"; of more than eight the first eight and how many more.
[[nodiscard]] std::string names_in_words(const std::vector<std::string>& names);
/// A name in double quotes.
[[nodiscard]] std::string name_in_quotes(const std::string& name);

}  // namespace hawser::record
