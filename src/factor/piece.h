// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file piece.h
/// Unit of work of one pass through memory.

#include <cstdint>

namespace hawser::factor {

/// Panels that are filled, factored and substituted together while they are in the cache: some
/// steps of a batch of chains, or consecutive fronts.
struct Piece {
    std::int64_t panel_begin, panel_end;        ///< Range in the panel array; pieces are disjoint.
    std::int32_t begin, end;                    ///< Fronts; for a batch twice its index.
    std::int32_t step_begin = 0, step_end = 0;  ///< Range of the steps of a batch.
};

}  // namespace hawser::factor
