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
/// *Material.* The mass of an element is that of its material, and is shared as σ. Rest lengths
/// follow forces and are no account of it.
///
/// Source: M. Servin, C. Lacoursière, F. Nordfelth, K. Bodin, "Hybrid, multiresolution wires with
/// massless frictional contacts", IEEE TVCG 17 (2011); the balances are ours.
///
/// Limits: forces other than weight (drag, contacts) are not part of the balance. Bending changes
/// its energy with the lengths at its node; that counts as driven (hawser::Energy).

#include "step/node_place.h"

#include <hawser/math.h>

#include <cstdint>

namespace hawser::stepper {

struct StepContext;

/// What a lump on an element will be.
struct NodeDef {
    double mass = 0.0;       ///< [kg]
    Vec3 position{0, 0, 0};  ///< [m]
    Vec3 velocity{0, 0, 0};  ///< [m/s]
    Vec3 damping{0, 0, 0};   ///< What it takes of the drag of both ends [N s/m].
};

/// What the energies were before an edit [J].
struct NodeLedger {
    double local = 0.0, drive = 0.0;
};

/// What is about an element (`first`) or, where that is −1, about a lump (`node`).
/// @return false: the lump is not between two elements of which the second begins where the first
/// ends, or holds something else, too.
[[nodiscard]] bool find_place(const StepContext& ctx, NodePlace& place) noexcept;

/// @param share  σ of e.
[[nodiscard]] NodeDef node_on(const StepContext& ctx, std::int32_t element, double share) noexcept;

/// Before anything of the place changes.
[[nodiscard]] NodeLedger begin_node_edit(const StepContext& ctx, const NodePlace& place) noexcept;

/// n, f and the bend at n have been added: e ends at n, and all have their masses, lengths and
/// forces.
void settle_node(StepContext& ctx, const NodePlace& place, double share) noexcept;

/// e goes on to b, and the motion about n is that of the wire without it. The caller removes f, n
/// and the bend at n. @param bend  Angle between e and f up to which that is done [rad].
/// @return false: it is more, or energy would grow; nothing has changed.
[[nodiscard]] bool release_node(StepContext& ctx, const NodePlace& place, double bend) noexcept;

/// What the edit changed is driven. @param place  As it is now.
void end_node_edit(StepContext& ctx, const NodePlace& place, const NodeLedger& was) noexcept;

}  // namespace hawser::stepper
