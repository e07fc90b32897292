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
    /// At least 1. The result depends on it, never on a number of threads. Some stay empty where
    /// there are few bodies: docs/partition.md.
    int parts = 4;
    /// Balance by the exact flops of the last analysis instead of the model of graph/cost.h.
    bool exact_cost = true;
    /// Part of each body asked for by hand, −1: none; empty: none at all. For cuts.
    std::vector<std::int32_t> group{};
    /// Go on from this one, of an earlier state, instead of making a new one: parts stay where they
    /// are. Cuts: at most one moves, for a gain that is worth it. Separators: those that new
    /// contacts make necessary come, others go. Made anew all the same where that does not do: see
    /// PartitionView::followed. Of the same use; null: none.
    const struct PartitionView* before = nullptr;
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
    PartitionUse use = PartitionUse::separators;  ///< As asked for.
    /// Whether it goes on from PartitionRequest::before. Not where bodies or the number of parts
    /// are others; cuts: where something that must stay whole lies in two parts, or the largest
    /// part was above 1.15 times that of a new partition 30 times running; separators: where more
    /// than a twentieth of the interactions and contacts changed, or the largest part and all
    /// separators together are more than 1.15 times makespan_new of all.
    bool followed = false;
    int worse_for = 0;  ///< Times running that cuts were kept though a new one is better.
    /// Cost of largest part and separators together over that of all, when last made anew [1].
    double makespan_new = 0.0;
    std::vector<double> island_cost;  ///< c = Σ n_b² + Σ l_i of each island, as the paper has it.
    double graph_seconds = 0.0;       ///< Reading the model into integers [s].
    double weight_seconds = 0.0;      ///< Weights from forces, velocities and violations [s].
    double partition_seconds = 0.0;   ///< Cost, units, line, parts [s].
};

}  // namespace hawser
