// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file timelines.h
/// Draw several steps on one time axis, one above the other, with a line for each thread.

#include "draw/drawing.h"
#include "draw/timeline.h"

#include <string>
#include <vector>

namespace hawser::draw {

struct NamedTimeline {
    std::string name;  ///< Name of the run, e.g. "Serial".
    Timeline timeline;
    std::string note;  ///< Reason if there is no timeline; empty if there is one.
};

/// Draw timelines at the width of three square panels side by side. Simulated timelines are marked
/// in their caption and in the name of every line.
[[nodiscard]] Drawing draw_timelines(const std::vector<NamedTimeline>& timelines,
                                     const std::string& title,
                                     const std::vector<std::string>& notes);

}  // namespace hawser::draw
