// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file grow.h
/// Arrays that follow a structure whose size changes.

#include "base/memory.h"

#include <cstddef>
#include <cstdint>

namespace hawser::factor {

/// Contents are not kept. Structures that follow a changing pattern (repair.h) grow again and
/// again: with room to spare where that is expected, and from the second time on.
template <class T>
void grow(base::Array<T>& array, std::int64_t size, bool spare = false) {
    if (static_cast<std::int64_t>(array.size()) >= size) return;
    const std::int64_t room = array.empty() && !spare ? size : size + size / 4;
    base::Array<T>().swap(array);
    array.resize(static_cast<std::size_t>(room));
}

/// Whether an array must grow that has been in use.
template <class T>
[[nodiscard]] bool outgrown(const base::Array<T>& array, std::int64_t size) {
    return !array.empty() && static_cast<std::int64_t>(array.size()) < size;
}

}  // namespace hawser::factor
