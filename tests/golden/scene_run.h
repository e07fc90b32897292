// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file scene_run.h
/// Runs a scene with a fixed sequence of input values.

#include "golden/figures.h"

namespace hawser::golden {

/// Return the number of steps of a scene whose entry in the file has none: 4 s, or fewer steps if
/// the scene has many bodies.
[[nodiscard]] int default_steps(const World& world);

/// Run the steps on one thread and return the figures. After a quarter of the steps all inputs of
/// the scene and its systems start to change. A failed step ends the run.
[[nodiscard]] Figures run_scene(scene::Scene scene, int steps);

}  // namespace hawser::golden
