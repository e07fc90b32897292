// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file energy_account.h
/// Energy balance of the monitors: sums, their rises and falls, and the exchanged energy
/// (monitor.h).

#include "context/monitor_data.h"

namespace hawser::monitor {

/// Rise of a sum above its minimum, and fall below its maximum [J].
struct Variation {
    double rise = 0.0, fall = 0.0;
};

/// Unexplained energy: momentary and mean.
struct Unexplained {
    context::ByAccount<Variation> now{}, mean{};
    /// Momentary value relative to the extrema of the mean: a short extremum counts by its fraction
    /// of kMean.
    context::ByAccount<Variation> lasting{};
    double posed = 0.0;  ///< Earlier value of MonitorState::posed [J].
};

/// Start the energy balances with the energy at the start of the run.
void begin_energy(const context::MonitorPart& p, const context::Works& works,
                  context::MonitorState& state) noexcept;

/// Update the energy balances with the energies and works of a sample. @param time  Time since the
/// last sample [s].
[[nodiscard]] Unexplained follow_energy(const context::MonitorPart& p, const context::Works& works,
                                        double time, context::MonitorState& state) noexcept;

}  // namespace hawser::monitor
