// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file edits.h
/// Addition and removal of bodies, interactions and shapes between the steps of a running world.
///
/// The arrays of the model have a slot for each object (base/places.h), so that remaining objects
/// keep their index, multipliers and memory. The consequences of an edit are treated here:
///
/// 1. Contacts of a removed shape are deleted, with their friction and the links of bodies
///    without shapes (assembly/contacts.h).
/// 2. Sleep. Only the islands near an edit wake. These contain the bodies of a changed
///    interaction, bodies in contact with a removed shape, or bodies near an added one.
/// 3. Energy of an added or removed object counts as edited (hawser::Energy). It is the energy
///    at the midpoint between two poses, where the balance is evaluated. The monitors thus
///    continue without a break.
/// 4. Wires that an edit divides or joins keep their memory, element by element
///    (make_wires()).
///
/// The next step, or an earlier use of the system, analyses it: the order of elimination is
/// repaired (factor/repair.h). If only shapes changed, the collider and the contacts follow. The
/// system is then analysed again only if other pairs of bodies may touch as a result (prepare.h).

#include "context/ledger.h"

#include <cstdint>

namespace hawser::context {
struct StepContext;
}  // namespace hawser::context

namespace hawser::edit {

/// Prepare the context for a change of the set of bodies, interactions or shapes. reserve_edit()
/// allocates all memory that begin_edit() needs to record one change. @throws std::bad_alloc.
void reserve_edit(context::StepContext& ctx);
void begin_edit(context::StepContext& ctx) noexcept;
/// Prepare the context for a change of the set of shapes alone.
void begin_shape_edit(context::StepContext& ctx) noexcept;

/// Return the kinetic and gravity energy of a body half a step before its pose [J].
[[nodiscard]] double energy_of_body(const context::StepContext& ctx, std::int32_t body) noexcept;
/// Return the elastic energy of an interaction half a step before the poses [J].
[[nodiscard]] double energy_of_interaction(const context::StepContext& ctx,
                                           std::int32_t id) noexcept;

/// Return the kinetic energy that an element adds if it breaks [J]: with half of its mass at each
/// end node, minus its energy as a straight bar. After the break the nodes move independently.
[[nodiscard]] double piece_energy(const context::StepContext& ctx, std::int32_t id) noexcept;
/// Return the energies of a wire element [J]: minus piece_energy() as kinetic energy, and its
/// elastic energy.
[[nodiscard]] inline context::Edited energy_of_element(const context::StepContext& ctx,
                                                       std::int32_t id) noexcept {
    return {-piece_energy(ctx, id), energy_of_interaction(ctx, id)};
}

/// Update the solver's data after a body has been written into the model. The next functions do
/// this for an interaction and a shape.
void register_added_body(context::StepContext& ctx, std::int32_t body) noexcept;
void register_added_interaction(context::StepContext& ctx, std::int32_t id) noexcept;
void register_added_shape(context::StepContext& ctx, std::int32_t shape) noexcept;

/// Remove a body without interactions and shapes. The next functions remove an interaction and a
/// shape.
void remove_body(context::StepContext& ctx, std::int32_t body) noexcept;
void remove_interaction(context::StepContext& ctx, std::int32_t id) noexcept;
void remove_shape(context::StepContext& ctx, std::int32_t shape) noexcept;
/// Delete the contacts of a shape that are stored from the last step. Call reserve_edit() before.
void forget_contacts(context::StepContext& ctx, std::int32_t shape) noexcept;

}  // namespace hawser::edit
