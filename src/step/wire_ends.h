// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_ends.h
/// Ends of wires that are cut, joined and let go between two steps (hawser/wire.h).
///
/// ```
///     ── e ── n ── f ──        ── e ── n   m ── f ──
/// ```
/// *Cut.* The lump n becomes two at the same place with the same velocity: m has what n holds of
/// f, half the mass of its material, or, where elements have none of their own, a share of n by
/// lengths; and as much of its drag and load. So masses, momenta and energy stay to rounding, and
/// tensions do at first.
///
/// *Splice.* The other way round. Where the lumps are apart they meet at their centre of mass with
/// the momentum of both; elements there get the rest lengths that keep their tensions, as where
/// nodes go (nodes.h). What that leaves of the energy is driven.
///
/// *Free end.* The half element at a body is carried by no lump; one that is let go has it: half
/// the mass of its material, or what the next lump has of this element.

#include <hawser/math.h>

#include "context/ledger.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace hawser::stepper {

struct StepContext;

/// What one lump has of another: masses, drags and loads are shared alike.
struct LumpShare {
    double mass = 0.0;   ///< [kg]
    double share = 0.0;  ///< Of the mass of the other [1].
};

/// What a lump between two elements holds of the second one. @param first  −1: none.
[[nodiscard]] LumpShare share_of(const StepContext& ctx, std::int32_t lump, std::int32_t first,
                                 std::int32_t second) noexcept;

/// A lump that has been added is where another one is, moves as it does, and takes its share.
void split_lump(StepContext& ctx, std::int32_t from, std::int32_t to,
                const LumpShare& share) noexcept;

/// What is at the ends of two elements that are to be spliced [J].
[[nodiscard]] Edited splice_energy(const StepContext& ctx, std::int32_t a, std::int32_t b,
                                   std::int32_t ea, std::int32_t eb) noexcept;
/// The lump a takes in b, at the end of the element eb, which ends at a then. The caller removes b
/// and puts bends right. Energies are for the caller to book.
void merge_lumps(StepContext& ctx, std::int32_t a, std::int32_t b, std::int32_t ea,
                 std::int32_t eb) noexcept;

/// Another order of the ends of an element or bend.
void turn_round(StepContext& ctx, std::int32_t id) noexcept;

/// An element ends at another body, which may be one that its flags are to tell of.
void move_end(StepContext& ctx, std::int32_t id, std::size_t slot, std::int32_t to) noexcept;

/// Elements that hold a lump know its mass.
void follow_lump(StepContext& ctx, std::int32_t lump) noexcept;

/// Elements from one on, away from the end `slot` of it, as long as lumps that nothing else holds
/// are between. @throws std::bad_alloc.
[[nodiscard]] std::vector<std::int32_t> chain_from(const StepContext& ctx, std::int32_t element,
                                                   std::size_t slot);

/// The bend in the middle of which a body is, with another one at one of its ends; −1: none.
[[nodiscard]] std::int32_t bend_about(const StepContext& ctx, std::int32_t middle,
                                      std::int32_t end) noexcept;

}  // namespace hawser::stepper
