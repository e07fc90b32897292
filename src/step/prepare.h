// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file prepare.h
/// From what a user has defined to a system that steps can be taken with.

#include "context/context.h"

namespace hawser::stepper {

/// Analyse when the topology changed and reserve all memory. @throws std::bad_alloc.
void prepare(StepContext& ctx);

}  // namespace hawser::stepper
