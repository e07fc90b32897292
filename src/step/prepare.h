// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file prepare.h
/// From what a user has defined to a system that steps can be taken with.

#include "context/context.h"

namespace hawser::stepper {

/// Analyse when the topology changed and reserve all memory. @throws std::bad_alloc.
void prepare(StepContext& ctx);

/// Parts of it for a model that was put back (model_undo.h). Collider and blocks of contacts; and,
/// once it is analysed, what is sized by the model. @throws std::bad_alloc.
assembly::Contacts::Blocks prepare_touching(StepContext& ctx);
void finish_preparing(StepContext& ctx);

}  // namespace hawser::stepper
