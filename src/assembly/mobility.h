// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file mobility.h
/// How easily the bodies of a row give way.

#include "model/bodies.h"
#include "model/interactions.h"

namespace hawser::assembly {

/// Diagonal of G M⁻¹ Gᵀ for one row, from its packed Jacobian [1/kg or 1/(kg m²)].
[[nodiscard]] double mobility(const model::Bodies& bodies, const model::Interactions& in, int id,
                              int row);

}  // namespace hawser::assembly
