// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file grow.h
/// Growth of arrays whose size changes a little in each step, without an allocation in each.

#include <cstddef>

namespace hawser::collide {

/// Resize an array. If its capacity must grow, reserve half as much again and `spare` more entries.
template <class V>
void resize_with_reserve(V& v, std::size_t size, std::size_t spare = 64) {
    if (v.capacity() < size) v.reserve(size + size / 2 + spare);
    v.resize(size);
}

}  // namespace hawser::collide
