// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file line_ends.h
/// What a line knows of the bodies at its ends.

#include "model/bodies.h"

#include <hawser/interactions.h>

namespace hawser::model {

/// How easily the lighter end of a line moves across it [1/kg]: arms at their longest, or, between
/// two rigid bodies, by the mean inertia across the arm.
[[nodiscard]] double lightest_end(const InteractionDef& def, const Bodies& bodies);

/// Signed radius of the wheel that a part of a line lies on at its first (0) or second body [m], 0:
/// none (kinds/routes.h).
[[nodiscard]] double wheel_at(const InteractionDef& d, std::size_t slot) noexcept;

}  // namespace hawser::model
