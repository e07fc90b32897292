// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file view.h
/// The arrays of a step as kernels see them.

#include "context/context.h"

namespace hawser::stepper {

/// Of all bodies and interactions, with what systems load bodies with.
[[nodiscard]] assembly::View view(StepContext& ctx) noexcept;

/// The same without what loads of systems couple (View::coupled): for what looks at rows and
/// velocities. Kernels for the terms of bodies and for the matrix take view().
[[nodiscard]] assembly::View row_view(Model& model) noexcept;

}  // namespace hawser::stepper
