// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file node_place.h
/// What is about a node of a wire.

#include <cstdint>

namespace hawser::stepper {

/// So many lumps on each side of a node follow where it goes.
inline constexpr int kNodeReach = 4;

/// An element e from a to b; with a node n on it also the element f that goes on from n to b.
struct NodePlace {
    std::int32_t first = -1, second = -1;  ///< Elements e, f; f −1: there is no node.
    std::int32_t node = -1;                ///< Lump n, −1: none.
    /// Elements before a and behind b, the nearest first, as long as lumps that nothing else holds
    /// are between; −1: none.
    std::int32_t before[kNodeReach] = {-1, -1, -1, -1}, after[kNodeReach] = {-1, -1, -1, -1};
    std::int32_t bend[3] = {-1, -1, -1};  ///< Whose middle is a, n, b; −1: none.
};

}  // namespace hawser::stepper
