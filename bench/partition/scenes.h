// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file scenes.h
/// Parts of running scenes by World::partition(), and the body graph for METIS.

#include "factor/pattern.h"

#include <hawser/world.h>

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <vector>

namespace hawser::bench {

/// Moving bodies, with an edge for each pair that shares an interaction or touches.
struct BodyGraph {
    std::vector<std::int32_t> node;  ///< Node of each body; −1: fixed.
    factor::Pattern pattern;         ///< Sizes: degrees of freedom.
};
[[nodiscard]] BodyGraph body_graph(const World& world);

/// Time graph, weights and cuts of scenes after a second. Each alternates with METIS k-way on the
/// same body graph, which is prepared. Prints the times; missing scenes are omitted.
nlohmann::json time_scenes(int parts, int turns);

}  // namespace hawser::bench
