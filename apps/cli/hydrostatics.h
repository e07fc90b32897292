// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hydrostatics.h
/// What hulls do in still water, for `hawser inspect --hydrostatics`.

#include <hawser/hawser.h>

namespace hawser::cli {

/// A table of each hull. @return false where the scene has none, which has been said.
[[nodiscard]] bool print_hydrostatics(const World& world);

}  // namespace hawser::cli
