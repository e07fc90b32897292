// SPDX-License-Identifier: Apache-2.0
/// Loops over bodies: right-hand sides of the solver, residuals, norms, motion.
#include "assembly/geo.h"
#include "assembly/isa/coupled.h"
#include "assembly/isa/links.h"
#include "assembly/isa/rows.h"
#include "base/lanes.h"
#include "base/simd.h"

namespace hawser::HAWSER_ISA {
namespace {

using assembly::View;

/// Compute r = a − M̃ v₊ + Jᵀ y for the multipliers y of the rows. kAtRest: v₊ = 0, as before the
/// first solve.
template <bool kAtRest>
void momentum_rhs(const View& view, std::int32_t body, const double* y, double* out) {
    const int dof = view.dof[body];
    const double* v = view.v_new + view.dof_begin[body];
    double mv[8] = {};
    if constexpr (!kAtRest)
        block_times(view.body_block + assembly::block_offset(view.dof_begin[body]), dof, v, mv);
    V8 acc = load_at_least(view.a + view.dof_begin[body], dof);
    const std::int32_t end = view.incident_begin[body + 1];
    for (std::int32_t k = view.incident_begin[body]; k < end; ++k) {
        const assembly::Incidence& in = view.incident[k];
        const double* jac = view.jacobian + in.jacobian;
        const double* yr = y + in.row;
        if (in.width == 0) {  // compact joint
            const double sign = in.slot == 0 ? -1.0 : 1.0;
            const V3 p = sign * load3(yr);
            V3 turn = cross(load3(jac), p);
            if (!kAtRest) turn = turn + sign * load3(view.geo_force + in.geo_force);
            acc += V8{p.x, p.y, p.z, turn.x, turn.y, turn.z, 0.0, 0.0};
            continue;
        }
        for (int r = 0; r < in.rows; ++r) acc += yr[r] * load_at_least(jac + r * in.width, dof);
        if (kAtRest || in.geo_force < 0) continue;
        const V8 force = load_at_least(view.geo_force + in.geo_force, dof);
        if (in.geo_arm < 0 && in.slot == 1)
            acc += force;
        else
            acc -= force;
    }
    if (view.contact_impulse)
        acc += load_at_least(view.contact_impulse + view.dof_begin[body], dof);
    double sum8[8];
    store(sum8, acc);
    // Process entry by entry: reading mv as a vector would wait for its scalar stores.
    for (int j = 0; j < dof; ++j) out[j] = sum8[j] - mv[j];
    if (kAtRest || view.coupled == nullptr) return;
    if (const double* b = coupled_block(view, body)) subtract_coupled(b, v, out);
}

/// Write the right-hand sides of eight links to the vector of the solver.
template <bool kAtRest>
void links_rhs(const View& view, std::int32_t body, const double* y) {
    V8 out[kLanes];
    eight_rhs<kAtRest>(view, body, y, out);
    transpose(out);
    for (int l = 0; l < kLanes; ++l)
        store_lanes(view.solution + view.body_offset[body + l], out[l], 0, 6);
    if (kAtRest || !any_coupled(view, body, kLanes)) return;
    for (std::int32_t k = body; k < body + kLanes; ++k)
        if (const double* b = coupled_block(view, k))
            subtract_coupled(b, view.v_new + view.dof_begin[k],
                             view.solution + view.body_offset[k]);
}

}  // namespace

void first_rhs(const View& view, std::int32_t begin, std::int32_t end, bool moving) noexcept {
    for (std::int32_t id = begin; id < end; ++id) {
        if (id + kLanes <= end && eight_arms(view, id)) {
            first_joints_rhs(view, id, moving);
            id += kLanes - 1;
            continue;
        }
        const std::int32_t row = view.row_begin[id];
        const double on = view.active[id];
        // Read `held` only if the row is inactive, like Σ: most rows are active.
        const double held = on == 0.0 ? view.held[id] : 0.0;
        for (int r = 0; r < view.rows[id]; ++r) {
            const double inactive = r == 0 ? held : 0.0;
            const double speed = moving ? view.residual[row + r] : 0.0;
            const double right_side = on * (view.c[row + r] - speed);
            double residual = right_side;
            if (held != 0.0) residual += view.sigma[row + r] * inactive;
            view.residual[row + r] = residual;
            view.multiplier[row + r] = view.inv_sigma[row + r] * right_side + inactive;
            if (view.interaction_offset[id] >= 0)
                view.solution[view.interaction_offset[id] + r] = residual;
        }
    }
}

void first_body_rhs(const View& view, std::int32_t begin, std::int32_t end, bool moving) noexcept {
    for (std::int32_t body = begin; body < end; ++body) {
        if (view.dof[body] == 0) continue;
        const std::int32_t first = links_with(view, begin, body, end);
        const std::int32_t place = view.dof_begin[first >= 0 ? first : body];
        double* v = view.v_new + place;
        const double* start = view.v_start + place;
        if (first >= 0) {
            for (int j = 0; j < 6 * kLanes; ++j) v[j] = moving ? start[j] : 0.0;
            if (moving)
                links_rhs<false>(view, first, view.multiplier);
            else
                links_rhs<true>(view, first, view.multiplier);
            body = first + kLanes - 1;
            continue;
        }
        double* rhs = view.solution + view.body_offset[body];
        for (int j = 0; j < view.dof[body]; ++j) v[j] = moving ? start[j] : 0.0;
        if (moving)
            momentum_rhs<false>(view, body, view.multiplier, rhs);
        else
            momentum_rhs<true>(view, body, view.multiplier, rhs);
    }
}

void body_rhs(const View& view, std::int32_t begin, std::int32_t end) noexcept {
    for (std::int32_t body = begin; body < end; ++body) {
        const std::int32_t first = links_with(view, begin, body, end);
        if (first >= 0) {
            links_rhs<false>(view, first, view.multiplier);
            body = first + kLanes - 1;
        } else if (view.dof[body] > 0) {
            momentum_rhs<false>(view, body, view.multiplier,
                                view.solution + view.body_offset[body]);
        }
    }
}

void momentum_residual(const View& view, std::int32_t body, double* out) noexcept {
    momentum_rhs<false>(view, body, view.lambda, out);
}

void add_solution(const View& view, std::int32_t begin, std::int32_t end) noexcept {
    for (std::int32_t body = begin; body < end; ++body) {
        const double* s = view.solution + view.body_offset[body];
        double* v = view.v_new + view.dof_begin[body];
        for (int j = 0; j < view.dof[body]; ++j) v[j] += s[j];
    }
}

extern const assembly::Kernels kAssemblyKernels;
const assembly::Kernels kAssemblyKernels = {
    evaluate,   complete_rows, complete_spins,     adopt_completed, adopt_spins,
    body_terms, gather_blocks, gather_lane_blocks, first_rhs,       first_body_rhs,
    body_rhs,   add_solution,  row_update,         body_norms,      row_norms,
    row_losses, line_gains,    rigid_energies,     widest_row,      integrate};

}  // namespace hawser::HAWSER_ISA
