// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file checks.h
/// Refusals of a vessel's definition, by its field.

#include <hawser/vessel.h>

namespace hawser::vessel {

/// @throws DefError "vessel 'NAME': field: reason".
void check_vessel(const World& world, const VesselDef& def);

}  // namespace hawser::vessel
