// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file dp_capability_table.h
/// DNV-ST-0111 Level 1 of ships, for `hawser inspect --dp-capability`.

#include "scene_options.h"

#include <string>

namespace hawser::cli {

struct DpOptions {
    double step_deg = 10.0;  ///< Between headings, a divisor of 30.
    bool numbers = false;    ///< Print the utilisation at each number.
};

/// Print the table of each vessel with the key `dp_capability`. @param scene  File of a scene, or
/// of one ship. @param output  SVG file, or folder; "": no plot. @return False if no vessel has the
/// key, which is printed.
[[nodiscard]] bool print_dp_capability(const SceneOptions& scene, const DpOptions& options,
                                       const std::string& output);

}  // namespace hawser::cli
