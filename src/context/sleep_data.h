// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sleep_data.h
/// Scratch of the search for islands (sleep.h).

#include <cstdint>
#include <vector>

namespace hawser::context {

/// Scratch of sleep.h, by body.
struct Sleep {
    std::vector<std::int32_t> island;  ///< Union-find: parent of each body.
    std::vector<std::uint8_t> mark;    ///< Mark of the first body of an island.
};

}  // namespace hawser::context
