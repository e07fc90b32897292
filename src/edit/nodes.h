// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file nodes.h
/// Insertion and removal of nodes of a wire between two steps, without a jump of tension.
///
/// ```
///     a ──────── e ──────── b        a ── e ── n ── f ── b
///          rest length L                 L₁          L₂
/// ```
/// Insertion. The node n is inserted at the fraction σ of the element, with the velocity of the
/// element there. With a consistent mass matrix (assembly/geo.h) the motion and mass do not change:
/// momentum, angular momentum and kinetic energy are preserved to rounding. The node takes over
/// weight from its neighbours, which bends the wire there. It is placed in equilibrium, δ = m_n g⊥
/// l₁ l₂/((l₁ + l₂) T) below the chord. The tensions of the two sides differ by the weight along
/// the chord, m_n g∥. Rest lengths are set to give these tensions at these distances; without
/// weight L₁ = σL.
///
/// Removal. e then spans the chord a–b: node_release.cpp.
///
/// At a drum. The element that a drum pays out (WinchStretch) has the material M [kg], which its
/// winch stores. No node contains it. The winch loads both ends with half (winch.h). A node
/// separates a piece f from the far end, at the fraction σ of M from the fairlead. Node n and the
/// node beyond have half of f. Material enters at the fairlead with the speed rω. The position of n
/// therefore moves with the velocity (1 − σ)(v_a + rω (b − a)/l) + σ v_b, l the rest length. The
/// strain rates of both parts equal that of the whole. Removal: node_drum.cpp.
///
/// Material. The mass of an element is that of its material, and is divided by σ. Rest lengths
/// follow forces and do not measure material.
///
/// Source: M. Servin, C. Lacoursière, F. Nordfelth, K. Bodin, "Hybrid, multiresolution wires with
/// massless frictional contacts", IEEE TVCG 17 (2011). The balances are our own.
///
/// Limits: forces other than weight (drag, contacts) are not part of the balance. The energy of
/// bending changes with the lengths at its node; the change counts as driven (hawser::Energy).

#include "context/ledger.h"
#include "edit/node_place.h"

#include <hawser/math.h>

#include <cstdint>

namespace hawser::context {
struct StepContext;
}  // namespace hawser::context

namespace hawser::edit {

/// Properties of a node to insert on an element.
struct NodeDef {
    double mass = 0.0;          ///< Mass [kg].
    Vec3 position{0, 0, 0};     ///< Position [m].
    Vec3 velocity{0, 0, 0};     ///< Velocity [m/s].
    Vec3 damping{0, 0, 0};      ///< Drag of both end nodes that the new node receives [N s/m].
    double of_end[2] = {0, 0};  ///< Fractions of the loads of both end nodes [1].
};

/// Energies before an edit [J].
struct NodeEnergies {
    context::Edited local, edited;
};

/// Find the elements, nodes and bends around an element (`first`) or, if `first` is −1, around a
/// node (`node`).
/// @return false in two cases: the node has other interactions, or it is not between two elements
/// of which the second begins at the end of the first.
[[nodiscard]] bool complete_surroundings(const context::StepContext& ctx,
                                         NodeSurroundings& place) noexcept;

/// Compute position, velocity, mass and drag of a new node on an element. @param share  Position of
/// the node as a fraction of the element's length. @param mass  Mass of the element [kg].
[[nodiscard]] NodeDef node_on(const context::StepContext& ctx, std::int32_t element, double share,
                              double mass) noexcept;

/// Return the energies of the bodies and interactions near a node, for end_node_edit() after the
/// edit.
[[nodiscard]] NodeEnergies begin_node_edit(const context::StepContext& ctx,
                                           const NodeSurroundings& place) noexcept;

/// Finish the insertion of node n, with the second element and the bend at n. Element `old` must
/// end at n, and all must have their masses, lengths and forces. @param old  The earlier element, e
/// or f. @param mass  Its earlier mass [kg].
void finish_node_insertion(context::StepContext& ctx, const NodeSurroundings& place,
                           std::int32_t old, double share, double mass) noexcept;

/// Extend element e to node b, and set the motion near node n to the motion of a wire without n.
/// The caller removes f, n and the bend at n. @param bend  Maximum angle between e and f [rad].
/// @return false if the angle is larger or energy would grow; the state is then unchanged.
[[nodiscard]] bool release_node(context::StepContext& ctx, const NodeSurroundings& place,
                                double bend) noexcept;
/// Fraction of half an element that a node between two elements loaded by drums or guides keeps.
inline constexpr double kKeptMass = 1e-2;
/// True if the mass of a node exceeds half of the mass of an element, apart from rounding.
/// @param has  Mass of the node [kg]. @param half  Half of the mass of the element [kg].
[[nodiscard]] constexpr bool exceeds_half(double has, double half) noexcept {
    return has > (1.0 + 1e-3) * half;
}
/// Remove a node as release_node() does, if the element that remains is at a drum.
[[nodiscard]] bool release_drum_node(context::StepContext& ctx, const NodeSurroundings& place,
                                     double bend) noexcept;

/// Record the change of energy by an edit in Energy::edited.
/// @param place  Surroundings after the edit.
void end_node_edit(context::StepContext& ctx, const NodeSurroundings& place,
                   const NodeEnergies& was) noexcept;

}  // namespace hawser::edit
