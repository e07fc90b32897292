// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file coupling_simulated.h
/// Simulate whole steps on more threads than the machine has, from the spans of one thread.

#include <hawser/experimental/schedule.h>
#include <hawser/world.h>

#include <array>

namespace hawser::bench::split {

inline constexpr std::array<int, 5> kSimulatedThreads{1, 2, 4, 8, 16};

/// Medians over the steps of a trace.
struct SimulatedStep {
    std::array<double, kSimulatedThreads.size()> ms{};  ///< By kSimulatedThreads [ms].
    double serial = 0.0;  ///< Fraction of one thread's step that no other thread can execute [1].
    std::array<double, kStageCount> serial_of{};  ///< `serial` by stage, in the mean step [1].
    std::int64_t steps = 0;
};

/// Simulate steps. Loops and the code between them come from the spans, so that serial parts of any
/// stage stay serial. @param world  Has one thread and was traced.
[[nodiscard]] SimulatedStep simulate_steps(const World& world, const PoolCosts& costs);

}  // namespace hawser::bench::split
