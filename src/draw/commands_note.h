// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file commands_note.h
/// Mark the commands of a run in pictures over time.

#include <hawser/recording.h>
#include "draw/axes.h"

#include <string>
#include <vector>

namespace hawser::draw {

/// Moment with commands.
struct Command {
    double time = 0.0;  ///< Time of the moment [s].
    /// Inputs and signals that changed: "tow_speed −0.2, winch.speed 0.5"; empty if none.
    std::string text;
    std::string
        actions{};  ///< Other actions: "cut tow at 120 m, winch.mode render"; empty if none.
};

/// Return the commands in the order of time: the first times with actions other than inputs, and
/// the first times at which only inputs changed. The last entry counts the omitted ones. Inputs
/// that systems drive are left out.
[[nodiscard]] std::vector<Command> list_commands_by_time(const record::Recording& recording);

/// Draw a dashed vertical line at the time of each command, with letters along the top of the
/// panel.
void mark_commands(Drawing& drawing, const Axes& axes, const std::vector<Command>& commands);

inline constexpr double kCommandLine = 17.0;  ///< Height of a line of list_commands [points].
/// Write the commands below the point `at`, one line each.
void list_commands(Drawing& drawing, Point at, const std::vector<Command>& commands);

}  // namespace hawser::draw
