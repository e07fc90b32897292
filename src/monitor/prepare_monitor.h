// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file prepare_monitor.h
/// Model data for the monitors: allowed gap of each row, rows that store energy, and the sampling
/// interval.

#include "context/context.h"

namespace hawser::stepper {

/// Prepare arrays for the present interactions. @throws std::bad_alloc.
void prepare_monitors(const Model& model, State& state);

}  // namespace hawser::stepper
