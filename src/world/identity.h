// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file identity.h
/// Identity of a world, which a snapshot must match.

#include <hawser/def.h>
#include <hawser/shapes.h>

#include "context/context.h"

#include <cstdint>
#include <vector>

namespace hawser::world {

/// Return a hash of all data that determine the layout of a snapshot.
[[nodiscard]] std::uint64_t layout_of(const context::StepContext& ctx, std::size_t inputs);

/// Return a hash of the parameters of bodies, interactions, inputs and settings, without the state.
/// A run continues bit for bit only with equal parameters. Excluded are parameters driven by
/// inputs, applied forces, the number of threads, and the form, whose results agree to rounding.
[[nodiscard]] std::uint64_t parameters_of(const context::StepContext& ctx,
                                          const std::vector<BodyDef>& defs,
                                          const std::vector<InputDef>& inputs,
                                          const std::vector<ShapeDef>& shapes);

}  // namespace hawser::world
