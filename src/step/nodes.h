// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file nodes.h
/// Nodes that come and go along a wire between two steps, without a jump of tension.
///
/// ```
///     a ──────── e ──────── b        a ── e ── n ── f ── b
///          rest length L                 L₁          L₂
/// ```
/// *In.* The node n comes at the share σ of the element, with the velocity that the element has
/// there. With a consistent mass matrix (assembly/geo.h) that is the same motion of the same mass:
/// momentum, angular momentum and kinetic energy stay to rounding. n takes weight that its
/// neighbours held, which bends the wire there: n goes where the forces balance,
/// δ = m_n g⊥ l₁ l₂/((l₁ + l₂) T) below the chord, and the tensions of the two sides differ by the
/// weight along the chord, m_n g∥. Rest lengths are those that give these tensions at these
/// distances; without weight L₁ = σL.
///
/// *Out.* e then spans the chord a–b: node_release.cpp.
///
/// *At a drum.* The element that a drum pays out (WinchStretch) has the material M [kg] that its
/// winch knows, of which no lump has anything: the winch loads both ends with half (winch.h). A
/// node takes a piece f of its own off the far end, at the share σ of M from the fairlead; n and
/// the lump beyond have half of f. As material comes in at the fairlead with the speed rω, the
/// place of n moves with the velocity (1 − σ)(v_a + rω (b − a)/l) + σ v_b, l the rest length, and
/// the strain rates of both parts are that of the whole. Going: node_drum.cpp.
///
/// *Material.* The mass of an element is that of its material, and is shared as σ. Rest lengths
/// follow forces and are no account of it.
///
/// Source: M. Servin, C. Lacoursière, F. Nordfelth, K. Bodin, "Hybrid, multiresolution wires with
/// massless frictional contacts", IEEE TVCG 17 (2011); the balances are ours.
///
/// Limits: forces other than weight (drag, contacts) are not part of the balance. Bending changes
/// its energy with the lengths at its node; that counts as driven (hawser::Energy).

#include "context/ledger.h"
#include "step/node_place.h"

#include <hawser/math.h>

#include <cstdint>

namespace hawser::stepper {

struct StepContext;

/// What a lump on an element will be.
struct NodeDef {
    double mass = 0.0;          ///< [kg]
    Vec3 position{0, 0, 0};     ///< [m]
    Vec3 velocity{0, 0, 0};     ///< [m/s]
    Vec3 damping{0, 0, 0};      ///< What it takes of the drag of both ends [N s/m].
    double of_end[2] = {0, 0};  ///< What it takes of what acts on the lumps at the ends.
};

/// What the energies were before an edit [J].
struct NodeLedger {
    Edited local, edited;
};

/// What is about an element (`first`) or, where that is −1, about a lump (`node`).
/// @return false: the lump is not between two elements of which the second begins where the first
/// ends, or holds something else, too.
[[nodiscard]] bool find_place(const StepContext& ctx, NodePlace& place) noexcept;

/// @param share  σ of e. @param mass  Of the element [kg].
[[nodiscard]] NodeDef node_on(const StepContext& ctx, std::int32_t element, double share,
                              double mass) noexcept;

/// Take the energies about the place of a node before anything there changes.
[[nodiscard]] NodeLedger begin_node_edit(const StepContext& ctx, const NodePlace& place) noexcept;

/// n, the other element and the bend at n have been added: `old` ends at n, and all have their
/// masses, lengths and forces. @param old  The element that was there, e or f. @param mass  It had.
void settle_node(StepContext& ctx, const NodePlace& place, std::int32_t old, double share,
                 double mass) noexcept;

/// e goes on to b, and the motion about n is that of the wire without it. The caller removes f, n
/// and the bend at n. @param bend  Angle between e and f up to which that is done [rad].
/// @return false: it is more, or energy would grow; nothing has changed.
[[nodiscard]] bool release_node(StepContext& ctx, const NodePlace& place, double bend) noexcept;
/// Of half an element: what a lump between two elements that drums or guides load keeps for itself.
inline constexpr double kKeptMass = 1e-2;
/// Whether a lump that gives away half an element has mass beyond it: rounding is none.
/// @param has, half  [kg].
[[nodiscard]] constexpr bool has_more_than(double has, double half) noexcept {
    return has > (1.0 + 1e-3) * half;
}
/// As release_node(), where the element of the place that stays lies on a drum.
[[nodiscard]] bool release_drum_node(StepContext& ctx, const NodePlace& place,
                                     double bend) noexcept;

/// What the edit changed is edited (Energy::edited). @param place  As it is now.
void end_node_edit(StepContext& ctx, const NodePlace& place, const NodeLedger& was) noexcept;

}  // namespace hawser::stepper
