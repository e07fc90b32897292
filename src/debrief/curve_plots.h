// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file curve_plots.h
/// Plot the displays of an exercise over time.

#include <hawser/exercise.h>
#include "draw/drawing.h"

#include <optional>

namespace hawser::debrief {

/// Draw one panel for each display, at most twelve, with the limits of the exercise for it. @return
/// no value if there are no displays or fewer than two samples.
[[nodiscard]] std::optional<draw::Drawing> plot_curves(const exercise::Exercise& exercise,
                                                       const exercise::Result& result,
                                                       const exercise::Curves& curves);

}  // namespace hawser::debrief
