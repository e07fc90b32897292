// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file grow.h
/// Arrays that grow with a structure of varying size.

#include "base/memory.h"

#include <cstddef>
#include <cstdint>

namespace hawser::factor {

/// Grow an array to at least `size`; contents are lost. Structures that follow a changing pattern
/// (repair.h) grow repeatedly. A quarter is added if `spare` is set, and from the second growth on.
template <class T>
void grow_discarding(base::Array<T>& array, std::int64_t size, bool spare = false) {
    if (static_cast<std::int64_t>(array.size()) >= size) return;
    const std::int64_t room = array.empty() && !spare ? size : size + size / 4;
    base::Array<T>().swap(array);
    array.resize(static_cast<std::size_t>(room));
}

/// Return true if an array in use is smaller than `size`.
template <class T>
[[nodiscard]] bool is_too_small(const base::Array<T>& array, std::int64_t size) {
    return !array.empty() && static_cast<std::int64_t>(array.size()) < size;
}

}  // namespace hawser::factor
