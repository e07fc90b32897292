// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file commands_note.h
/// What was commanded in a run, in pictures over time.

#include <hawser/recording.h>
#include "draw/axes.h"

#include <string>
#include <vector>

namespace hawser::draw {

/// A moment at which inputs changed.
struct Command {
    double time = 0.0;  ///< [s]
    std::string text;   ///< E.g. "tow_speed −0.2, thrust_y 2e+05".
};

/// The first moments, and in the last entry's text how many more there were.
[[nodiscard]] std::vector<Command> commands_of(const record::Recording& recording);

/// A dashed line at each moment, numbered along the top of the panel.
void mark_commands(Drawing& drawing, const Axes& axes, const std::vector<Command>& commands);

inline constexpr double kCommandLine = 17.0;  ///< Height of a line of list_commands [points].
/// One line a moment, below `at`.
void list_commands(Drawing& drawing, Point at, const std::vector<Command>& commands);

}  // namespace hawser::draw
