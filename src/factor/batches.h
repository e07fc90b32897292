// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file batches.h
/// Chains side by side in the lanes of vector registers.
///
/// Up to eight chains (chains.h) with bodies of one size and one reach make a *batch*. Its
/// steps eliminate one unit of every chain at once; all scalars of a step are vectors of eight
/// doubles, lane by lane another chain. The chains need not be equal: they are aligned at their
/// ends, and where a chain has no unit, no row or no boundary node of the common shape, its lane
/// holds zeros and a unit pivot.
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
/// The window between two steps is a lower triangle of tiles of 3 × 3; sizes in it are rounded up
/// to threes, so that it moves on by whole tiles. The panel of a step is stored by rows: entry (i,
/// k) of lane l at 8 (i p + k) + l. A chain's last update matrix goes to an ordinary parent front.

#include <cstdint>

namespace hawser::factor {

inline constexpr int kLaneCount = 8;
inline constexpr int kTile = 3;  ///< Rows and columns of the kernels' register blocks.

/// One unit of every lane. Plain data: the kernels read it directly.
struct BatchStep {
    std::int32_t p = 0, q = 0;  ///< Pivot and update scalars, padding included; q in threes.
    std::int64_t slot = 0;      ///< First of its p pivots in the slot arrays.
    std::int64_t panel = 0;     ///< Offset into the panel array.
    friend bool operator==(const BatchStep&, const BatchStep&) = default;
};

struct Batch {
    std::int32_t step_begin = 0, step_end = 0;
    std::int32_t body = 0;                ///< Scalars of a body: 3 or 6.
    std::int32_t window = 0;              ///< Reach × body.
    std::int32_t most_p = 0, most_q = 0;  ///< Over its steps.
    std::int32_t front[kLaneCount] = {};  ///< Front of each lane, −1: lane unused.
    std::int64_t unused = 0;              ///< Padding pivots in all lanes.
    std::int64_t flops = 0;               ///< Of the lanes in use, padding included.
    friend bool operator==(const Batch&, const Batch&) = default;
};

/// Doubles of scratch that a factorisation (kernels.h) keeps from step to step of a symmetric
/// batch, of an unsymmetric one twice as many. What a substitution keeps has room behind them.
[[nodiscard]] constexpr std::int64_t batch_windows(const Batch& b) {
    const std::int64_t tiles = b.most_q / kTile;
    return kLaneCount * (tiles * (tiles + 1) * kTile * kTile +
                         static_cast<std::int64_t>(b.most_p + b.most_q) * b.most_p);
}

}  // namespace hawser::factor
