// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hash.h
/// FNV-1a, 64 bits (Fowler, Noll, Vo): byte order is that of memory (little-endian machines).

#include <cstddef>
#include <cstdint>

namespace hawser::base {

inline constexpr std::uint64_t kFnvStart = 0xcbf29ce484222325ULL;

[[nodiscard]] inline std::uint64_t fnv1a(const void* data, std::size_t size,
                                         std::uint64_t hash = kFnvStart) noexcept {
    const auto* p = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i) hash = (hash ^ p[i]) * 0x100000001b3ULL;
    return hash;
}

}  // namespace hawser::base
