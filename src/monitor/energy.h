// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file energy.h
/// Energy balance in the public interface.

#include "context/context.h"

namespace hawser::monitor {

/// Compute the kinetic, potential and elastic energy half a step before the poses; see
/// hawser::Energy.
[[nodiscard]] Energy energy(context::StepContext& ctx) noexcept;

}  // namespace hawser::monitor
