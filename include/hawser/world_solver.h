// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file world_solver.h
/// Solver of a world: World::solver(). Views for plots, reports and checks, the cost of a step, and
/// the record of its threads.

#include <hawser/facet.h>
#include <hawser/id.h>
#include <hawser/interactions.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace hawser {

struct Degradation;  // stats.h
struct RowsView;     // inspect.h
struct SystemView;   // inspect.h
struct TraceView;    // trace.h

/// Reads the solver of a world.
class WorldSolverView : public Facet {
  public:
    explicit WorldSolverView(const World& world) noexcept : Facet(world) {}

    /// Return the factored matrix as a graph with its elimination order: inspect.h. Analyses if
    /// needed.
    /// @throws UseError, std::bad_alloc, LimitError.
    [[nodiscard]] SystemView matrix() const;
    /// Return the rows of an interaction at the present poses and velocities: inspect.h.
    /// @throws DefError for an invalid id.
    [[nodiscard]] RowsView rows(InteractionId id) const;
    /// Return true if the last step solved the rows of an interaction at the end of the step, not
    /// linearised (docs/theory/joints.md).
    /// @throws DefError for an invalid id.
    [[nodiscard]] bool completed(InteractionId id) const;
    /// Return the ratio of the free inertia of a joint's bodies to their inertia with other joints,
    /// by which the last step multiplied its oscillation number (docs/theory/joints.md). 1 if the
    /// bodies count as free.
    /// @throws DefError for an invalid id.
    [[nodiscard]] double constrained_ratio(InteractionId id) const;
    /// Return the force of each row in the geometric stiffness of the last step [N or N m]. It is
    /// World::force() before that step, or a larger one of a joint in a repeated solution
    /// (StepStats::restiffened). Zero before the first step, and beyond its rows.
    /// @throws DefError for an invalid id.
    [[nodiscard]] std::array<double, kMaxInteractionRows> stiffness_force(InteractionId id) const;
    [[nodiscard]] int coarsening() const noexcept;  ///< Degradation::wires of the next step.
    [[nodiscard]] std::size_t memory_bytes() const noexcept;  ///< Memory of state and solver.
    /// Return the last stored steps: trace.h.
    [[nodiscard]] TraceView trace(std::int64_t steps = 1'000'000) const;
};

/// Reads and controls the solver of a world.
class WorldSolver : public WorldSolverView {
  public:
    explicit WorldSolver(World& world) noexcept;

    /// Leave out exactly this in the next step, and ignore WorldDef's budgets in it: repeats
    /// StepStats::degradation. The default cancels it. Negative iterations count as 0.
    void degrade_next_step(const Degradation& degradation) noexcept;
    /// Record the activity of each thread from the next step on, up to `spans` spans per thread.
    /// 0 ends the record. A thousand bodies need a few hundred spans per step. Earlier records are
    /// dropped.
    /// @throws DefError above 2^28, UseError, std::bad_alloc; the present trace then continues.
    void start_trace(std::size_t spans);
};

}  // namespace hawser
