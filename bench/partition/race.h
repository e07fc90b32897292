// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file race.h
/// Time of a partition by METIS k-way and by ours, on the same body graph.

#include "graph/partition.h"
#include "partition/cases.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <vector>

namespace hawser::bench {

/// Repeat all that follows the body graph: cost, contraction, line and parts.
void partition_again(const graph::Hypergraph& graph, int parts, graph::Partitioner& partitioner,
                     graph::Partition& out);

/// Median times of one call [s], METIS and ours alternately; METIS 0 if it is not in this build.
struct Race {
    double metis = 0.0;       ///< METIS k-way alone, repeatedly.
    double metis_turn = 0.0;  ///< METIS k-way by turns with ours.
    double ours = 0.0;        ///< From the body graph, again and again.
    double turn = 0.0;        ///< Ours, each after a call of METIS, with cold branch predictors.
    double fresh = 0.0;       ///< Ours with a new object, which has no memory yet.
    double graph = 0.0;       ///< The body graph from interactions.
    double cuts = 0.0;        ///< Cuts instead of separators, made-up weights, graph included.
};

/// @param exact  Flops of each body's pivots.
[[nodiscard]] Race race(const PartCase& c, int parts, const std::vector<std::int64_t>& exact);
nlohmann::json print_race(const Race& race);

}  // namespace hawser::bench
