// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_ends.h
/// Ends of wires that are cut, joined and released between two steps (hawser/wire.h).
///
/// ```
///     ── e ── n ── f ──        ── e ── n   m ── f ──
/// ```
/// Cut. The node n becomes two at the same position with the same velocity. Node m gets the part of
/// f in n, half the mass of its material. If elements have no material, it gets a fraction of n by
/// lengths. Drag and load are divided in the same ratio. Masses, momenta and energy are preserved
/// to rounding, and initially also tensions.
///
/// Splice. The reverse. If the nodes are at different positions, they meet at their centre of mass
/// with the momentum of both. Elements there get the rest lengths that keep their tensions, as for
/// the removal of nodes (nodes.h). The remaining difference of energy is driven.
///
/// Free end. No node carries the half element at a body. A released end gets it: half the mass of
/// its material, or the part of this element in the next node.

#include <hawser/math.h>

#include "context/ledger.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hawser::context {
struct StepContext;
}  // namespace hawser::context

namespace hawser::edit {

/// Part of one node in another: masses, drags and loads are divided in the same ratio.
struct NodeFraction {
    double mass = 0.0;   ///< [kg]
    double share = 0.0;  ///< Fraction of the mass of the other node [1].
};

/// Return the fraction of a node's mass and drag that comes from its second element. @param first
/// First element; −1: none.
[[nodiscard]] NodeFraction fraction_of(const context::StepContext& ctx, std::int32_t lump,
                                       std::int32_t first, std::int32_t second) noexcept;

/// Divide a node: set the added node `to` to the position and velocity of `from`, and transfer the
/// fraction of mass and drag.
void split_node(context::StepContext& ctx, std::int32_t from, std::int32_t to,
                const NodeFraction& share) noexcept;

/// Return the energies near the ends of two elements before a splice [J].
[[nodiscard]] context::Edited splice_energy(const context::StepContext& ctx, std::int32_t a,
                                            std::int32_t b, std::int32_t ea,
                                            std::int32_t eb) noexcept;
/// Merge the node b, at the end of element eb, into the node a; eb then ends at a. The caller
/// removes b, updates the bends and records the energies.
void merge_nodes(context::StepContext& ctx, std::int32_t a, std::int32_t b, std::int32_t ea,
                 std::int32_t eb) noexcept;

/// Reverse the order of the ends of an element or bend.
void reverse_ends(context::StepContext& ctx, std::int32_t id) noexcept;

/// Move an end of an element to another body, and update flags that depend on it.
void move_end(context::StepContext& ctx, std::int32_t id, std::size_t slot,
              std::int32_t to) noexcept;

/// Update the data of a node's elements that depend on its mass. Call after the mass has changed.
void update_elements_of_node(context::StepContext& ctx, std::int32_t lump) noexcept;

/// Return the chain of elements from `element` on, away from its end `slot`, while the nodes
/// between have no other interaction. @throws std::bad_alloc.
[[nodiscard]] std::vector<std::int32_t> chain_from(const context::StepContext& ctx,
                                                   std::int32_t element, std::size_t slot);

/// Return the bend interaction whose middle body is `middle` and one of whose outer bodies is
/// `end`; −1: none.
[[nodiscard]] std::int32_t bend_at_body(const context::StepContext& ctx, std::int32_t middle,
                                        std::int32_t end) noexcept;

}  // namespace hawser::edit
