// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file scene_run.h
/// Runs a scene with a fixed sequence of input values.

#include "golden/figures.h"

namespace hawser::golden {

/// Steps of the run of a scene whose entry in the file names none: 4 s, or fewer steps if the scene
/// has many bodies.
[[nodiscard]] int default_steps(const World& world);

/// Take the steps on one thread and return the figures. After a quarter of the steps all inputs of
/// the scene and its systems start to change. A step that fails ends the run.
[[nodiscard]] Figures run_scene(scene::Scene scene, int steps);

}  // namespace hawser::golden
