// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file commands_note.h
/// What was commanded in a run, in pictures over time.

#include <hawser/recording.h>
#include "draw/axes.h"

#include <string>
#include <vector>

namespace hawser::draw {

/// A moment at which something was commanded.
struct Command {
    double time = 0.0;  ///< [s]
    std::string text;   ///< Inputs and signals that changed: "tow_speed −0.2, winch.speed 0.5"; "".
    std::string
        done{};  ///< What else was done: "cut tow at 120 m, winch.mode render"; "": nothing.
};

/// By time: the first moments at which something was done, and the first at which inputs alone
/// changed; in the last entry how many more there were. Inputs that systems drive are left out.
[[nodiscard]] std::vector<Command> commands_of(const record::Recording& recording);

/// A dashed line at each moment, numbered along the top of the panel.
void mark_commands(Drawing& drawing, const Axes& axes, const std::vector<Command>& commands);

inline constexpr double kCommandLine = 17.0;  ///< Height of a line of list_commands [points].
/// One line a moment, below `at`.
void list_commands(Drawing& drawing, Point at, const std::vector<Command>& commands);

}  // namespace hawser::draw
