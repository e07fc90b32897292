// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file mobility.h
/// Mobility of the bodies of a row.

#include "model/bodies.h"
#include "model/interactions.h"

namespace hawser::assembly {

/// Return the diagonal entry of G M⁻¹ Gᵀ of one row, from its packed Jacobian [1/kg or 1/(kg m²)].
[[nodiscard]] double mobility(const model::Bodies& bodies, const model::Interactions& in, int id,
                              int row);

}  // namespace hawser::assembly
