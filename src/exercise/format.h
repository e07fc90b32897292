// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file format.h
/// Exercise format version 1, described as scenes are (scene/shape.h).

#include "scene/shape.h"

#include <span>

namespace hawser::exercise {

/// A whole file. What it takes over from scenes (inputs, outputs, timeline) has their shapes.
[[nodiscard]] const scene::ShapePtr& exercise_shape();
/// Words of FaultKind, in its order.
[[nodiscard]] std::span<const char* const> fault_words() noexcept;
/// Words of EventKind, in its order.
[[nodiscard]] std::vector<std::string> event_words();

}  // namespace hawser::exercise
