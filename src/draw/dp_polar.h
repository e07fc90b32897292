// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file dp_polar.h
/// Polar plot of a DP capability (hawser/dp_capability.h).

#include <hawser/dp_capability.h>

#include "draw/drawing.h"

#include <string>

namespace hawser::draw {

/// Plot the DP capability numbers over the direction of the loads, bow up: intact and of each
/// single failure.
[[nodiscard]] Drawing plot_dp_capability(const DpCapability& capability, const std::string& title,
                                         const std::string& parameters);

}  // namespace hawser::draw
