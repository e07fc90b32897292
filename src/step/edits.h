// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file edits.h
/// Bodies, interactions and shapes that come and go between the steps of a world under way.
///
/// The arrays of the model keep a place for each (base/places.h), so that what stays keeps its
/// index, its multipliers and its memory. What has to follow is here:
///
/// - *Contacts* of a shape that goes are forgotten, with their friction and the links of bodies
///   that have no shape any more (assembly/contacts.h).
/// - *Sleep.* Only the islands that an edit touches wake: those of the bodies of an interaction
///   that comes or goes, of what lay on a shape that goes, of what is near one that comes.
/// - *Energy* that comes with a thing, or goes with it, counts as edited (hawser::Energy), by what
///   the thing holds half-way between two poses, where the ledger has its energies. So the judge
///   goes on without a break.
/// - *Wires* that an edit divides or joins keep what they remember, element by element
///   (make_wires()).
///
/// The next step, or whatever needs the system before it, analyses: the order of elimination is
/// repaired (factor/repair.h). Where shapes alone came or went, the collider and the contacts
/// follow and the system stays, unless other bodies may touch by that (prepare.h).

#include "context/ledger.h"

#include <cstdint>

namespace hawser::stepper {

struct StepContext;

/// Before the set of bodies, interactions or shapes changes; with room to note one more.
/// @throws std::bad_alloc.
void reserve_edit(StepContext& ctx);
void begin_edit(StepContext& ctx) noexcept;
/// The same before shapes alone come or go: bodies and interactions stay.
void begin_shape_edit(StepContext& ctx) noexcept;

/// Kinetic and gravity energy of a body at the half step before its pose [J].
[[nodiscard]] double energy_of_body(const StepContext& ctx, std::int32_t body) noexcept;
/// Elastic energy of an interaction there [J].
[[nodiscard]] double energy_of_interaction(const StepContext& ctx, std::int32_t id) noexcept;

/// By how much an element that moves as a straight piece has less kinetic energy than the lumps at
/// its ends [J]. Where it parts, these go on by themselves.
[[nodiscard]] double piece_energy(const StepContext& ctx, std::int32_t id) noexcept;
/// Of an element of a wire: what it holds, and what its mass takes off its lumps' motion.
[[nodiscard]] inline Edited energy_of_element(const StepContext& ctx, std::int32_t id) noexcept {
    return {-piece_energy(ctx, id), energy_of_interaction(ctx, id)};
}

/// What was added, after it was written into the model.
void settle_body(StepContext& ctx, std::int32_t body) noexcept;
void settle_interaction(StepContext& ctx, std::int32_t id) noexcept;
void settle_shape(StepContext& ctx, std::int32_t shape) noexcept;

/// Take away. A body must have no interactions and no shapes any more.
void remove_body(StepContext& ctx, std::int32_t body) noexcept;
void remove_interaction(StepContext& ctx, std::int32_t id) noexcept;
void remove_shape(StepContext& ctx, std::int32_t shape) noexcept;
/// Contacts of the last step in which a shape took part. Room was made by reserve_edit().
void forget_contacts(StepContext& ctx, std::int32_t shape) noexcept;

}  // namespace hawser::stepper
