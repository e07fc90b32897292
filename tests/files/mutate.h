// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file mutate.h
/// Change bytes like an attacker: indices, numbers and counts get values that a reader may handle
/// wrongly.

#include "support/random.h"
#include "support/sanitizer.h"
#include "support/tier.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

namespace hawser::test {

/// Return the number of inputs of a fuzzer: HAWSER_FUZZ, or by tier. @param full  Without and with
/// a sanitizer.
inline int inputs_of(int quick, int full, int long_runs) {
    if (const char* count = std::getenv("HAWSER_FUZZ")) return std::max(1, std::atoi(count));
    return by_tier(kSanitized ? quick / 2 : quick, full, long_runs);
}

template <class T>
T pick(Random& random, std::initializer_list<T> from) {
    return from.begin()[random.integer(0, static_cast<int>(from.size()) - 1)];
}

inline std::int32_t odd_index(Random& random, std::int32_t old) {
    constexpr std::int32_t kMaximum = std::numeric_limits<std::int32_t>::max();
    switch (random.integer(0, 3)) {
        case 0:
            return pick<std::int32_t>(random,
                                      {-1, -2, 0, 1, kMaximum, -kMaximum - 1, 1 << 20, 0x7FF80000});
        case 1:
            return random.integer(0, 64);
        case 2:  // as unsigned: the old value may be the largest integer
            return static_cast<std::int32_t>(static_cast<std::uint32_t>(old) +
                                             static_cast<std::uint32_t>(random.integer(-3, 3)));
        default:
            return static_cast<std::int32_t>(static_cast<std::uint32_t>(random.integer(0, 0xFFFF))
                                                 << 16U |
                                             static_cast<std::uint32_t>(random.integer(0, 0xFFFF)));
    }
}

inline double odd_number(Random& random, double old) {
    constexpr double kInf = std::numeric_limits<double>::infinity();
    switch (random.integer(0, 3)) {
        case 0:
            return pick<double>(random, {std::numeric_limits<double>::quiet_NaN(), kInf, -kInf});
        case 1:
            return pick<double>(random, {1e300, -1e308, 1e15, -1e12, 1e6, 5e-324, 0.0, -0.0, 1.0});
        case 2:
            return -old;
        default:
            return old * (1.0 + random.uniform(-1e-2, 1e-2)) + random.uniform(-1e-2, 1e-2);
    }
}

template <class T>
T read_at(std::span<const std::byte> from, std::size_t at) {
    T value;
    std::memcpy(&value, from.data() + at, sizeof value);
    return value;
}
template <class T>
void write_at(std::span<std::byte> to, std::size_t at, T value) {
    std::memcpy(to.data() + at, &value, sizeof value);
}

/// Change one value in the bytes without changing the size.
inline void mutate(std::span<std::byte> bytes, Random& random) {
    if (bytes.size() < 16) return;
    const auto place = [&](std::size_t size, std::size_t align) {
        const auto last = static_cast<int>((bytes.size() - size) / align);
        return align * static_cast<std::size_t>(random.integer(0, last));
    };
    switch (random.integer(0, 4)) {
        case 0: {
            const std::size_t at = place(4, 4);
            write_at(bytes, at, odd_index(random, read_at<std::int32_t>(bytes, at)));
            break;
        }
        case 1: {
            const std::size_t at = place(8, random.chance(0.5) ? 8 : 4);
            write_at(bytes, at, odd_number(random, read_at<double>(bytes, at)));
            break;
        }
        case 2:
            bytes[place(1, 1)] ^= static_cast<std::byte>(random.integer(1, 255));
            break;
        case 3: {  // a value that is valid elsewhere
            const std::size_t size = pick<std::size_t>(random, {4, 8, 16});
            const std::size_t from = place(size, 4), to = place(size, 4);
            std::memmove(bytes.data() + to, bytes.data() + from, size);
            break;
        }
        default: {
            const std::size_t at = place(8, 8);
            write_at(bytes, at,
                     pick<std::uint64_t>(random, {0, 1, 2, 1000, ~std::uint64_t{0},
                                                  std::uint64_t{1} << 32, std::uint64_t{1} << 62}));
        }
    }
}

}  // namespace hawser::test
