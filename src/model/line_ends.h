// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file line_ends.h
/// Compute the properties of a line that depend on the bodies at its ends.

#include "model/bodies.h"

#include <hawser/interactions.h>

namespace hawser::model {

/// Return the mobility of the lighter end of a line across the line [1/kg]. Arms are at their
/// longest; between two rigid bodies the mean inertia across the arm is used.
[[nodiscard]] double lightest_end(const InteractionDef& def, const Bodies& bodies);

/// Return the signed radius of the wheel under a part of a line at its first (0) or second body
/// [m]; 0: none (kinds/routes.h).
[[nodiscard]] double wheel_at(const InteractionDef& d, std::size_t slot) noexcept;

}  // namespace hawser::model
