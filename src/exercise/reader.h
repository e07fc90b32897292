// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file reader.h
/// From the document to an exercise, and what of it the scene has to have.

#include <hawser/exercise.h>

#include "scene/read_json.h"

#include <string>

namespace hawser::exercise {

/// @param root  That fits exercise_shape(). @throws scene::SceneError where a name is given twice,
/// or names nothing of the exercise.
[[nodiscard]] Exercise read_exercise(const scene::Json& root, const scene::Place& place);

/// Of a document alone, without its scene. @throws scene::SceneError.
[[nodiscard]] Exercise parse_exercise(const std::string& text, const std::string& name);

/// Whether the scene has all that it names. @throws scene::SceneError with the nearest name.
void check_names(const Exercise& exercise, const scene::Scene& scene, const scene::Place& place);

/// Inputs that faults need and the scene lacks, as a scene has them.
[[nodiscard]] scene::Json missing_inputs(const Exercise& exercise, const World& world);

}  // namespace hawser::exercise
