// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file contact_rows.h
/// Contacts as rows: their relative velocities, impulses, and what those do to bodies.

#include "context/context.h"

namespace hawser::stepper {

/// u, λ and the impulses on slots. @param v  As of update_contacts().
void update_slots(Model& model, runtime::Pool& pool, const double* v) noexcept;

/// Impulses of contacts at velocities v (null: at rest), and their sums by body.
void update_contacts(Model& model, runtime::Pool& pool, const double* v) noexcept;

}  // namespace hawser::stepper
