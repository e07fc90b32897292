// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file bearing.h
/// Checks of the material limits of lines in every step (monitor.h). They run before an element
/// breaks in the step, because broken elements are no longer checked.

#include "context/context.h"
#include "context/monitor_data.h"

namespace hawser::monitor {

/// Check the strain of elements with a breaking load, from the tension in this step and the length
/// at its start. Failed: the strain exceeds kMostStrain and kMostBreaking times the strain at the
/// breaking load. Suspect: in three steps the element is 25 % longer than at the breaking load,
/// without breaking. Finding::value is minus the strain.
[[nodiscard]] Finding strain_finding(context::Model& model, const context::State& state,
                                     context::MonitorState& memory) noexcept;

/// Check for elements at slides whose length is negative in three consecutive steps: the slide has
/// hauled in more wire than the element contained. An element at a drum does not reach this state
/// (kLeastOfDrumElement). Finding::value is the length [m].
[[nodiscard]] Finding wound_finding(const context::Model& model, const context::State& state,
                                    context::MonitorState& memory) noexcept;

}  // namespace hawser::monitor
