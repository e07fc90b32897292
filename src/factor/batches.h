// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file batches.h
/// Batches: up to eight chains in the lanes of vector registers.
///
/// Up to eight chains (chains.h) with bodies of one size and one reach make a *batch*. Each step
/// eliminates one unit of every chain at once. All scalars of a step are vectors of eight doubles,
/// one lane per chain. The chains need not be equal; their last units are in one step. A lane holds
/// zeros and a unit pivot if its chain lacks a unit, a row or a boundary node of the common shape.
///
/// ```
///             p      window    boundary        p   body + rows of the step's unit
///          ┌─────┐                             window: the next `reach` bodies of the chain
///        p │ L11 │                             boundary: what the chain touches outside,
///          ├─────┤                                      sorted by first touch: q grows
///   window │ L21 │  carried to the next step
/// boundary │     │  in cache, never stored
///          └─────┘
/// ```
/// The window between two steps is a lower triangle of 3 × 3 tiles. Its sizes are rounded up to
/// multiples of three, so that it moves by whole tiles. The panel of a step is stored by rows:
/// entry (i, k) of lane l is at 8 (i p + k) + l. The last update matrix of a chain goes to an
/// ordinary parent front.

#include <cstdint>

namespace hawser::factor {

inline constexpr int kLaneCount = 8;
inline constexpr int kTile = 3;  ///< Rows and columns of the kernels' register blocks.

/// One unit of every lane. Plain data, which the kernels read directly.
struct BatchStep {
    /// Pivot and update scalars, padding included; q is a multiple of 3.
    std::int32_t p = 0, q = 0;
    std::int64_t slot = 0;   ///< First of its p pivots in the slot arrays.
    std::int64_t panel = 0;  ///< Offset into the panel array.
    friend bool operator==(const BatchStep&, const BatchStep&) = default;
};

struct Batch {
    std::int32_t step_begin = 0, step_end = 0;
    std::int32_t body = 0;                ///< Scalars of a body: 3 or 6.
    std::int32_t window = 0;              ///< Reach × body.
    std::int32_t max_p = 0, max_q = 0;    ///< Maxima over its steps.
    std::int32_t front[kLaneCount] = {};  ///< Front of each lane, −1: lane unused.
    std::int64_t unused = 0;              ///< Padding pivots in all lanes.
    std::int64_t flops = 0;               ///< Flops of the lanes in use, padding included.
    friend bool operator==(const Batch&, const Batch&) = default;
};

/// Return the scratch that a factorisation (kernels.h) of a symmetric batch keeps between steps
/// [doubles]. An unsymmetric batch needs twice as many. The scratch of a substitution follows it.
[[nodiscard]] constexpr std::int64_t batch_windows(const Batch& b) {
    const std::int64_t tiles = b.max_q / kTile;
    return kLaneCount * (tiles * (tiles + 1) * kTile * kTile +
                         static_cast<std::int64_t>(b.max_p + b.max_q) * b.max_p);
}

}  // namespace hawser::factor
