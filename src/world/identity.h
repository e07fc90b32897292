// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file identity.h
/// What a world must be for a snapshot to belong to it.

#include <hawser/def.h>
#include <hawser/shapes.h>

#include "context/context.h"

#include <cstdint>
#include <vector>

namespace hawser::world {

/// Everything that must agree for the bytes to mean the same thing.
[[nodiscard]] std::uint64_t layout_of(const stepper::StepContext& ctx, std::size_t inputs);

/// What the bodies, interactions, inputs and settings are, apart from what is part of the state: a
/// run goes on bit for bit with the same parameters only. Left out are parameters that inputs
/// drive, applied forces, the number of threads, and the form, whose results agree to round-off.
[[nodiscard]] std::uint64_t parameters_of(const stepper::StepContext& ctx,
                                          const std::vector<InputDef>& inputs,
                                          const std::vector<ShapeDef>& shapes);

}  // namespace hawser::world
