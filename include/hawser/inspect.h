// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file inspect.h
/// Read-only views for plots, reports and checks: the system of the last analysis, and the rows of
/// an interaction.

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

/// Factored matrix as a block graph with its elimination order.
struct SystemView {
    std::vector<SystemNode> nodes;
    std::vector<std::int32_t> edge_start;  ///< nodes + 1 offsets into `edges` (CSR).
    std::vector<std::int32_t> edges;       ///< Neighbours of each node, ascending, both directions.
    std::vector<std::int32_t> order;       ///< order[k] = node eliminated k-th.
    std::vector<std::int32_t> front_parent;  ///< Elimination tree of the fronts: parent of each, −1
                                             ///< at a root.
    std::vector<std::int32_t> front_pivots;  ///< Pivot scalars of each front.
    std::vector<std::int32_t> front_update;  ///< Update scalars of each front (rows below the
                                             ///< pivots).
    std::vector<std::int32_t> body_island;   ///< Island of each body; −1 for bodies that do not
                                             ///< move.
    std::int64_t matrix_nnz = 0;             ///< Scalars of the lower triangle.
    std::int64_t factor_nnz = 0;             ///< Scalars of L.
    std::int64_t flops = 0;                  ///< Flops of one factorisation.
    std::int64_t critical_flops = 0;         ///< Flops on the longest path from a leaf to a root.
};

/// Interaction between groups without exact coupling, after the last step.
struct CutView {
    InteractionId interaction{};              ///< Interaction of the cut.
    Coupling coupling = Coupling::kinematic;  ///< Coupling of the cut.
    /// True if the cut is in effect. Bodies that are also coupled by a contact, or by an
    /// interaction that cannot be cut, have no cut.
    bool open = false;
    double momentum_defect = 0.0;  ///< ‖Σ of the impulses on its bodies‖ [N s].
    double residual = 0.0;  ///< max |G v₊ + Σλ − c|, λ the mean of both sides [m/s or rad/s].
};

/// Rows of an interaction at the present poses and velocities (interactions.h). Rows of a range,
/// motor or friction are included whether or not they are active.
struct RowsView {
    int rows = 0, bodies = 0;  ///< Numbers of rows and bodies.
    /// True for a velocity row, which requires G v = speed and has no violation.
    std::array<bool, kMaxInteractionRows> velocity{};
    std::array<double, kMaxInteractionRows> violation{};  ///< Violation g [m or rad].
    std::array<double, kMaxInteractionRows> speed{};      ///< Set speed of velocity rows [m/s or
                                                          ///< rad/s].
    /// G v, prescribed velocities included [m/s or rad/s].
    std::array<double, kMaxInteractionRows> rate{};
    std::array<double, kMaxInteractionRows> compliance{};    ///< ε, or γ, in use [m/N, rad/(N m);
                                                             ///< m/s/N, rad/s/(N m)].
    std::array<double, kMaxInteractionRows> damping_time{};  ///< τ in use [s].
    /// G by body and row, for the velocity of the centre of mass, then the angular velocity, world
    /// axes. Scalar body: the first entry.
    std::array<std::array<std::array<double, 6>, kMaxInteractionRows>, kMaxInteractionBodies>
        jacobian{};
};

}  // namespace hawser
