// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file partition.h
/// Partition of a world's bodies into parts of about equal cost, for parallel computation
/// (docs/partition.md).
///
/// ```
///     separators:   part 0 │ separator │ part 1       bodies between parts belong to none, and the
///                                                     solution is exact
///     cuts:         part 0 ┼ part 1                   each body belongs to a part; interactions
///                                                     between parts (┼) are cut, and their
///                                                     coupling is approximate
/// ```
/// Costs are flops of the factorisation. Weights of cuts follow from the forces and velocities of
/// the interactions in the last step.

#include <hawser/id.h>

#include <cstdint>
#include <vector>

namespace hawser {

/// Purpose of a partition.
enum class PartitionUse : std::uint8_t {
    separators,  ///< Exact solution with bodies between the parts.
    cuts         ///< Approximate coupling with interactions between the parts.
};

/// Input of a partition.
struct PartitionRequest {
    PartitionUse use = PartitionUse::separators;  ///< Purpose.
    /// Number of parts, ≥ 1. The result depends on it, but not on the number of threads. With few
    /// bodies some parts are empty.
    int parts = 4;
    /// True: balance by the exact flops of the last analysis. False: by the model of graph/cost.h.
    bool exact_cost = true;
    /// For cuts: requested part of each body; −1: no request. Empty: no requests.
    std::vector<std::int32_t> group{};
    /// Earlier partition with equal `use`, to update instead of computing a new one; null: none.
    /// Parts keep their bodies. For cuts, at most one cut moves, if the gain justifies it. For
    /// separators, bodies that new contacts require are added, and unnecessary ones are removed. If
    /// this is insufficient, a new partition is computed: see PartitionView::followed.
    const struct PartitionView* before = nullptr;
};

/// Interaction between two parts, with the values of the last step from which its weight follows.
struct CutInteraction {
    InteractionId interaction{};     ///< Interaction.
    double force = 0.0;              ///< Largest |force| of its rows in the last step [N or N m].
    double net_force = 0.0;          ///< Largest net force of all rows on one of its bodies [N].
    double relative_velocity = 0.0;  ///< Sum Σ|G v| over its rows [m/s and rad/s].
    double violation = 0.0;          ///< Sum Σ|g| over its rows [m and rad].
    double weight = 0.0;             ///< Weight of the cut from these values [1].
};

/// Partition with its costs.
struct PartitionView {
    int parts = 0;                           ///< Number of parts.
    std::vector<std::int32_t> part_of_body;  ///< Part of each body. −1: it does not move, or
                                             ///< sleeps; −2: it is in the separator.
    std::vector<BodyId> separator;           ///< Bodies between parts, ascending.
    int separator_scalars = 0;               ///< Degrees of freedom of the separator bodies.
    std::vector<CutInteraction> cuts;        ///< Cuts, ascending.
    std::vector<double> part_cost;           ///< Cost of each part [flop].
    double separator_cost = 0.0;             ///< Cost of the separators [flop].
    double largest_cluster = 0.0;            ///< Largest cost of an indivisible cluster [flop].
    double imbalance = 1.0;                  ///< Cost of the largest part over the mean [1].
    PartitionUse use = PartitionUse::separators;  ///< Purpose, as requested.
    /// True if the partition is an update of PartitionRequest::before. False if it was computed
    /// anew, for one of these reasons:
    /// - there was no earlier partition, or the bodies or the number of parts changed;
    /// - cuts: an indivisible cluster lies in two parts;
    /// - cuts: the largest part exceeded 1.15 times that of a new partition 30 times in succession;
    /// - separators: more than a twentieth of the interactions and contacts changed;
    /// - separators: the cost ratio exceeds 1.15 `makespan_new`.
    bool followed = false;
    int worse_for = 0;  ///< Number of successive updates that kept the cuts although a new
                        ///< partition is better.
    /// Cost ratio of the last partition that was computed anew [1]: cost of the largest part and
    /// the separators over the total cost.
    double makespan_new = 0.0;
    std::vector<double> island_cost;  ///< Cost c = Σ n_b² + Σ l_i of each island, as in the paper.
    double graph_seconds = 0.0;       ///< Time to build the graph from the model [s].
    double weight_seconds = 0.0;      ///< Time to compute the weights of cuts [s].
    double partition_seconds = 0.0;   ///< Time to compute costs and parts [s].
};

}  // namespace hawser
