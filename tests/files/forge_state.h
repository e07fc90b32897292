// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file forge_state.h
/// Change the contents of a snapshot and update its checksum.
#include "base/hash.h"
#include "files/mutate.h"

#include <cstddef>
#include <vector>

namespace hawser::test {

inline constexpr std::size_t kSnapshotSystems = 13 * 8;  ///< Offset of the byte count of systems.

/// Change 1 to 3 values in the bytes from `from` on, without changing the size.
inline void forge_tail(std::vector<std::byte>& bytes, std::size_t from, Random& random) {
    const std::size_t sum = 8;
    for (int i = random.integer(1, 3); i > 0; --i)
        mutate(std::span(bytes).subspan(from, bytes.size() - from - sum), random);
    write_at(std::span(bytes), bytes.size() - sum,
             base::checksum(bytes.data(), bytes.size() - sum));
}

}  // namespace hawser::test
