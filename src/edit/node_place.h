// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file node_place.h
/// Surroundings of a node of a wire.

#include <cstdint>

namespace hawser::edit {

/// Number of nodes on each side of a node that follow its motion.
inline constexpr int kNodeReach = 4;

/// An element e from a to b. With a node n on it, e ends at n, and the element f continues from n
/// to b.
struct NodeSurroundings {
    std::int32_t first = -1, second = -1;  ///< Elements e, f; f −1: there is no node.
    std::int32_t node = -1;                ///< Node n, −1: none.
    /// Elements before a and behind b, the nearest first, while the nodes between have no other
    /// interaction; −1: none.
    std::int32_t before[kNodeReach] = {-1, -1, -1, -1}, after[kNodeReach] = {-1, -1, -1, -1};
    std::int32_t bend[3] = {-1, -1, -1};  ///< Bends with middle a, n, b; −1: none.
};

}  // namespace hawser::edit
