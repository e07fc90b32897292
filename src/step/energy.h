// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file energy.h
/// The ledger of energy as users see it.

#include "context/context.h"

namespace hawser::stepper {

/// Energy at the half-step position, see hawser::Energy.
[[nodiscard]] Energy energy(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
