// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file view.h
/// The arrays of a step as kernels see them.

#include "context/context.h"

namespace hawser::stepper {

/// Of all bodies and interactions, with what systems load bodies with.
[[nodiscard]] assembly::View view(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
