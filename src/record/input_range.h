// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file input_range.h
/// Check a value for an input or a signal of a scene.
#include <hawser/scene.h>

#include <string_view>

namespace hawser::record {

/// Check the value of an input. @throws DefError with input, value, range and unit if the value is
/// not finite or outside the range. An unknown name passes: Session::set_input() rejects it.
void check_input_range(const scene::Scene& scene, std::string_view name, double value);

}  // namespace hawser::record
