// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file figure_timelines.h
/// Steps of a scene run in the ways that the paper's Fig. 2 compares.

#include "draw/figures/timelines.h"
#include "figure_panels.h"
#include "scene_options.h"

#include <vector>

namespace hawser::cli {

struct TimelineRun {
    double at = 1.0;    ///< From here on steps are traced [s].
    int threads = 2;    ///< Of the parallel runs.
    int simulated = 4;  ///< Threads that are simulated.
    int parts = 4;      ///< Of the split.
};

/// Each runs the scene anew. @throws std::runtime_error where a step fails.
[[nodiscard]] std::vector<draw::NamedTimeline> run_timelines(SceneOptions options,
                                                             const TimelineRun& run);

[[nodiscard]] Panel timeline_panel(const std::string& name, const std::string& title,
                                   const std::vector<draw::NamedTimeline>& timelines);

}  // namespace hawser::cli
