// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file feed.h
/// An element with wire from a drum or through a guide: insertion and removal of nodes, and loads
/// on its ends.
///
/// ```
///     drum or guide ───────── line ───────── node ── wire ──
///                    material a [m], no node has any
/// ```
/// Half of the material acts on the node by a load with its weight, mass and drag. The other half
/// acts on the body at the other end. The drum or guide receives the weight along the wire. The
/// tension there is then that of the element plus the weight of half of it.

#include <hawser/system.h>

#include <cstddef>

namespace hawser::wire {

/// Relative material length at which a node is inserted or removed.
inline constexpr double kInsertRatio = 1.5, kRemoveRatio = 0.25;

/// Return the slot of the first node in the element.
/// @param fallback  Slot if neither end is a node.
[[nodiscard]] std::size_t node_slot(const World& world, InteractionId line, std::size_t fallback);

/// Return the weight of material of the element with a given mass, from the forces on its node
/// other than those of interactions [N].
/// @param mass  [kg]
[[nodiscard]] Vec3 weight_at(const World& world, InteractionId line, std::size_t node, double mass);

/// Apply the loads of the two halves of the element to its ends.
/// @param half  Mass of one half [kg].
/// @param held  Attachment of the end without a node, from the centre of its body, world frame [m].
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

/// Apply half of the mass, weight and drag of the element at the drum to each of its ends. Apply
/// the component of the weight along the wire to the drum.
/// @param node  Slot of the element's first node, from node_slot().
void load_element(const World& world, Loads& loads, const ElementAtDrum& element, std::size_t node);

/// Return the vector from the fairlead to the first node, world frame [m].
[[nodiscard]] Vec3 element_chord(const World& world, InteractionId line, std::size_t node);

/// Return the rest length of an element at a drum at which hauling stops [m]. An element that turns
/// by more than 0.1 rad in a step h gets longer than its force explains. The length is therefore
/// ```
///     max(g (10 h)², 10 h v)     a swing of 1 rad below the drum: h √(g/l) ≤ 0.1
/// ```
/// with the transverse speed v of its ends, but at most a quarter of the length of elements. A load
/// that swings while it is hauled in gets faster as v ~ 1/l, which is why v is included.
/// @param element  Length of inserted elements [m].
[[nodiscard]] double min_hauled_length(const World& world, InteractionId line, double element);

/// Data for inserting or removing a node.
struct Feed {
    InteractionId line{};
    bool ahead = false;            ///< True if the drum or guide is at the first end.
    double element = 0.0;          ///< Length of inserted elements [m].
    double mass_per_length = 0.0;  ///< [kg/m]
};

/// Insert a node on the element.
/// @param there  Unstretched length of the element before the insertion [m].
/// @param at  Length of material that no node carries [m]; reduced by the part that the node
/// carries.
/// @return true if a node was inserted.
bool insert_feed_node(NodeEdits& nodes, const Feed& feed, double there, double& at) noexcept;

/// Remove the node of the element; `at` grows by the material beyond it. Wire of another line type
/// remains.
/// @return true if the node was removed.
bool feed_in_node(NodeEdits& nodes, const Feed& feed, std::size_t node, double& at) noexcept;

}  // namespace hawser::wire
