// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file limits.h
/// What this processor can do at most, measured on one thread with the vectors that the kernels
/// use (base/isa.h).

#include <cstddef>

namespace hawser::bench {

/// Multiply-adds on ten independent registers, counted as two each [flop/s].
[[nodiscard]] double peak_flops();

/// Through arrays of so many bytes in all, again and again [byte/s].
struct Bandwidth {
    double read = 0.0;    ///< Sum of an array.
    double update = 0.0;  ///< x ← a x + b: each byte is read and written, and counted twice.
};
[[nodiscard]] Bandwidth bandwidth(std::size_t bytes);

}  // namespace hawser::bench
