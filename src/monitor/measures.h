// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file measures.h
/// Samples for the monitors: energies and extrema of a state, summed over chunks in their order.

#include "context/context.h"
#include "context/monitor_data.h"

namespace hawser::monitor {

/// Time of the velocities: at the poses, or half a step before them.
enum class SampleTime { pose, half_step };

/// Sample energies and extrema of the state, whose rows have been evaluated. The result does not
/// depend on threads.
[[nodiscard]] context::MonitorPart sample(context::Model& model, context::State& state,
                                          runtime::Pool& pool, SampleTime when) noexcept;

/// Write the violations of the rows of springs at the present poses into `gaps`, by row.
void read_spring_gaps(context::Model& model, const context::State& state, double* gaps) noexcept;

/// Return the additional energy of springs due to the position projection [J]. Energies are
/// evaluated half a step before the poses, extrapolated by the velocities. At that time
/// only half of the projection counts, but the poses contain all of it. @param before  Result of
/// read_spring_gaps() before the projection.
[[nodiscard]] double held_by_closing(context::Model& model, const context::State& state,
                                     const double* before) noexcept;

}  // namespace hawser::monitor
