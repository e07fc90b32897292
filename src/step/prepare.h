// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file prepare.h
/// Preparation of an analysed system from the user's definitions.

#include "context/context.h"

namespace hawser::step {

/// Analyse if the topology has changed, and reserve all memory.
/// @throws std::bad_alloc.
void prepare(context::StepContext& ctx);

/// Prepare the parts of a restored model (model_undo.h) that the undo copy does not contain:
/// collider and blocks of contacts, and after the analysis all arrays sized by the model.
/// @throws std::bad_alloc.
assembly::Contacts::Blocks prepare_touching(context::StepContext& ctx);
void finish_preparing(context::StepContext& ctx);

}  // namespace hawser::step
