// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file coupling_simulated.h
/// Whole steps on more threads than the machine has: replayed from the spans of one thread.

#include <hawser/schedule.h>
#include <hawser/world.h>

#include <array>

namespace hawser::bench::split {

inline constexpr std::array<int, 5> kSimulatedThreads{1, 2, 4, 8, 16};

/// Medians over the steps of a trace.
struct SimulatedStep {
    std::array<double, kSimulatedThreads.size()> ms{};  ///< By kSimulatedThreads [ms].
    double serial = 0.0;                          ///< Serial fraction of a step of one thread [1].
    std::array<double, kStageCount> serial_of{};  ///< `serial` by stage, of the mean step [1].
    std::int64_t steps = 0;
};

/// @param world  World with one thread and a trace. All loops and the code between them come from
///        its spans, so that serial code of a stage remains serial.
[[nodiscard]] SimulatedStep simulate_steps(const World& world, const PoolCosts& costs);

}  // namespace hawser::bench::split
