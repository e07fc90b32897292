// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file timelines.h
/// Steps beneath each other on one axis of time, a line for each thread.

#include "draw/drawing.h"
#include "draw/timeline.h"

#include <string>
#include <vector>

namespace hawser::draw {

struct NamedTimeline {
    std::string name;  ///< How it was run, e.g. "Serial".
    Timeline timeline;
    std::string note;  ///< Why there is none; "": there is.
};

/// As wide as three square panels side by side. Simulated ones say so in their caption and in the
/// name of every line.
[[nodiscard]] Drawing draw_timelines(const std::vector<NamedTimeline>& timelines,
                                     const std::string& title,
                                     const std::vector<std::string>& notes);

}  // namespace hawser::draw
