// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file predict.h
/// Where images are and how they move: where their bodies are, at the velocities that the world's
/// predictor gives (WorldDef::predictor).

#include "context/context.h"

namespace hawser::stepper {

/// Before rows are assembled: images where their bodies are, at the velocities predicted.
void predict(StepContext& ctx) noexcept;

/// Impulses of contacts in the last step, by body, for predictors.
void keep_touch(StepContext& ctx) noexcept;

/// Images where their bodies are.
void place_images(StepContext& ctx) noexcept;

}  // namespace hawser::stepper
