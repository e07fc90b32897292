// SPDX-License-Identifier: Apache-2.0
/// @file
/// Output of `hawser-bench peers`: tables, demands on Hawser, JSON.
#pragma once

#include "peers.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace hawser::bench {

/// A limit that Hawser must keep on a scene.
struct Demand {
    std::string what;    ///< With its unit.
    double value = 0.0;  ///< Measured; NaN: no reference.
    double limit = 0.0;
    bool met = false;
};

/// Return the limits of Scene::wanted with the measured values. Contacts have two: a range.
[[nodiscard]] std::vector<Demand> demands(const Scene& scene, const PeerResult& result);

/// Print the heading of a scene's table. Columns depend on the scene: with joints alone, with
/// contacts, or a stack.
void print_header(const Scene& scene);
void print_row(const Scene& scene, const PeerResult& result);

/// Print the fastest peer that holds, Hawser, and the demands. @return false if Hawser missed one.
bool print_verdict(const Scene& scene, const std::vector<PeerResult>& results);

[[nodiscard]] nlohmann::json to_json(const Scene& scene, const PeerResult& result);

}  // namespace hawser::bench
