// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file view.h
/// Provide the arrays of a step to kernels.

#include "context/context.h"

namespace hawser::context {

/// Return a view of all bodies and interactions, with the loads of systems on bodies.
[[nodiscard]] assembly::View view(StepContext& ctx) noexcept;

/// Return a view without the couplings by loads of systems (View::coupled), for code that reads
/// rows and velocities. Kernels for body terms and for the matrix use view().
[[nodiscard]] assembly::View row_view(Model& model) noexcept;

}  // namespace hawser::context
