// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file recording_bytes.h
/// Read values of a recording and check their ranges. Each function throws BadBytes for a value out
/// of range. A checksum does not replace these checks: it is valid for any bytes written with it.

#include "record/bytes.h"

#include <hawser/math.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace hawser::record {

inline constexpr std::int64_t kMaxSteps = std::int64_t{1} << 53;  ///< Times are doubles.
inline constexpr double kMaxStep = 1.0;                ///< Largest step, as in WorldDef::step [s].
inline constexpr std::int32_t kMaxStride = 1'000'000;  ///< Largest stride, as in --record-every.

template <class Enum>
Enum get_enum(ByteReader& in, int count) {
    const auto value = in.get<std::uint8_t>();
    if (value >= count) throw BadBytes("an enumerated value is out of range");
    return static_cast<Enum>(value);
}

template <class T = double>
T get_finite(ByteReader& in) {
    const T value = in.get<T>();
    if (!std::isfinite(value)) throw BadBytes("a number is not finite");
    return value;
}

/// Read a step number. @throws BadBytes if it is below `least`.
inline std::int64_t get_step(ByteReader& in, std::int64_t least) {
    const auto value = in.get<std::int64_t>();
    if (value < least || value > kMaxSteps) throw BadBytes("a step is out of range");
    return value;
}

inline std::vector<std::int32_t> get_indices(ByteReader& in, std::size_t limit) {
    std::vector<std::int32_t> out(in.get_count(4));
    for (std::int32_t& index : out) {
        index = in.get<std::int32_t>();
        if (index < 0 || static_cast<std::size_t>(index) >= limit)
            throw BadBytes("an index is out of range");
    }
    return out;
}

inline Vec3 get_vector(ByteReader& in) {
    const double x = get_finite(in), y = get_finite(in), z = get_finite(in);
    return {x, y, z};
}

/// Read a quaternion in the order w, x, y, z.
template <class T>
Quat get_quaternion(ByteReader& in) {
    const double w = get_finite<T>(in), x = get_finite<T>(in), y = get_finite<T>(in),
                 z = get_finite<T>(in);
    return {w, x, y, z};
}

inline void check_unit(const Quat& q, double off) {
    if (!(std::abs(q.norm() - 1.0) <= off)) throw BadBytes("an orientation is no rotation");
}

}  // namespace hawser::record
