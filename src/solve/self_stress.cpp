// SPDX-License-Identifier: Apache-2.0
#include "solve/self_stress.h"

#include "assembly/rows.h"
#include "base/index.h"
#include "context/timer.h"
#include "context/view.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace hawser::solve {
namespace {

using assembly::View;

/// Return a pseudo-random number in [−½, ½) for a row, equal on every machine.
double pseudo_random_impulse(std::int32_t row) noexcept {
    std::uint64_t x = static_cast<std::uint64_t>(row) + 1;
    x *= 0x9e3779b97f4a7c15;  // J. S. Steele et al., SplitMix (2014)
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return static_cast<double>((x ^ (x >> 31)) >> 11) * 0x1p-53 - 0.5;
}

constexpr double kDrawnSquare = 1.0 / 12.0;  ///< Mean square of pseudo_random_impulse().

/// Magnitudes of the momentum of joint impulses: of the sum over bodies, and of each joint's part.
struct MomentumNorms {
    double sum = 0.0, parts = 0.0;  ///< Squares.
};

/// Write the momentum Gᵀλ of impulses of joints into the solver's vector. @param lambda  Function
/// (interaction, row) that returns an impulse.
template <class Lambda>
MomentumNorms load_joints(const context::Model& model, context::SolveWork& solve, const View& v,
                          Lambda lambda) noexcept {
    MomentumNorms size;
    std::fill_n(v.solution, model.system.symbolic.scalars, 0.0);
    for (const std::int32_t id : model.completion.looped) {
        double buffer[model::kArmBufferSize];
        const double* jac = packed_rows(v, id, buffer);
        for (int r = 0; r < v.rows[id]; ++r) {
            const double push = lambda(id, v.row_begin[id] + r);
            for (int b = 0; b < v.bodies[id]; ++b) {
                const std::int32_t body = v.body[kMaxInteractionBodies * id + b];
                for (int j = 0; j < v.dof[body]; ++j) {
                    const double part = push * *jac++;
                    size.parts += part * part;
                    v.solution[v.body_offset[body] + j] += part;
                }
            }
        }
    }
    solve.rhs_ready = false;
    for (std::int32_t i = 0; i < model.system.symbolic.scalars; ++i)
        size.sum += v.solution[i] * v.solution[i];
    return size;
}

/// Solve K [u; −λ'] = [Gᵀλ; 0] in place for u and the filtered impulses λ', after load_joints().
void solve_loaded(context::StepContext& ctx, const View& v) noexcept {
    const context::StageTimer timer(ctx, Stage::factor);
    ctx.model.system.numeric.solve(ctx.model.system.symbolic, v.solution, ctx.pool);
    ++ctx.work.stats.substitutions;
}

/// Read the filtered impulses λ' of the rows of one joint from the solution of solve_loaded().
void read_filtered(const View& v, std::int32_t id, double* out) noexcept {
    double buffer[model::kArmBufferSize];
    const double* jac = packed_rows(v, id, buffer);
    for (int r = 0; r < v.rows[id]; ++r) {
        const double speed = assembly::along_row(v, id, jac, v.solution, v.body_offset);
        out[r] = v.interaction_offset[id] >= 0 ? v.solution[v.interaction_offset[id] + r]
                                               : speed * v.inv_sigma[v.row_begin[id] + r];
    }
}

constexpr double kMinChangedFraction =
    0.01;  ///< Fraction of a joint's impulse below which changes are ignored.

/// Return true if the filter changes the impulse λ(row) of a joint by more than
/// kMinChangedFraction.
/// @param kept  Output: the filtered impulse.
template <class Lambda>
bool is_changed(const View& v, std::int32_t id, Lambda lambda, double* kept) noexcept {
    double all = 0.0, less = 0.0;
    read_filtered(v, id, kept);
    for (int r = 0; r < v.rows[id]; ++r) {
        const double whole = lambda(id, v.row_begin[id] + r), d = whole - kept[r];
        all += whole * whole;
        less += d * d;
    }
    return less > kMinChangedFraction * kMinChangedFraction * all;
}

/// Correct the impulses `taken`, which will be removed, so that their removal changes no momentum:
/// Gᵀ `taken` = 0. After one substitution a residual momentum remains, which the bodies would lose.
/// The filter, applied to `taken`, returns the part that must not be removed.
void keep_momentum(context::StepContext& ctx, const View& v) noexcept {
    constexpr double kMaxResidualMomentum = 1e-11;  ///< Relative to the impulses.
    constexpr int kFilterPasses = 2;
    double* stress_of_row = ctx.work.joints.taken.data();
    const auto loss = [&](std::int32_t, std::int32_t row) noexcept { return stress_of_row[row]; };
    for (int pass = 0; pass < kFilterPasses; ++pass) {
        const MomentumNorms size = load_joints(ctx.model, ctx.work.solve, v, loss);
        if (!(size.sum > kMaxResidualMomentum * kMaxResidualMomentum * size.parts)) return;
        solve_loaded(ctx, v);
        for (const std::int32_t id : ctx.model.completion.looped) {
            double kept[kMaxInteractionRows];
            read_filtered(v, id, kept);
            for (int r = 0; r < v.rows[id]; ++r) stress_of_row[v.row_begin[id] + r] -= kept[r];
        }
    }
}

/// Filter the impulses `taken` once more and replace them by the part that the filter removes.
/// Clear the mark "redundant" of each joint whose removed part is at most the fraction
/// kMinChangedFraction of its random impulse.
/// @return true if any marked joint remains.
bool filter_again(context::StepContext& ctx, const View& v) noexcept {
    double* lost = ctx.work.joints.taken.data();
    (void)load_joints(ctx.model, ctx.work.solve, v,
                      [&](std::int32_t, std::int32_t row) noexcept { return lost[row]; });
    solve_loaded(ctx, v);
    bool any = false;
    for (const std::int32_t id : ctx.model.completion.looped) {
        double kept[kMaxInteractionRows], all = 0.0, less = 0.0;
        read_filtered(v, id, kept);
        for (int r = 0; r < v.rows[id]; ++r) {
            const std::int32_t row = v.row_begin[id] + r;
            lost[row] -= kept[r];
            less += lost[row] * lost[row];
            all += pseudo_random_impulse(row) * pseudo_random_impulse(row);
        }
        std::uint8_t& repeats = ctx.model.interactions.repeats[at(id)];
        if (!(less >
              kMinChangedFraction * kMinChangedFraction * std::max(all, v.rows[id] * kDrawnSquare)))
            repeats = 0;
        any |= repeats != 0;
    }
    return any;
}

/// Find the joints in closed loops that are redundant at the present poses.
///
/// Each joint gets a random impulse, and the impulses are filtered in two passes. The second pass
/// filters the part that the first one removed. A joint is redundant if each pass removes more than
/// the fraction kMinChangedFraction. Impulses that move no body are removed entirely in each pass.
/// For soft modes of long chains the first pass removes a fraction because of Σ, and the second
/// pass a smaller one.
///
/// Some of many random impulses are almost zero. The removed part is therefore compared with at
/// least the mean impulse. Otherwise one joint in thousands would count as redundant if a
/// thousandth is removed.
void probe_loops(context::StepContext& ctx) noexcept {
    const View v = context::view(ctx);
    for (const std::int32_t id : ctx.model.completion.looped) {
        ctx.model.interactions.repeats[at(id)] = 1;
        for (int r = v.row_begin[id]; r < v.row_begin[id] + v.rows[id]; ++r)
            ctx.work.joints.taken[at(r)] = pseudo_random_impulse(r);
    }
    constexpr int kPasses = 2;
    for (int pass = 0; pass < kPasses; ++pass)
        if (!filter_again(ctx, v)) return;
}

}  // namespace

