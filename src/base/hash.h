// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hash.h
/// FNV-1a, 64 bits (Fowler, Noll, Vo), in the byte order of memory (little-endian machines). Also a
/// faster checksum for megabytes of data: FNV processes one byte at a time.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace hawser::base {

inline constexpr std::uint64_t kFnvStart = 0xcbf29ce484222325ULL;

[[nodiscard]] inline std::uint64_t fnv1a(const void* data, std::size_t size,
                                         std::uint64_t hash = kFnvStart) noexcept {
    const auto* p = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i) hash = (hash ^ p[i]) * 0x100000001b3ULL;
    return hash;
}

/// Compute a checksum of 64 bits. Eight bytes are processed at a time in four independent lanes,
/// with about one multiplication per word. Each step is a bijection of its lane, so that every
/// change within one word changes the result. Other changes remain undetected with probability
/// 2^−64. Do not use it for keys that an adversary chooses.
[[nodiscard]] inline std::uint64_t checksum(const void* data, std::size_t size,
                                            std::uint64_t hash = kFnvStart) noexcept {
    constexpr std::uint64_t kGoldenMultiplier = 0x9e3779b97f4a7c15ULL;  // 2^64 / golden ratio
    const auto step = [](std::uint64_t lane, std::uint64_t word) {
        return std::rotl(lane ^ word, 29) * kGoldenMultiplier;
    };
    const auto* p = static_cast<const unsigned char*>(data);
    std::size_t left = size;
    if (left >= 32) {
        std::uint64_t lane[4] = {hash, hash + kGoldenMultiplier, hash + 2 * kGoldenMultiplier,
                                 hash + 3 * kGoldenMultiplier};
        for (; left >= 32; left -= 32, p += 32) {
            std::uint64_t word[4];
            std::memcpy(word, p, sizeof word);
            for (int k = 0; k < 4; ++k) lane[k] = step(lane[k], word[k]);
        }
        for (const std::uint64_t l : lane) hash = step(hash, l);
    }
    for (; left > 0; left -= left < 8 ? left : 8, p += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, p, left < 8 ? left : 8);
        hash = step(hash, word);
    }
    hash = step(hash, size);
    return hash ^ (hash >> 32);
}

}  // namespace hawser::base
