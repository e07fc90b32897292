// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file input_range.h
/// Checks a value for an input or a signal of a scene.
#include <hawser/scene.h>

#include <string_view>

namespace hawser::record {

/// @throws DefError that names input, value, range and unit if the value is not finite or outside
/// the range. A name that the scene does not have passes: Session::set_input() refuses it.
void check_input_range(const scene::Scene& scene, std::string_view name, double value);

}  // namespace hawser::record
