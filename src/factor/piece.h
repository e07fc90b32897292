// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file piece.h
/// What one pass through memory takes at a time.

#include <cstdint>

namespace hawser::factor {

/// Panels that are filled, factored and substituted together while they are in the cache: some
/// steps of a batch of chains, or some fronts in a row.
struct Piece {
    std::int64_t panel_begin, panel_end;        ///< Offsets in the panel array; pieces are apart.
    std::int32_t begin, end;                    ///< Fronts; of a batch: its index, twice.
    std::int32_t step_begin = 0, step_end = 0;  ///< Of a batch, in the order of its steps.
};

}  // namespace hawser::factor
