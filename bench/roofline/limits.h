// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file limits.h
/// Limits of this processor, measured on one thread with the vectors of the kernels (base/isa.h).

#include <cstddef>

namespace hawser::bench {

/// Measure multiply-adds on ten independent registers, counted as two each [flop/s].
[[nodiscard]] double peak_flops();

/// Bandwidth through arrays of a total size, repeatedly [byte/s].
struct Bandwidth {
    double read = 0.0;    ///< Sum of an array.
    double update = 0.0;  ///< x ← a x + b: each byte is read and written, and counted twice.
};
[[nodiscard]] Bandwidth bandwidth(std::size_t bytes);

}  // namespace hawser::bench
