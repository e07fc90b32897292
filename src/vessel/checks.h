// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file checks.h
/// Check the definition of a vessel. Errors name the field.

#include <hawser/vessel.h>

namespace hawser::vessel {

/// Check the definition of a vessel. @throws DefError "vessel 'NAME': field: reason".
void check_vessel(const World& world, const VesselDef& def);

}  // namespace hawser::vessel
