// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file scenes.h
/// Parts of scenes while they run, by World::partition(), and the body graph that METIS gets.

#include "factor/pattern.h"

#include <hawser/world.h>

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <vector>

namespace hawser::bench {

/// Bodies that move, and which of them share an interaction or touch.
struct BodyGraph {
    std::vector<std::int32_t> node;  ///< Of each body; −1: it does not move.
    factor::Pattern pattern;         ///< Sizes: degrees of freedom.
};
[[nodiscard]] BodyGraph body_graph(const World& world);

/// Time of graph, weights and cuts of scenes after a second, each by turns with METIS k-way on the
/// same body graph, which it gets ready-made. Printed; scenes that are not there are left out.
nlohmann::json time_scenes(int parts, int turns);

}  // namespace hawser::bench
