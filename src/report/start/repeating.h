// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file repeating.h
/// Groups of joints whose rows follow from each other's.

#include "report/start/joint_rows.h"

#include <cstdint>
#include <vector>

namespace hawser::report::start {

/// Joints that say the same thing of their bodies.
struct Group {
    std::vector<std::int32_t> joints;  ///< Indices, ascending.
    int repetitions = 0;               ///< Rows that follow from the others; 0: not counted.
};

/// The groups at the poses that the rows are of, by their first joints.
[[nodiscard]] std::vector<Group> find_groups(const World& world, JointRows& rows);

}  // namespace hawser::report::start
