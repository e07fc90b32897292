// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hydrostatics.h
/// Hydrostatics of hulls, for `hawser inspect --hydrostatics`.

#include <hawser/hawser.h>

namespace hawser::cli {

/// Print a table of each hull. @return false if the scene has none, which is printed.
[[nodiscard]] bool print_hydrostatics(const World& world);

}  // namespace hawser::cli
