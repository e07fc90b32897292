// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file inspect.h
/// Read-only views of the solver for plots, reports and checks: the factored matrix, cut
/// interactions of splits, and the rows of an interaction.
///
/// The matrix is block-sparse. Its nodes are bodies, and interactions that are not condensed into
/// the blocks of their bodies (*kept* interactions). Columns that are eliminated together form a
/// *front*; the fronts form the elimination tree. Independent blocks are *islands*.

#include <hawser/def.h>
#include <hawser/id.h>
#include <hawser/interactions.h>

#include <array>
#include <cstdint>
#include <vector>

namespace hawser {

/// Node of the block graph: a body (positive pivots) or a kept interaction (negative pivots).
struct SystemNode {
    BodyId body{};                ///< Body; valid if the node is a body.
    InteractionId interaction{};  ///< Interaction; valid if the node is a kept interaction.
    std::int32_t size = 0;        ///< Number of scalars, 1-6.
    std::int32_t front = -1;      ///< Front (supernode) in which it is eliminated.
};

/// Factored matrix as a block graph with its elimination order, WorldSolverView::matrix().
struct SystemView {
    std::vector<SystemNode> nodes;         ///< Nodes of the graph.
    std::vector<std::int32_t> edge_start;  ///< Offset of the neighbours of each node in `edges`
                                           ///< (CSR), nodes + 1 entries.
    std::vector<std::int32_t> edges;       ///< Neighbours of each node, ascending, both directions.
    std::vector<std::int32_t> order;       ///< order[k]: node that is eliminated k-th.
    std::vector<std::int32_t> front_parent;  ///< Elimination tree of the fronts: parent of each, −1
                                             ///< at a root.
    std::vector<std::int32_t> front_pivots;  ///< Pivot scalars of each front.
    std::vector<std::int32_t> front_update;  ///< Update scalars of each front (rows below the
                                             ///< pivots).
    std::vector<std::int32_t> body_island;   ///< Island of each body; −1 for bodies that do not
                                             ///< move.
    std::int64_t matrix_nnz = 0;             ///< Number of scalars of the matrix, lower triangle.
    std::int64_t factor_nnz = 0;             ///< Number of scalars of the factor L.
    std::int64_t flops = 0;                  ///< Flops of one factorisation.
    std::int64_t critical_flops = 0;         ///< Flops on the longest path from a leaf to a root.
};

/// Interaction between bodies of different groups whose coupling is not exact, after the last step.
struct CutView {
    InteractionId interaction{};              ///< Interaction that is cut.
    Coupling coupling = Coupling::kinematic;  ///< Coupling of the cut.
    /// True if the cut is in effect. It has no effect if its bodies are also coupled by a contact,
    /// or by an interaction that cannot be cut.
    bool open = false;
    double momentum_defect = 0.0;  ///< Norm of the sum of the impulses on its bodies [N s].
    double residual = 0.0;  ///< Residual max |G v₊ + Σλ − c| of its rows, with the mean λ of both
                            ///< sides [m/s or rad/s].
};

/// Rows of an interaction at the present poses and velocities (interactions.h). Rows of a range,
/// motor or friction are included, also if they are inactive.
struct RowsView {
    int rows = 0, bodies = 0;  ///< Numbers of rows and of bodies.
    /// True for a velocity row, which requires G v = speed and has no violation.
    std::array<bool, kMaxInteractionRows> velocity{};
    std::array<double, kMaxInteractionRows> violation{};  ///< Violation g [m or rad].
    std::array<double, kMaxInteractionRows> speed{};      ///< Set speed of velocity rows [m/s or
                                                          ///< rad/s].
    /// Rate G v of each row, including prescribed velocities [m/s or rad/s].
    std::array<double, kMaxInteractionRows> rate{};
    /// Compliance ε [m/N, rad/(N m)], or γ of velocity rows [m/s/N, rad/s/(N m)], that steps use.
    std::array<double, kMaxInteractionRows> compliance{};
    std::array<double, kMaxInteractionRows> damping_time{};  ///< Damping time τ that steps use [s].
    /// Jacobian G by body, row and component: three of the velocity of the centre of mass, then
    /// three of the angular velocity, world frame. Scalar body: the first component only.
    std::array<std::array<std::array<double, 6>, kMaxInteractionRows>, kMaxInteractionBodies>
        jacobian{};
};

}  // namespace hawser
