// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file curve_plots.h
/// Displays of an exercise over time.

#include <hawser/exercise.h>
#include "draw/drawing.h"

#include <optional>

namespace hawser::debrief {

/// A panel a display, of at most twelve, with the limits that the exercise compares it with.
/// @return nothing where there are none.
[[nodiscard]] std::optional<draw::Drawing> plot_curves(const exercise::Exercise& exercise,
                                                       const exercise::Result& result,
                                                       const exercise::Curves& curves);

}  // namespace hawser::debrief
