// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file figure_timelines.h
/// Run a scene in the variants of the paper's Fig. 2 and trace its steps.

#include "draw/figures/timelines.h"
#include "figure_panels.h"
#include "scene_options.h"

#include <vector>

namespace hawser::cli {

struct TimelineRun {
    double at = 1.0;    ///< Time from which steps are traced [s].
    int threads = 2;    ///< Number of threads of the parallel runs.
    int simulated = 4;  ///< Number of simulated threads.
    int parts = 4;      ///< Number of parts of the split.
};

/// Run the scene once for each timeline. @throws std::runtime_error if a step fails.
[[nodiscard]] std::vector<draw::NamedTimeline> run_timelines(SceneOptions options,
                                                             const TimelineRun& run);

[[nodiscard]] Panel timeline_panel(const std::string& name, const std::string& title,
                                   const std::vector<draw::NamedTimeline>& timelines);

}  // namespace hawser::cli
