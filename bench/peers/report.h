// SPDX-License-Identifier: Apache-2.0
/// @file
/// How `hawser-bench peers` tells results: tables, what ours was asked to reach, JSON.
#pragma once

#include "peers.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace hawser::bench {

/// One limit that ours is to keep on a scene.
struct Demand {
    std::string what;    ///< With its unit.
    double value = 0.0;  ///< Measured; not a number: nothing to compare with.
    double limit = 0.0;
    bool met = false;
};

/// The limits of Scene::wanted beside what was measured. Contacts have two: a range.
[[nodiscard]] std::vector<Demand> demands(const Scene& scene, const PeerResult& result);

/// Heading of a scene's table, and one row of it. Columns depend on the scene: with joints alone,
/// with contacts, or a stack.
void print_header(const Scene& scene);
void print_row(const Scene& scene, const PeerResult& result);

/// The fastest peer that holds beside ours, and what ours was asked for.
/// @return false if ours missed something.
bool print_verdict(const Scene& scene, const std::vector<PeerResult>& results);

[[nodiscard]] nlohmann::json to_json(const Scene& scene, const PeerResult& result);

}  // namespace hawser::bench
