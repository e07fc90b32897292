// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file regroup_data.h
/// Groups that the world makes automatically (split/regroup.cpp).

#include "assembly/parts.h"
#include "graph/partition.h"
#include "graph/split.h"

#include <cstdint>
#include <vector>

namespace hawser::context {

struct Regroup {
    static constexpr std::int64_t kSettle = 10;  ///< Steps until forces can be used as weights.

    // Part of the state:
    /// Partition that follows the state: part, parts and worse_for. Empty: no groups.
    graph::Partition parts;
    std::int64_t made = 0;   ///< Step before which the groups were made from the model alone.
    std::int64_t seen = -1;  ///< Step before which the last choice of groups was made.

    std::vector<std::int32_t> by_hand;  ///< Index of the group name of each body; −1: none.
    /// True if the input of the partition has changed; number of interactions at the last
    /// partition.
    bool stale = true;
    std::int32_t interactions = 0;

    // Scratch:
    assembly::PartGraph graph;
    graph::Splitter splitter;
    graph::Partition next;
    std::vector<std::int32_t> part_of_name, cut;
    std::vector<double> active;
};

}  // namespace hawser::context
