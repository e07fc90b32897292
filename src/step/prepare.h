// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file prepare.h
/// Preparation of an analysed system from the user's definitions.

#include "context/context.h"

namespace hawser::step {

/// Analyse if the topology has changed, and reserve all memory.
/// @throws std::bad_alloc.
void prepare(context::StepContext& ctx);

/// Do parts of the preparation for a restored model (model_undo.h): collider and blocks of
/// contacts, and after the analysis all data sized by the model.
/// @throws std::bad_alloc.
assembly::Contacts::Blocks prepare_touching(context::StepContext& ctx);
void finish_preparing(context::StepContext& ctx);

}  // namespace hawser::step
