// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file control_ranges.h
/// Ranges of the inputs that a control file sets.
#include <hawser/scene.h>

#include "record/control.h"

#include <cstddef>
#include <vector>

namespace hawser::session {

/// Values that a control file may contain: of inputs of the world by their index, then of those
/// that signal_names() lists. Inputs of the world are clamped to narrower ranges of their own as
/// the run goes on.
[[nodiscard]] std::vector<record::ControlRange> control_ranges(const scene::Scene& scene,
                                                               std::size_t places);

}  // namespace hawser::session
