// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file contact_rows.h
/// Contacts as rows: their relative velocities, impulses, and the effect on bodies.

#include "context/context.h"

namespace hawser::solve {

/// Compute u, λ and the impulses on the slots of contacts.
/// @param v  As for update_contacts().
void update_slots(context::Model& model, runtime::Pool& pool, const double* v) noexcept;

/// Compute the contact impulses at velocities v (null: zero), and their sums by body.
void update_contacts(context::Model& model, runtime::Pool& pool, const double* v) noexcept;

}  // namespace hawser::solve
