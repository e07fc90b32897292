// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file grow.h
/// Sizes that change a little from step to step must not allocate in each.

#include <cstddef>

namespace hawser::collide {

/// Resize with half as much again and `spare` entries to spare, where the capacity must grow.
template <class V>
void resize_with_room(V& v, std::size_t size, std::size_t spare = 64) {
    if (v.capacity() < size) v.reserve(size + size / 2 + spare);
    v.resize(size);
}

}  // namespace hawser::collide
