// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sorted.h
/// Sets of indices as ascending lists.

#include <algorithm>
#include <cstdint>
#include <vector>

namespace hawser::base {

/// Insert a value unless present. Throws only if the list has to grow.
inline void insert_sorted(std::vector<std::int32_t>& list, std::int32_t value) {
    const auto place = std::lower_bound(list.begin(), list.end(), value);
    if (place == list.end() || *place != value) list.insert(place, value);
}

/// Erase a value if present.
inline void erase_sorted(std::vector<std::int32_t>& list, std::int32_t value) noexcept {
    const auto place = std::lower_bound(list.begin(), list.end(), value);
    if (place != list.end() && *place == value) list.erase(place);
}

}  // namespace hawser::base
