// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file format.h
/// Describe exercise format version 1, in the same form as scenes (scene/shape.h).

#include "scene/shape.h"

#include <span>

namespace hawser::exercise {

/// Return the schema of an exercise file. Inputs, outputs and timeline have the schemas of scenes.
[[nodiscard]] const scene::ShapePtr& exercise_shape();
/// Return the words of FaultKind, in its order.
[[nodiscard]] std::span<const char* const> fault_words() noexcept;
/// Return the words of EventKind, in its order.
[[nodiscard]] std::vector<std::string> event_words();

}  // namespace hawser::exercise
