// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file rigid_steps.h
/// Steps of a symmetric batch (factor/batches.h) that eliminate one rigid body without rows, which
/// has six pivots. Most steps of chains and cables with condensed joints are of this form.
///
/// The pivots form one chain of dependent operations: six times a division, a product and a sum.
/// This takes about as long as all products of the step. All other operations of the step need
/// the pivots. The pivots need only the first two rows of tiles of the window. These tiles are
/// therefore computed first, and the pivots of the next step are eliminated between the others:
///
/// ```
///   rows k │ window k: body │ pivots k + 1: 0     1     2     3     4     5 │ rows k + 1 │ …
///          │ tiles          │ window k:       ▪     ▪     ▪     ▪     ▪     │
/// ```
/// On AVX-512, which has enough registers, the triangle of the six pivots stays in registers from
/// its first product to its last pivot. On other instruction sets batch.cpp treats such steps like
/// all others.

#include "factor/isa/batch_parts.h"

namespace hawser::HAWSER_ISA {

#if defined(__AVX512F__)
inline constexpr bool kManyRegisters = true;
#else
inline constexpr bool kManyRegisters = false;
#endif

inline constexpr int kRigidPivots = 6;                       ///< Pivots of a step.
inline constexpr int kRigidTiles = kRigidPivots / kTile;     ///< Rows of tiles of a body.
inline constexpr long kRigidStride = kLanes * kRigidPivots;  ///< Doubles of a row of the panel.
inline constexpr long kTileSize = kLanes * kTile * kTile;    ///< Doubles.

/// Return the offset of tile (i, j), i ≥ j, of a window.
HAWSER_INLINE long tile_at(int i, int j) {
    return kTileSize * (static_cast<long>(i) * (i + 1) / 2 + j);
}

/// Panel and pivots of a step.
struct RigidStep {
    double* panel;  ///< 6 + q rows of 6 vectors: A, overwritten with L.
    double* w;      ///< 6 + q rows of 6 vectors: L D, for rows from the seventh on.
    double* pivot;  ///< 6 vectors: 1/D.
    const signed char* sign;
    int tiles;  ///< q / 3.
};

/// Lower triangle of the block of a body.
using RigidBlock = V8[kRigidPivots][kRigidPivots];

HAWSER_INLINE RigidStep rigid_step(const factor::FactorView& view, std::int32_t k, double* w) {
    const factor::BatchStep& step = view.batch_steps[k];
    return {view.panel + step.panel, w, view.slot_pivot + kLanes * step.slot,
            view.slot_sign + step.slot, step.q / kTile};
}

/// Add the block of the matrix to the registers a.
HAWSER_INLINE void add_block(const RigidStep& m, RigidBlock& a) {
    for (int i = 0; i < kRigidPivots; ++i)
        for (int j = 0; j <= i; ++j) a[i][j] += load(m.panel + i * kRigidStride + kLanes * j);
}

/// Load the updates of earlier steps for the diagonal block of this body into the registers a.
HAWSER_INLINE void load_block(const double* window, RigidBlock& a) {
    for (int i = 0; i < kRigidPivots; ++i)
        for (int j = 0; j <= i; ++j)
            a[i][j] = load(window + tile_at(i / kTile, j / kTile) +
                           kLanes * (kTile * (i % kTile) + j % kTile));
}
HAWSER_INLINE void store_block(const RigidBlock& a, double* window) {
    for (int i = 0; i < kRigidPivots; ++i)
        for (int j = 0; j <= i; ++j)
            store(
                window + tile_at(i / kTile, j / kTile) + kLanes * (kTile * (i % kTile) + j % kTile),
                a[i][j]);
}

/// Eliminate pivot j of the diagonal block in registers.
HAWSER_INLINE void eliminate(const RigidStep& m, int j, RigidBlock& a, V8& bad) {
    V8 d = a[j][j], l[kRigidPivots];
    bad += fix_pivot<false>(d, m.sign[j]);
    const V8 inverse = reciprocal(d);
    store(m.pivot + kLanes * j, inverse);
    for (int i = j + 1; i < kRigidPivots; ++i) {
        l[i] = a[i][j] * inverse;
        store(m.panel + i * kRigidStride + kLanes * j, l[i]);
    }
    for (int k = j + 1; k < kRigidPivots; ++k)
        for (int i = k; i < kRigidPivots; ++i) a[i][k] -= l[k] * a[i][j];
}

/// Solve the three panel rows of a tile below the diagonal block.
/// @param left  Two tiles with the updates of earlier steps; null: none.
HAWSER_INLINE void solve_rows(const RigidStep& m, int tile, const double* left) {
    double* row = m.panel + (kRigidPivots + kTile * tile) * kRigidStride;
    double* w = m.w + (kRigidPivots + kTile * tile) * kRigidStride;
    V8 x[kTile][kRigidPivots];
    for (int r = 0; r < kTile; ++r)
        for (int j = 0; j < kRigidPivots; ++j) x[r][j] = load(row + r * kRigidStride + kLanes * j);
    if (left != nullptr)
        for (int r = 0; r < kTile; ++r)
            for (int j = 0; j < kRigidPivots; ++j)
                x[r][j] += load(left + kTileSize * (j / kTile) + kLanes * (kTile * r + j % kTile));
#pragma GCC unroll 6
    for (int k = 0; k < kRigidPivots; ++k) {
#pragma GCC unroll 6
        for (int j = k + 1; j < kRigidPivots; ++j) {
            const V8 l = keep(load(m.panel + j * kRigidStride + kLanes * k));
            for (int r = 0; r < kTile; ++r) x[r][j] -= l * x[r][k];
        }
        const V8 inverse = keep(load(m.pivot + kLanes * k));
        for (int r = 0; r < kTile; ++r) {
            store(w + r * kRigidStride + kLanes * k, x[r][k]);
            store(row + r * kRigidStride + kLanes * k, x[r][k] * inverse);
        }
    }
}

/// Compute tile (i, j) of the next window: the shifted tile less the products. The upper triangle
/// of a diagonal tile is never read.
template <bool kLower>
HAWSER_INLINE void rigid_tile(const RigidStep& m, const Shift& shift, int i, int j,
                              const double* window, V8 (&acc)[kTile][kTile]) {
    const int row = shift.earlier_tile(i), column = shift.earlier_tile(j);
    const double* old = row < 0 || column < 0 ? nullptr : window + tile_at(row, column);
    for (int a = 0; a < kTile; ++a)
        for (int b = 0; b < kTile; ++b)
            acc[a][b] = old == nullptr ? V8{} : load(old + kLanes * (kTile * a + b));
    const double* l = m.panel + (kRigidPivots + kTile * i) * kRigidStride;
    const double* w = m.w + (kRigidPivots + kTile * j) * kRigidStride;
#pragma GCC unroll 6
    for (int k = 0; k < kRigidPivots; ++k) {
        V8 left[kTile], right[kTile];
        for (int a = 0; a < kTile; ++a) left[a] = keep(load(l + a * kRigidStride + kLanes * k));
        for (int b = 0; b < kTile; ++b) right[b] = keep(load(w + b * kRigidStride + kLanes * k));
        for (int a = 0; a < kTile; ++a)
            for (int b = 0; b <= (kLower ? a : kTile - 1); ++b) acc[a][b] -= left[a] * right[b];
    }
}

/// Tiles of the next window behind those of the body, one after another.
struct OtherTiles {
    const RigidStep& m;
    const Shift& shift;
    const double* window;
    double* next;
    int i = kRigidTiles, j = 0;

