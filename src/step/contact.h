// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file contact.h
/// Contact points in a step: from collision to rows, and their memory.

#include "context/context.h"

namespace hawser::step {

/// Prepare the links between bodies that may touch, for the present shapes. Part of prepare().
/// @throws std::bad_alloc.
assembly::Contacts::Blocks prepare_contacts(context::Model& model, context::Work& work);

/// Purpose of starting contacts.
enum class Phase : std::uint8_t {
    regular,
    stagger,  ///< The staggered start: no contact closes or opens.
    impact,   ///< See impact.h, which sets the laws.
};

/// Assemble the rows of the contacts of stage collide, linearised about the last solution. If two
/// bodies are in contact for the first time, analyse the system.
[[nodiscard]] Status start_contacts(context::StepContext& ctx, Phase phase) noexcept;

/// Add the energy that contacts absorbed from bodies in this step to the energy account (ledger.h).
/// Call before bodies move.
void count_contact_work(context::StepContext& ctx) noexcept;

/// Store the friction memory of contacts, and the output for readers. Call before bodies move.
void remember_contacts(context::Model& model, context::State& state, runtime::Pool& pool) noexcept;

}  // namespace hawser::step
