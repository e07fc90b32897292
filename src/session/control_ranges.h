// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file control_ranges.h
/// Ranges of the inputs that a control file sets.
#include <hawser/scene.h>

#include "record/control.h"

#include <cstddef>
#include <vector>

namespace hawser::session {

/// Return the ranges of values that a control file may contain. First come the world's inputs by
/// index, then the signals of signal_names(). The world also clamps its inputs to their own
/// narrower ranges during the run.
[[nodiscard]] std::vector<record::ControlRange> control_ranges(const scene::Scene& scene,
                                                               std::size_t places);

}  // namespace hawser::session
