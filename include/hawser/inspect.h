// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file inspect.h
/// Read-only picture of the system that the last analysis produced, for plots and reports, and of
/// the rows of an interaction, for checks of a start.

#include <hawser/def.h>
#include <hawser/id.h>
#include <hawser/interactions.h>

#include <array>
#include <cstdint>
#include <vector>

namespace hawser {

/// One node of the block graph: a body (positive pivots) or a kept interaction (negative).
struct SystemNode {
    BodyId body{};                ///< Valid for a body …
    InteractionId interaction{};  ///< … or for a kept interaction.
    std::int32_t size = 0;        ///< Scalars, 1-6.
    std::int32_t front = -1;      ///< Front (supernode) in which it is eliminated.
};

/// The factored matrix as a block graph with its elimination order.
struct SystemView {
    std::vector<SystemNode> nodes;
    std::vector<std::int32_t> edge_start;  ///< nodes + 1 offsets into `edges` (CSR).
    std::vector<std::int32_t> edges;       ///< Neighbours of each node, ascending, both directions.
    std::vector<std::int32_t> order;       ///< order[k] = node eliminated k-th.
    std::vector<std::int32_t> front_parent;  ///< Elimination tree of the fronts; −1 at a root.
    std::vector<std::int32_t> front_pivots;  ///< Pivot scalars of each front.
    std::vector<std::int32_t> front_update;  ///< Update scalars (rows below the pivots).
    std::vector<std::int32_t> body_island;  ///< Island of each body; −1 for those that do not move.
    std::int64_t matrix_nnz = 0;            ///< Scalars of the lower triangle.
    std::int64_t factor_nnz = 0;            ///< Scalars of L.
    std::int64_t flops = 0;                 ///< Of one factorisation.
    std::int64_t critical_flops = 0;        ///< On the longest path from a leaf to a root.
};

/// An interaction between groups that is not coupled exactly, as the last step left it.
struct CutView {
    InteractionId interaction{};
    Coupling coupling = Coupling::kinematic;
    /// Whether it is in force. A cut is not made where its bodies hold to each other in another
    /// way, through a contact or an interaction that cannot be cut.
    bool open = false;
    double momentum_defect = 0.0;  ///< ‖Σ of the impulses on its bodies‖ [N s].
    double residual = 0.0;         ///< max |G v₊ + Σλ − c|, λ the mean of the sides [m/s or rad/s].
};

/// Rows of an interaction at the present poses and velocities (interactions.h). Those of a range, a
/// motor or friction are there whether or not they act at the moment.
struct RowsView {
    int rows = 0, bodies = 0;
    /// Of a velocity row: it wants G v = speed, and has no violation.
    std::array<bool, kMaxInteractionRows> velocity{};
    std::array<double, kMaxInteractionRows> violation{};  ///< g [m or rad].
    std::array<double, kMaxInteractionRows> speed{};      ///< Of velocity rows [m/s or rad/s].
    /// G v, bodies with a prescribed velocity included [m/s or rad/s].
    std::array<double, kMaxInteractionRows> rate{};
    std::array<double, kMaxInteractionRows> compliance{};    ///< ε, or γ, in force.
    std::array<double, kMaxInteractionRows> damping_time{};  ///< τ in force [s].
    /// G by body and row: of the velocity of its centre of mass, then of its angular velocity, in
    /// the world's axes; of a scalar body the first entry.
    std::array<std::array<std::array<double, 6>, kMaxInteractionRows>, kMaxInteractionBodies>
        jacobian{};
};

}  // namespace hawser
