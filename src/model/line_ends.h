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

}  // namespace hawser::model
