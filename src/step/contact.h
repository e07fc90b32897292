// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file contact.h
/// Contact points in a step: from collision to rows, and what they remember.

#include "context/context.h"

namespace hawser::stepper {

/// Links between bodies that may touch, for the shapes there are. Part of prepare().
/// @throws std::bad_alloc.
assembly::Contacts::Blocks prepare_contacts(Model& model, Work& work);

/// What contacts are started for.
enum class Phase : std::uint8_t {
    regular,
    stagger,  ///< The staggered start: nothing approaches or departs.
    impact,   ///< See impact.h, which sets the laws.
};

/// Rows of the contacts that stage collide found, linearised about the last step's solution.
/// Analyses the system where two bodies touch that did not before.
[[nodiscard]] Status start_contacts(StepContext& ctx, Phase phase) noexcept;

/// What contacts took from the bodies' energy in this step, before bodies move.
void count_contact_work(StepContext& ctx) noexcept;

/// What friction remembers, before bodies move; and what readers see.
void remember_contacts(Model& model, State& state, runtime::Pool& pool) noexcept;

}  // namespace hawser::stepper