    [[nodiscard]] HAWSER_INLINE bool tiles_left() const { return i < m.tiles; }
    HAWSER_INLINE void compute_tile() {
        V8 acc[kTile][kTile];
        rigid_tile<false>(m, shift, i, j, window, acc);
        double* to = next + tile_at(i, j);
        for (int a = 0; a < kTile; ++a)
            for (int b = 0; b < kTile; ++b) store(to + kLanes * (kTile * a + b), acc[a][b]);
        if (++j > i) {
            ++i;
            j = 0;
        }
    }
};

/// Compute the tiles of the next window that form the diagonal block of the next body, in the
/// registers a.
HAWSER_INLINE void body_tiles(const RigidStep& m, const Shift& shift, const double* window,
                              RigidBlock& a) {
    V8 acc[kTile][kTile];
    auto put = [&](int i, int j) {
        for (int r = 0; r < kTile; ++r)
            for (int c = 0; c < (i == j ? r + 1 : kTile); ++c)
                a[kTile * i + r][kTile * j + c] = acc[r][c];
    };
    rigid_tile<true>(m, shift, 0, 0, window, acc);
    put(0, 0);
    rigid_tile<false>(m, shift, 1, 0, window, acc);
    put(1, 0);
    rigid_tile<true>(m, shift, 1, 1, window, acc);
    put(1, 1);
}

/// True if batch step k eliminates rigid bodies without rows of kept interactions.
HAWSER_INLINE bool is_rigid(const factor::FactorView& view, const factor::Batch& batch,
                            std::int32_t k) {
    return batch.body == kRigidPivots && view.batch_steps[k].p == kRigidPivots;
}

/// Eliminate the pivots of the first of several consecutive rigid steps, whose window is in memory.
inline void begin_rigid(const RigidStep& m, const Shift& shift, const double* window, V8& bad) {
    RigidBlock a;
    if (shift.before > 0)
        load_block(window, a);
    else
        for (auto& row : a)
            for (V8& v : row) v = V8{};
    add_block(m, a);
#pragma GCC unroll 6
    for (int j = 0; j < kRigidPivots; ++j) eliminate(m, j, a, bad);
}

/// Finish a step whose pivots are eliminated: its rows, the window behind it, and the pivots of the
/// following step.
/// @param following  The following step if it is rigid, or null: the block then goes to the window.
inline void finish_rigid(const RigidStep& m, const RigidStep* following, const Shift& shift,
                         const double* window, double* next, V8& bad) {
    for (int t = 0; t < m.tiles; ++t) {
        const int from = shift.earlier_tile(t);
        solve_rows(m, t, from < 0 ? nullptr : window + tile_at(from, 0));
    }
    RigidBlock a;
    body_tiles(m, shift, window, a);
    OtherTiles others{m, shift, window, next};
    if (following == nullptr) {
        store_block(a, next);
    } else {
        add_block(*following, a);
#pragma GCC unroll 6
        for (int j = 0; j < kRigidPivots; ++j) {
            eliminate(*following, j, a, bad);
            if (others.tiles_left()) others.compute_tile();
        }
    }
    while (others.tiles_left()) others.compute_tile();
}

}  // namespace hawser::HAWSER_ISA
