// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file world_solver.h
/// Solver of a world, World::solver(). It provides the matrix and rows of the last step for plots,
/// reports and checks, the allocated memory, the degradation of a step, and the trace of its
/// threads (trace.h).

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

    /// Return the factored matrix as a graph with its elimination order (inspect.h). The model is
    /// analysed first if it has changed.
    /// @throws UseError, std::bad_alloc, LimitError.
    [[nodiscard]] SystemView matrix() const;
    /// Return the rows of an interaction at the present poses and velocities (inspect.h).
    /// @throws DefError for an invalid id.
    [[nodiscard]] RowsView rows(InteractionId id) const;
    /// Return true if the last step satisfied the rows of an interaction at its end by iterations,
    /// instead of linearising them once (docs/theory/joints.md).
    /// @throws DefError for an invalid id.
    [[nodiscard]] bool completed(InteractionId id) const;
    /// Return the force of each row from which the last step computed the geometric stiffness [N or
    /// N m]. It is World::force() before that step. If the step was solved again with a larger
    /// joint force (StepStats::restiffened), it is that force. Zeros before the first step, and at
    /// indices beyond the rows.
    /// @throws DefError for an invalid id.
    [[nodiscard]] std::array<double, kMaxInteractionRows> stiffness_force(InteractionId id) const;
    /// Return the coarsening level of wires in the next step, 0 to 4 (Degradation::wires).
    [[nodiscard]] int coarsening() const noexcept;
    /// Return the allocated memory of state and solver [bytes].
    [[nodiscard]] std::size_t memory_bytes() const noexcept;
    /// Return the last steps of the trace (trace.h).
    /// @param steps  Largest number of steps.
    [[nodiscard]] TraceView trace(std::int64_t steps = 1'000'000) const;
};

/// Reads and controls the solver of a world.
class WorldSolver : public WorldSolverView {
  public:
    explicit WorldSolver(World& world) noexcept;

    /// Leave out exactly the given work in the next step, to reproduce the StepStats::degradation
    /// of another run. The step then ignores the budgets of WorldDef. A default-constructed
    /// Degradation cancels the request. Negative iterations count as 0.
    void degrade_next_step(const Degradation& degradation) noexcept;
    /// Start a trace of the activity of each thread from the next step on. An earlier trace is
    /// deleted.
    /// @param spans  Largest number of stored spans per thread; newer spans replace older ones. 0
    /// ends
    ///        the trace. A world of a thousand bodies needs a few hundred spans per step.
    /// @throws DefError above 2^28, UseError, std::bad_alloc; the present trace then continues.
    void start_trace(std::size_t spans);
};

}  // namespace hawser
