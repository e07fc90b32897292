// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file open_cuts.h
/// Which cuts are in force. A split is exact only between parts that nothing else holds together:
/// so bodies are joined over all that is not cut, and a cut whose sides come to be one part is
/// closed, until none is left to close.

#include "context/context.h"

namespace hawser::stepper {

/// Which cuts are in force: those whose sides hold to each other in no other way. Contacts and what
/// cannot be cut make two groups one part. To be called before the system is analysed.
/// @return whether others are than before.
bool open_cuts(StepContext& ctx);

/// Interfaces with a cut of Coupling::deadline in force.
[[nodiscard]] std::uint64_t open_interfaces(const StepContext& ctx) noexcept;

}  // namespace hawser::stepper
