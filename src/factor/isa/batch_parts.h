// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file batch_parts.h
/// Common parts of factorisation and substitution of batches (factor/batches.h). Every scalar is a
/// vector of eight lanes, so no loop has a remainder and no pivot waits for another lane.

#include "base/simd.h"
#include "factor/isa/keep.h"
#include "factor/kernels.h"
#include "factor/symbolic.h"

namespace hawser::HAWSER_ISA {

using factor::kTile;

// A block of 3 × 3 vectors of eight lanes fills nine registers on AVX-512, 18 of 16 on AVX2, and 36
// of 16 on SSE2. Lanes are independent, so a block is computed one register of lanes (Part) at a
// time. Each instruction set then needs nine accumulators and six operands, and each lane has the
// same operations.

/// Compute acc(i, j) −= Σ_k a(i, k) b(j, k) in one register of lanes, with rows `stride` entries
/// apart.
template <int NI, int NJ>
HAWSER_INLINE void tile(Part (&acc)[NI][NJ], const double* a, const double* b, long stride,
                        int depth) {
    for (int k = 0; k < depth; ++k) {
        Part l[NI], u[NJ];
        for (int i = 0; i < NI; ++i) l[i] = keep(load_part(a + i * stride + 8 * k));
        for (int j = 0; j < NJ; ++j) u[j] = keep(load_part(b + j * stride + 8 * k));
        for (int i = 0; i < NI; ++i)
            for (int j = 0; j < NJ; ++j) acc[i][j] -= l[i] * u[j];
    }
}

/// Call f with the tile size as a constant.
template <class F>
HAWSER_INLINE void with_size(int n, F&& f) {
    switch (n) {
        case 1:
            f.template operator()<1>();
            break;
        case 2:
            f.template operator()<2>();
            break;
        default:
            f.template operator()<3>();
            break;
    }
}

/// Origin of the update slots of a step: the tile that contained them before.
struct Shift {
    int body, window, before;  ///< Tiles of a body; of the window; of the update slots before.
    /// Return the earlier tile, −1: new in this step.
    [[nodiscard]] HAWSER_INLINE int earlier_tile(int tile) const {
        if (tile < window) return tile + body < window && before > 0 ? tile + body : -1;
        return tile < before ? tile : -1;
    }
};

/// Return the shift before a step of the batch.
HAWSER_INLINE Shift shift_before(const factor::FactorView& view, const factor::Batch& batch,
                                 std::int32_t step) {
    const int before = step > batch.step_begin ? view.batch_steps[step - 1].q / kTile : 0;
    return {batch.body / kTile, batch.window / kTile, before};
}

}  // namespace hawser::HAWSER_ISA
