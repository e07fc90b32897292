// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file judge_prepare.h
/// What judges need to know of a model: how far each row may be open, which rows hold energy, and
/// how often to look.

#include "context/context.h"

namespace hawser::stepper {

/// Arrays for the interactions there are. @throws std::bad_alloc.
void prepare_judge(const Model& model, State& state);

}  // namespace hawser::stepper
