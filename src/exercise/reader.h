// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file reader.h
/// Read an exercise from its document, and check it against the scene.

#include <hawser/exercise.h>

#include "scene/read_json.h"

#include <string>

namespace hawser::exercise {

/// Read an exercise. @param root  Document that fits exercise_shape(). @throws scene::SceneError if
/// a name is used twice, or refers to nothing in the exercise.
[[nodiscard]] Exercise read_exercise(const scene::Json& root,
                                     const scene::SourceLocation& location);

/// Parse a document alone, without its scene. @throws scene::SceneError.
[[nodiscard]] Exercise parse_exercise(const std::string& text, const std::string& name);

/// Check that the scene has every name in use. @throws scene::SceneError with the nearest name.
void check_names(const Exercise& exercise, const scene::Scene& scene,
                 const scene::SourceLocation& location);

/// Return the inputs that faults need and the scene lacks, in the format of scenes.
[[nodiscard]] scene::Json missing_inputs(const Exercise& exercise, const World& world);

}  // namespace hawser::exercise
