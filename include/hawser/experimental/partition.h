// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file partition.h
/// Partition of a world's bodies into parts for parallel computation.

#include <hawser/id.h>

#include <cstdint>
#include <vector>

namespace hawser {

/// Purpose of a partition.
enum class PartitionUse : std::uint8_t {
    separators,  ///< Exact solution: bodies between parts belong to none.
    cuts  ///< Approximate coupling: each body belongs to a part, and interactions between parts are
          ///< cut.
};

/// Input of a partition.
struct PartitionRequest {
    PartitionUse use = PartitionUse::separators;
    /// Number of parts, ≥ 1. The result depends on it, but not on the number of threads. With few
    /// bodies some parts are empty (docs/partition.md).
    int parts = 4;
    /// True: balance by the exact flops of the last analysis. False: by the model of graph/cost.h.
    bool exact_cost = true;
    /// For cuts: requested part of each body, −1: none. Empty: no requests.
    std::vector<std::int32_t> group{};
    /// Earlier partition of equal use to update; null: none. Parts keep their bodies. For cuts, at
    /// most one cut moves if the gain justifies it. For separators, those that new contacts require
    /// are added, others are removed. A new partition is computed if the update is insufficient;
    /// see PartitionView::followed.
    const struct PartitionView* before = nullptr;
};

/// Interaction between two parts.
struct CutInteraction {
    InteractionId interaction{};
    double force = 0.0;              ///< Largest |force| of its rows in the last step [N or N m].
    double net_force = 0.0;          ///< Largest net force of all rows on one of its bodies [N].
    double relative_velocity = 0.0;  ///< Sum Σ|G v| over its rows [m/s and rad/s].
    double violation = 0.0;          ///< Sum Σ|g| over its rows [m and rad].
    double weight = 0.0;  ///< Cost of a cut from these values, see docs/partition.md [1].
};

/// Partition with its costs.
struct PartitionView {
    int parts = 0;
    std::vector<std::int32_t> part_of_body;  ///< Part of each body. −1: does not move, or sleeps;
                                             ///< −2: between parts.
    std::vector<BodyId> separator;           ///< Bodies between parts, ascending.
    int separator_scalars = 0;               ///< Degrees of freedom of the separator bodies.
    std::vector<CutInteraction> cuts;        ///< Cuts, ascending.
    std::vector<double> part_cost;           ///< Cost of each part [flop].
    double separator_cost = 0.0;             ///< Cost of the separators [flop].
    double largest_cluster = 0.0;            ///< Largest cost of an indivisible cluster [flop].
    double imbalance = 1.0;                  ///< Largest part over the mean [1].
    PartitionUse use = PartitionUse::separators;  ///< Use as requested.
    /// True if the partition updates PartitionRequest::before. False if the bodies or the number of
    /// parts changed. For cuts also false if an indivisible cluster lies in two parts. The same
    /// applies if the largest part exceeded 1.15 times that of a new partition 30 times in
    /// succession. For separators also false if more than a twentieth of the interactions and
    /// contacts changed, or if the cost ratio exceeds 1.15 makespan_new.
    bool followed = false;
    int worse_for = 0;  ///< Number of successive updates that kept the cuts although a new
                        ///< partition is better.
    /// Cost of the largest part and the separators over the total cost, when last computed anew
    /// [1].
    double makespan_new = 0.0;
    std::vector<double> island_cost;  ///< c = Σ n_b² + Σ l_i of each island, as in the paper.
    double graph_seconds = 0.0;       ///< Time to read the model into integers [s].
    double weight_seconds = 0.0;     ///< Time of the weights from forces, velocities and violations
                                     ///< [s].
    double partition_seconds = 0.0;  ///< Time of cost, units, line and parts [s].
};

}  // namespace hawser
