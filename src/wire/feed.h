// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file feed.h
/// An element whose wire comes from a drum or runs through a guide: nodes that come and go there,
/// and what acts on its ends.
///
/// ```
///     drum or guide ───────── line ───────── node ── wire ──
///                    material a [m], no lump has any
/// ```
/// Half of the material acts on the node by a load, with its weight, mass and drag, half on what
/// holds the other end. What feeds it has the weight along the wire, so that the tension there is
/// that of the element and the weight of half of it.

#include <hawser/system.h>

#include <cstddef>

namespace hawser::wire {

/// Of the length of what comes, where a node comes and goes.
inline constexpr double kGrown = 1.5, kShrunk = 0.25;

/// Slot of the element that its first node has. @param fallback  Where neither end is a lump.
[[nodiscard]] std::size_t node_slot(const World& world, InteractionId line, std::size_t fallback);

/// Weight of some of the element's material, by what acts on its node beside forces of interactions
/// [N]. @param mass  [kg]
[[nodiscard]] Vec3 weight_at(const World& world, InteractionId line, std::size_t node, double mass);

/// The element's halves act on its ends. @param half  Mass of one [kg]. @param held  Where the end
/// without a node is held, from the centre of its body, world frame [m].
void load_ends(const World& world, Loads& loads, InteractionId line, std::size_t node, double half,
               const Vec3& weight, const Vec3& held);

/// Element between a drum and the wire's first node.
struct ElementAtDrum {
    InteractionId line{};          ///< The element.
    BodyId drum{};                 ///< Scalar body that pays it out.
    double radius = 0.0;           ///< Line paid out per unit of the drum's coordinate [m].
    double mass_per_length = 0.0;  ///< [kg/m]
    double material = 0.0;         ///< Unstretched length of the element [m].
};

/// Load both ends of the element with half of its mass, weight and drag each, and the drum with the
/// weight along the wire. @param node  Slot of the element's first node, from node_slot().
void load_element(const World& world, Loads& loads, const ElementAtDrum& element, std::size_t node);

/// Vector from the fairlead to the first node, world frame [m].
[[nodiscard]] Vec3 along_element(const World& world, InteractionId line, std::size_t node);

/// What a node that comes or goes needs to know.
struct Feed {
    InteractionId line{};
    bool ahead = false;            ///< What feeds it is at its first end.
    double element = 0.0;          ///< Length of what comes [m].
    double mass_per_length = 0.0;  ///< [kg/m]
};

/// A node comes on the element. @param at  Its material [m], which gets less by what the node
/// takes.
/// @return whether one came.
bool put_node(NodeEdits& nodes, const Feed& feed, double there, double& at) noexcept;

/// The element's node goes: `at` grows by the material beyond it. Wire of another line type stays.
/// @return whether it went.
bool take_node(NodeEdits& nodes, const Feed& feed, std::size_t node, double& at) noexcept;

}  // namespace hawser::wire
