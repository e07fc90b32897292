// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file prepare_monitor.h
/// Model data for the monitors: allowed gap of each row, rows that store energy, and the sampling
/// interval.

#include "context/context.h"

namespace hawser::monitor {

/// Prepare arrays for the present interactions. @throws std::bad_alloc.
void prepare_monitors(const context::Model& model, context::State& state);

}  // namespace hawser::monitor
