// SPDX-License-Identifier: Apache-2.0
/// Multipliers, residuals and norms of rows.
#include "assembly/isa/arms.h"
#include "assembly/isa/geo_force.h"
#include "assembly/isa/node_rows.h"
#include "assembly/isa/rows.h"
#include "base/lanes.h"
#include "base/simd.h"

namespace hawser::HAWSER_ISA {
namespace {

using assembly::View;

constexpr int kSlots = kMaxInteractionBodies;

/// Compute G u of one interaction for a packed vector u by body. Lane r contains row r of R rows;
/// the other lanes are 0.
template <int R, class Offset>
inline V8 row_products(const View& view, std::int32_t id, const double* u, Offset offset) {
    const std::int32_t* body = view.body + kSlots * id;
    if (R == model::kArmRows && view.arms[id]) {
        const ArmsT<double> arms = load_arms(view.jacobian + view.jac_begin[id]);
        const double *u0 = u + offset(body[0]), *u1 = u + offset(body[1]);
        const V3 p =
            load3(u1) - load3(u0) + cross(load3(u1 + 3), arms.r1) - cross(load3(u0 + 3), arms.r0);
        return V8{p.x, p.y, p.z, 0.0, 0.0, 0.0, 0.0, 0.0};
    }
    int width = 0;
    for (int b = 0; b < view.bodies[id]; ++b) width += view.dof[body[b]];
    V8 acc[R] = {};
    const double* jac = view.jacobian + view.jac_begin[id];
    for (int b = 0; b < view.bodies[id]; ++b) {
        const int dof = view.dof[body[b]];
        if (dof == 0) continue;
        const V8 v = first_lanes(load_at_least(u + offset(body[b]), dof), dof);
        for (int r = 0; r < R; ++r) acc[r] += load(jac + r * width) * v;
        jac += dof;
    }
    return sums<R>(acc);
}

/// Update λ and the residuals of one interaction, one row per lane.
template <int R>
inline void row_update_one(const View& view, std::int32_t id, bool first) {
    const std::int32_t row = view.row_begin[id], offset = view.interaction_offset[id];
    const double on = view.active[id];
    const V8 kept = first_lanes(V8{} + (1.0 - on) * view.held[id], 1);
    const V8 sigma = load_first(view.sigma + row, R), last = load_first(view.residual + row, R);
    V8 change{}, total{};
    if (first || offset < 0)
        change = row_products<R>(view, id, view.solution,
                                 [&](std::int32_t b) { return view.body_offset[b]; });
    if (!first)
        total = on * (load_first(view.c + row, R) -
                      row_products<R>(view, id, view.v_new,
                                      [&](std::int32_t b) { return view.dof_begin[b]; }));
    // The first residual is that of the initial velocities and λ = 0.
    const auto left = [&](const V8& lambda) {
        return first ? last - on * change - sigma * lambda : total - sigma * (lambda - kept);
    };
    if (offset >= 0) {
        const V8 before = first ? V8{} : load_first(view.lambda + row, R);
        const V8 lambda = before - load_first(view.solution + offset, R);
        const V8 residual = left(lambda);
        store_lanes(view.lambda + row, lambda, 0, R);
        store_lanes(view.residual + row, residual, 0, R);
        store_lanes(view.multiplier + row, on * lambda + kept, 0, R);
        store_lanes(view.solution + offset, residual, 0, R);
        return;
    }
    const V8 inverse = load_first(view.inv_sigma + row, R);
    const V8 before = first ? kept : load_first(view.lambda + row, R);
    const V8 lambda = before + on * inverse * (last - change);
    const V8 residual = left(lambda);
    store_lanes(view.lambda + row, lambda, 0, R);
    store_lanes(view.residual + row, residual, 0, R);
    store_lanes(view.multiplier + row, on * (lambda + inverse * residual) + kept, 0, R);
}

template <int R>
inline void row_update_of(const View& view, std::int32_t id, bool first) {
    row_update_one<R>(view, id, first);
    if (view.geo[id].record >= 0) geo_force(view, id, view.v_new);
    if (R != model::kArmRows || view.arms[id] == 0) return;
    const std::int32_t* body = view.body + kSlots * id;
    const double damping = view.jacobian[view.jac_begin[id] + model::kArmsDamping];
    store3(view.geo_force + view.geo[id].force,
           damping * (load3(view.v_new + view.dof_begin[body[0]] + 3) -
                      load3(view.v_new + view.dof_begin[body[1]] + 3)));
}

}  // namespace

void row_update(const View& view, std::int32_t begin, std::int32_t end, bool first) noexcept {
    using Lines = NodeRows<1, 2>;
    using Bends = NodeRows<2, 3>;
    Lines lines(view, first);
    Bends bends(view, first);
    for (std::int32_t id = begin; id < end; ++id) {
        if (id + kLanes <= end && eight_arms(view, id)) {
            eight_joints(view, id, first);
            id += kLanes - 1;
            continue;
        }
        if (Lines::accepts(view, id)) {
            lines.add(id);
            continue;
        }
        if (Bends::accepts(view, id)) {
            bends.add(id);
            continue;
        }
        switch (view.rows[id]) {
            case 1:
                row_update_of<1>(view, id, first);
                break;
            case 2:
                row_update_of<2>(view, id, first);
                break;
            case 3:
                row_update_of<3>(view, id, first);
                break;
            case 4:
                row_update_of<4>(view, id, first);
                break;
            case 5:
                row_update_of<5>(view, id, first);
                break;
            default:
                row_update_of<6>(view, id, first);
                break;
        }
    }
    lines.finish();
    bends.finish();
}

void row_norms(const View& view, std::int32_t begin, std::int32_t end,
               assembly::Norms* norms) noexcept {
    assembly::Norms n = *norms;
    for (std::int32_t id = begin; id < end; ++id) {
        if (id + kLanes <= end && eight_arms(view, id) && add_joint_norms(view, id, n)) {
            id += kLanes - 1;
            continue;
        }
        const std::int32_t row = view.row_begin[id];
        for (int r = 0; r < view.rows[id]; ++r) {
            const double residual = __builtin_fabs(view.residual[row + r]);
            if (!(residual <= n.constraint)) n.constraint = residual;
            n.finite += view.lambda[row + r];
            const double gap = __builtin_fabs(view.g[row + r]);
            if ((view.row_flags[row + r] & 2) && !(gap <= n.gap)) {
                n.gap = gap;
                n.gap_id = id;
            }
        }
        if (view.rest_length[id] > 0.0 && view.active[id] != 0.0) {
            const double force = view.lambda[row] / view.h;
            const double error = view.g[row] + view.epsilon[row] * force;
            const double relative = __builtin_fabs(error) / view.rest_length[id];
            if (!(relative <= n.stretch)) n.stretch = relative;
        }
    }
    *norms = n;
}

}  // namespace hawser::HAWSER_ISA
