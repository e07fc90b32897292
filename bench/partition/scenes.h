// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file scenes.h
/// Parts of scenes while they run, by WorldSplits::partition(), and the body graph for METIS.

#include "factor/pattern.h"

#include <hawser/world.h>

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <vector>

namespace hawser::bench {

/// Moving bodies, and pairs that share an interaction or touch.
struct BodyGraph {
    std::vector<std::int32_t> node;  ///< Node of each body; −1: it does not move.
    factor::Pattern pattern;         ///< Sizes: degrees of freedom.
};
[[nodiscard]] BodyGraph body_graph(const World& world);

/// Measure the time of graph, weights and cuts of scenes after a second, each in turns with METIS
/// k-way on the same body graph, which METIS gets complete. Prints; missing scenes are left out.
nlohmann::json time_scenes(int parts, int turns);

}  // namespace hawser::bench
