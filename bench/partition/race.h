// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file race.h
/// Time of a partition by METIS k-way and by Hawser, on one body graph.

#include "graph/partition.h"
#include "partition/cases.h"

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <vector>

namespace hawser::bench {

/// Run the steps after the body graph: cost, contraction, line and parts.
void repartition(const graph::Hypergraph& graph, int parts, graph::Partitioner& partitioner,
                 graph::Partition& out);

/// Median times of one call [s], METIS and Hawser in turns; 0 for METIS if it is not in this build.
struct Race {
    double metis = 0.0;       ///< METIS k-way, repeated alone.
    double metis_turn = 0.0;  ///< METIS k-way in turns with Hawser.
    double ours = 0.0;        ///< Hawser from the body graph, repeated alone.
    double turn = 0.0;        ///< Hawser, each after a call of METIS: branches are not predicted.
    double fresh = 0.0;       ///< Hawser with a new object, which has no memory yet.
    double graph = 0.0;       ///< Body graph from interactions.
    double cuts = 0.0;        ///< Cuts instead of separators, with artificial weights, including
                              ///< the graph.
};

/// Measure. @param exact  Flops of each body's pivots.
[[nodiscard]] Race race(const PartCase& c, int parts, const std::vector<std::int64_t>& exact);
nlohmann::json print_race(const Race& race);

}  // namespace hawser::bench
