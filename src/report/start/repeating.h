// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file repeating.h
/// Find groups of joints with redundant rows.

#include "report/start/joint_rows.h"

#include <cstdint>
#include <vector>

namespace hawser::report::start {

/// Joints with redundant rows.
struct Group {
    std::vector<std::int32_t> joints;  ///< Indices in JointRows::joints(), ascending.
    int repetitions = 0;               ///< Number of redundant rows; 0: not counted.
};

/// Return the groups of redundant joints at the poses of `rows`, ordered by their first joints.
[[nodiscard]] std::vector<Group> find_groups(const World& world, JointRows& rows);

}  // namespace hawser::report::start
