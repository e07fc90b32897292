// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file partition.h
/// How a world's bodies fall into parts that can be worked on side by side.

#include <hawser/id.h>

#include <cstdint>
#include <vector>

namespace hawser {

/// What a partition is for.
enum class PartitionUse : std::uint8_t {
    separators,  ///< The exact solution: bodies between parts are in none.
    cuts         ///< Approximate couplings: each body in a part, interactions between them cut.
};

struct PartitionRequest {
    PartitionUse use = PartitionUse::separators;
    int parts = 4;  ///< At least 1. The result depends on it, never on a number of threads.
    /// Balance by the exact flops of the last analysis instead of the model of graph/cost.h.
    bool exact_cost = true;
    /// Part of each body asked for by hand, −1: none; empty: none at all. For cuts.
    std::vector<std::int32_t> group{};
};

/// An interaction between two parts.
struct CutInteraction {
    InteractionId interaction{};
    double force = 0.0;              ///< Largest |force| of its rows in the last step [N or N m].
    double net_force = 0.0;          ///< Largest net force of all rows on one of its bodies [N].
    double relative_velocity = 0.0;  ///< Σ|G v| of its rows [m/s and rad/s].
    double violation = 0.0;          ///< Σ|g| of its rows [m and rad].
    double weight = 0.0;             ///< What a cut costs by these, see docs/partition.md [1].
};

struct PartitionView {
    int parts = 0;
    std::vector<std::int32_t> part_of_body;  ///< −1: does not move (or sleeps); −2: between parts.
    std::vector<BodyId> separator;           ///< Bodies between parts, ascending.
    int separator_scalars = 0;               ///< Their degrees of freedom.
    std::vector<CutInteraction> cuts;        ///< Ascending.
    std::vector<double> part_cost;           ///< By part [flop].
    double separator_cost = 0.0;             ///< [flop].
    double largest_cluster = 0.0;            ///< Dearest thing that stays whole [flop].
    double imbalance = 1.0;                  ///< Largest part over the mean [1].
    std::vector<double> island_cost;  ///< c = Σ n_b² + Σ l_i of each island, as the paper has it.
    double graph_seconds = 0.0;       ///< Reading the model into integers [s].
    double weight_seconds = 0.0;      ///< Weights from forces, velocities and violations [s].
    double partition_seconds = 0.0;   ///< Cost, units, line, parts [s].
};

}  // namespace hawser
