// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file line_ends.h
/// Compute the properties of a line that depend on the bodies at its ends.

#include "model/bodies.h"

#include <hawser/interactions.h>

namespace hawser::model {

/// Return the transverse mobility of the lighter end of a line [1/kg]. It assumes arms
/// perpendicular to the line. Between two rigid bodies it uses the mean inertia across the arm.
[[nodiscard]] double lightest_end(const InteractionDef& def, const Bodies& bodies);

/// Return the signed radius of the wheel under a part of a line at its first (0) or second body
/// [m]; 0: none (kinds/routes.h).
[[nodiscard]] double wheel_at(const InteractionDef& d, std::size_t slot) noexcept;

}  // namespace hawser::model
