// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file control_ranges.h
/// Ranges of the inputs that a control file sets.
#include <hawser/scene.h>

#include "record/control.h"

#include <cstddef>
#include <vector>

namespace hawser::session {

/// Return the ranges of values that a control file may contain. The inputs of the world are first,
/// by index, followed by the signals of signal_names(). During the run the world also clamps its
/// inputs to their ranges, which may be narrower.
[[nodiscard]] std::vector<record::ControlRange> control_ranges(const scene::Scene& scene,
                                                               std::size_t places);

}  // namespace hawser::session
