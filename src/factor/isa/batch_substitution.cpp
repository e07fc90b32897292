// SPDX-License-Identifier: Apache-2.0
/// Substitution with batches (see factor/batches.h for the picture).
#include "base/lanes.h"
#include "base/transpose.h"
#include "factor/isa/batch.h"
#include "factor/isa/batch_parts.h"
#include "factor/isa/rigid_steps.h"
#include "factor/kernels.h"

#include <utility>

namespace hawser::HAWSER_ISA {
namespace {

using factor::Batch;
using factor::BatchStep;
using factor::FactorView;
using factor::Front;

/// Prefetch a panel that is read in a later step. Substitutions read each entry once, and large
/// factors are not in a cache.
HAWSER_INLINE void prefetch_panel(const double* panel, const BatchStep& step) {
    const double* p = panel + step.panel;
    const long size = 8L * step.p * (step.p + step.q);
    for (long i = 0; i < size; i += 64 / static_cast<long>(sizeof(double)))
        __builtin_prefetch(p + i);
}
constexpr int kPrefetchSteps = 2;  // steps

// Steps of rigid_steps.h. Values that pass from one pivot to the next stay in registers, and the
// six entries of x of each lane are adjacent. Six vectors of two registers fit on AVX2. Six vectors
// of four registers do not fit on SSE2.
inline constexpr bool kRigidInRegisters = kPartLanes >= 4;

/// Load x of the bodies of a batch step, one body per lane; 0 in a lane without a body.
HAWSER_INLINE void load_rigid(const double* x, const std::int32_t* index, V8 (&v)[kLanes]) {
    for (int l = 0; l < kLanes; ++l)
        v[l] = index[l] < 0 ? V8{} : load_first(x + index[l], kRigidPivots);
    transpose(v);
}
HAWSER_INLINE void store_rigid(double* x, const std::int32_t* index, V8 (&v)[kLanes]) {
    transpose(v);
    for (int l = 0; l < kLanes; ++l)
        if (index[l] >= 0) store_first<kRigidPivots>(x + index[l], v[l]);
}

/// Perform one step of forward_batch(), for rigid bodies.
inline void forward_rigid(const FactorView& view, const BatchStep& step, const Shift& shift,
                          const double* x, const double* carried, double* next) {
    const double* panel = view.panel + step.panel;
    V8 y[kLanes];
    load_rigid(x, view.slot_index + 8 * step.slot, y);
    if (shift.before > 0)
        for (int k = 0; k < kRigidPivots; ++k) y[k] += load(carried + 8 * k);
#pragma GCC unroll 6
    for (int k = 0; k < kRigidPivots; ++k) {
        store(view.slot_y + 8 * (step.slot + k), y[k]);
        for (int j = k + 1; j < kRigidPivots; ++j)
            y[j] -= load(panel + j * kRigidStride + 8 * k) * y[k];
    }
    const double* row = panel + kRigidPivots * kRigidStride;
    for (int i = 0; i < step.q; i += kTile, row += kTile * kRigidStride) {
        const int from = shift.earlier_tile(i / kTile);
        for (int a = 0; a < kTile; ++a) {
            V8 v = from >= 0 ? load(carried + 8 * (kTile * from + a)) : V8{};
            for (int k = 0; k < kRigidPivots; ++k) v -= load(row + a * kRigidStride + 8 * k) * y[k];
            store(next + 8 * (i + a), v);
        }
    }
}

/// Perform one step of backward_batch(), for rigid bodies.
/// @param behind  The first six entries are set to x of this body.
inline void backward_rigid(const FactorView& view, const BatchStep& step, const double* panel,
                           double* behind, double* x) {
    V8 z[kLanes] = {};
    for (int k = 0; k < kRigidPivots; ++k)
        z[k] =
            load(view.slot_y + 8 * (step.slot + k)) * load(view.slot_pivot + 8 * (step.slot + k));
    auto take_row = [&](int i) {
        const V8 b = load(behind + 8 * i);
        const double* row = panel + (kRigidPivots + i) * kRigidStride;
        for (int k = 0; k < kRigidPivots; ++k) z[k] -= load(row + 8 * k) * b;
    };
    // Process last the body that the previous step solved, if nothing else hides the wait.
    // Otherwise use the order of other steps.
    if constexpr (kManyRegisters) {
        for (int i = kRigidPivots; i < step.q; ++i) take_row(i);
        for (int i = 0; i < kRigidPivots; ++i) take_row(i);
    } else {
        for (int i = 0; i < step.q; ++i) take_row(i);
    }
#pragma GCC unroll 6
    for (int i = kRigidPivots - 1; i > 0; --i)
        for (int j = 0; j < i; ++j) z[j] -= load(panel + i * kRigidStride + 8 * j) * z[i];
    for (int k = 0; k < kRigidPivots; ++k) store(behind + 8 * k, z[k]);
    store_rigid(x, view.slot_index + 8 * step.slot, z);
}

}  // namespace

/// Compute y_p = L11⁻¹ (x_p + carried), carried −= L21 y_p.
void forward_batch(const FactorView& view, const Batch& batch, std::int32_t begin, std::int32_t end,
                   const double* x, double* scratch) noexcept {
    const long turned = (begin - batch.step_begin) % 2;
    double* carried = scratch + turned * 8 * batch.max_q;
    double* next = scratch + (1 - turned) * 8 * batch.max_q;
    Shift shift = shift_before(view, batch, begin);
    for (std::int32_t k = begin; k < end; ++k) {
        const BatchStep& step = view.batch_steps[k];
        if (view.distant && k + kPrefetchSteps < end)
            prefetch_panel(view.panel, view.batch_steps[k + kPrefetchSteps]);
        if (kRigidInRegisters && is_rigid(view, batch, k)) {
            forward_rigid(view, step, shift, x, carried, next);
            std::swap(carried, next);
            shift.before = step.q / kTile;
            continue;
        }
        const double* panel = view.panel + step.panel;
        double* y = view.slot_y + 8 * step.slot;
        const std::int32_t* index = view.slot_index + 8 * step.slot;
        const int p = step.p;
        for (int i = 0; i < p; ++i) {
            V8 v = gather_lanes(x, index + 8 * i);
            if (i < batch.body && shift.before > 0) v += load(carried + 8 * i);
            const double* row = panel + 8L * i * p;
            for (int j = 0; j < i; ++j) v -= load(row + 8 * j) * load(y + 8 * j);
            store(y + 8 * i, v);
        }
        for (int i = 0; i < step.q; i += kTile) {
            const int from = shift.earlier_tile(i / kTile);
            V8 v[kTile];
            for (int a = 0; a < kTile; ++a)
                v[a] = from >= 0 ? load(carried + 8 * (kTile * from + a)) : V8{};
            const double* row = panel + 8L * (p + i) * p;
            for (int j = 0; j < p; ++j) {
                const V8 u = load(y + 8 * j);
                for (int a = 0; a < kTile; ++a) v[a] -= load(row + 8L * a * p + 8 * j) * u;
            }
            for (int a = 0; a < kTile; ++a) store(next + 8 * (i + a), v[a]);
        }
        std::swap(carried, next);
        shift.before = step.q / kTile;
    }
    if (end < batch.step_end) return;
    for (int lane = 0; lane < factor::kLaneCount; ++lane) {
        if (batch.front[lane] < 0) continue;
        const Front& front = view.fronts[batch.front[lane]];
        const std::int32_t* slot = view.tail_slot + front.rows;
        for (int i = 0; i < front.q; ++i) view.carry[front.rows + i] = carried[8 * slot[i] + lane];
    }
}

/// Compute x_p = U11⁻¹ (D⁻¹ y_p − U12 x_behind). The panels contain Uᵀ; it equals L for a symmetric
/// batch.
void backward_batch(const FactorView& view, const Batch& batch, double* x,
                    double* scratch) noexcept {
    const double* halves = view.is_unsymmetric(batch.front[0]) ? view.upper : view.panel;
    double* behind = scratch;
    const int q = batch.max_q;
    for (int i = 0; i < q; ++i) store(behind + 8 * i, V8{});
    for (int lane = 0; lane < factor::kLaneCount; ++lane) {
        if (batch.front[lane] < 0) continue;
        const Front& front = view.fronts[batch.front[lane]];
        const std::int32_t* slot = view.tail_slot + front.rows;
        for (int i = 0; i < front.q; ++i) behind[8 * slot[i] + lane] = x[view.rows[front.rows + i]];
    }
    double* z = behind + 8 * q;
    for (std::int32_t k = batch.step_end; k-- > batch.step_begin;) {
        const BatchStep& step = view.batch_steps[k];
        if (view.distant && k - kPrefetchSteps >= batch.step_begin)
            prefetch_panel(halves, view.batch_steps[k - kPrefetchSteps]);
        const double* panel = halves + step.panel;
        if (kRigidInRegisters && batch.window == kRigidPivots && is_rigid(view, batch, k)) {
            backward_rigid(view, step, panel, behind, x);
            continue;
        }
        const double* y = view.slot_y + 8 * step.slot;
        const double* pivot = view.slot_pivot + 8 * step.slot;
        const int p = step.p;
        for (int j = 0; j < p; j += kTile)
            with_size(p - j, [&]<int N>() {
                V8 v[N];
                for (int a = 0; a < N; ++a)
                    v[a] = load(y + 8 * (j + a)) * load(pivot + 8 * (j + a));
                const double* column = panel + 8L * p * p + 8 * j;
                for (int i = 0; i < step.q; ++i, column += 8L * p) {
                    const V8 b = load(behind + 8 * i);
                    for (int a = 0; a < N; ++a) v[a] -= load(column + 8 * a) * b;
                }
                for (int a = 0; a < N; ++a) store(z + 8 * (j + a), v[a]);
            });
        for (int i = p; i-- > 0;) {
            const V8 zi = load(z + 8 * i);
            const double* row = panel + 8L * i * p;
            for (int j = 0; j < i; ++j) store(z + 8 * j, load(z + 8 * j) - load(row + 8 * j) * zi);
            scatter_lanes(x, view.slot_index + 8 * (step.slot + i), zi);
        }
        // Move this body to the front of the window.
        for (int i = batch.window; i-- > batch.body;)
            store(behind + 8 * i, load(behind + 8 * (i - batch.body)));
        for (int i = 0; i < batch.body; ++i) store(behind + 8 * i, load(z + 8 * i));
    }
}

}  // namespace hawser::HAWSER_ISA