void take_self_stress(context::StepContext& ctx) noexcept {
    constexpr std::int64_t kStepsBetweenProbes = 16;  // steps: loops become singular gradually
    const std::vector<std::int32_t>& looped = ctx.model.completion.looped;
    if (looped.empty()) return;
    if (!ctx.state.started || ctx.state.step % kStepsBetweenProbes == 0) probe_loops(ctx);
    std::uint8_t* repeats = ctx.model.interactions.repeats.data();
    if (std::none_of(looped.begin(), looped.end(), [&](std::int32_t id) { return repeats[id]; }))
        return;
    const View v = context::view(ctx);
    const auto impulse = [&](std::int32_t id, std::int32_t row) noexcept {
        return repeats[id] ? v.lambda[row] : 0.0;
    };
    (void)load_joints(ctx.model, ctx.work.solve, v, impulse);
    solve_loaded(ctx, v);
    double* stress_of_row = ctx.work.joints.taken.data();
    std::fill_n(stress_of_row, ctx.work.joints.taken.size(), 0.0);
    for (const std::int32_t id : looped) {
        double kept[kMaxInteractionRows];
        if (!repeats[id] || !is_changed(v, id, impulse, kept)) continue;
        ++ctx.work.stats.undetermined;
        for (int r = 0; r < v.rows[id]; ++r)
            stress_of_row[v.row_begin[id] + r] = v.lambda[v.row_begin[id] + r] - kept[r];
    }
    keep_momentum(ctx, v);
    for (const std::int32_t id : looped)
        for (int r = 0; r < v.rows[id]; ++r) {
            const std::int32_t row = v.row_begin[id] + r;
            // The resulting defect of the row's equation is not a residual, because the impulse
            // moves nothing.
            v.residual[row] += v.sigma[row] * stress_of_row[row];
            v.lambda[row] -= stress_of_row[row];
        }
}

}  // namespace hawser::solve
