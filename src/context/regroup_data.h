// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file regroup_data.h
/// Groups that the world makes itself (split/regroup.cpp).

#include "assembly/parts.h"
#include "graph/partition.h"
#include "graph/split.h"

#include <cstdint>
#include <vector>

namespace hawser::stepper {

struct Regroup {
    static constexpr std::int64_t kSettle = 10;  ///< Steps until forces are worth weighing.

    // Part of the state:
    graph::Partition parts;  ///< Followed; of it part, parts and worse_for. Empty: none are made.
    std::int64_t made = 0;   ///< Step before which they were made from the model alone.
    std::int64_t seen = -1;  ///< Step before which the last round was.

    std::vector<std::int32_t> by_hand;  ///< By body: number of its group's name; −1: none.
    /// What parts were made for has changed; interactions they were made for.
    bool stale = true;
    std::int32_t interactions = 0;

    // Scratch:
    assembly::PartGraph graph;
    graph::Splitter splitter;
    graph::Partition next;
    std::vector<std::int32_t> part_of_name, cut;
    std::vector<double> active;
};

}  // namespace hawser::stepper
