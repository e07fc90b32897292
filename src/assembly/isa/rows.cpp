// SPDX-License-Identifier: Apache-2.0
/// Violation, Jacobian and right-hand side of every row; residuals and multipliers.
#include "assembly/isa/rows.h"

#include "assembly/geo.h"
#include "assembly/isa/lane_rows.h"
#include "base/simd.h"
#include "model/kinds/all.h"

namespace hawser::HAWSER_ISA {
namespace {

using assembly::View;

constexpr int kSlots = kMaxInteractionBodies;

/// Velocity of a slot from a packed array; bodies without freedom use v_fixed.
void slot_velocity(const View& view, const double* v, std::int32_t body, V3& lin, V3& ang) {
    const int dof = view.dof[body];
    const double* given = v == view.v ? view.v_before : view.v_fixed;
    const double* p = dof == 0 ? given + 6 * body : v + view.dof_begin[body];
    lin = dof == 1 ? V3{0, 0, 0} : load3(p);
    ang = dof == 6 || dof == 0 ? load3(p + 3) : V3{0, 0, 0};
}

/// An interaction's part of M̃ v on its two bodies, see geo.h; with `damping`, as geo_product(), of
/// a. @param from  0 or dof: which half of a slot, see GeoPlace.
inline void geo_force(const View& view, std::int32_t id, const double* v, double damping = 1.0,
                      int from = 0) {
    const assembly::GeoPlace& place = view.geo[id];
    const double* rec = view.geo_record + place.record;
    double* out[2] = {view.geo_force + place.slot(0) + from, view.geo_force + place.slot(1) + from};
    const std::int32_t* body = view.body + kSlots * id;
    if (place.dof == 3) {  // no arms
        const V3 u = load3(rec + 1);
        V3 lin[2], ang;
        for (int b = 0; b < 2; ++b) slot_velocity(view, v, body[b], lin[b], ang);
        const V3 rel = lin[0] - lin[1], t = rec[0] * (rel - dot(u, rel) * u);
        store3(out[0], t);
        store3(out[1], -t);
        return;
    }
    if (rec[0] == 0.0 && rec[22] == 0.0) {
        for (double* o : out)
            for (int i = 0; i < 6; ++i) o[i] = 0.0;
        return;
    }
    if (rec[0] == 0.0) {  // damping of a joint between two rigid bodies
        const V3 d = (damping * rec[22]) * (load3(v + view.dof_begin[body[0]] + 3) -
                                            load3(v + view.dof_begin[body[1]] + 3));
        store3(out[0], {0, 0, 0});
        store3(out[0] + 3, d);
        store3(out[1], {0, 0, 0});
        store3(out[1] + 3, -d);
        return;
    }
    V3 lin[2], ang[2];
    for (int b = 0; b < 2; ++b) slot_velocity(view, v, body[b], lin[b], ang[b]);
    geo_product(rec, lin, ang, damping, out[0], out[1]);
}

/// Force on slot b at the joint's point: the first three rows are translations along ±E. @return by
/// how much less the damping of the record acts on the velocity before the step.
template <class K>
double geometry(const View& view, const typename K::Data& data, const BodyRef* refs,
                std::int32_t id, const Rows<K::kBodies, K::kRows>& rows) {
    const assembly::GeoPlace& place = view.geo[id];
    if (place.record < 0) return 1.0;
    double* rec = view.geo_record + place.record;
    const std::int32_t* body = view.body + kSlots * id;
    const bool rigid0 = view.dof[body[0]] == 6, rigid1 = view.dof[body[1]] == 6;
    const int size = place.dof == 3 ? assembly::kGeoLine : assembly::kGeoSwing;
    for (int i = 0; i < size; ++i) rec[i] = 0.0;
    if (view.geometric_stiffness == 0.0 && view.rotation_damping == 0.0) return 1.0;
    if (view.active[id] == 0.0) return 1.0;
    const double scale = 0.25 * view.h * view.h * view.geometric_stiffness;
    const double per_h = 1.0 / view.h;
    const double* lambda = view.lambda + view.row_begin[id];
    const V3 r0 = refs[0].arm(data.point[0]), r1 = refs[1].arm(data.point[1]);
    V3 f1;  // force on body 1
    if constexpr (K::kGeometry == Geometry::line) {
        const V3 u = load3(rows.J[1][0]);
        const double tension = -lambda[0] * per_h;
        // Compression has a negative geometric stiffness: left out, so that M̃ stays positive.
        if (!(tension > 0.0)) return 1.0;
        const double length = norm(refs[1].x + r1 - refs[0].x - r0);
        rec[0] = scale * tension / (length > 1e-9 ? length : 1e-9);
        store3(rec + 1, u);
        f1 = -tension * u;
    } else {
        f1 = per_h * load3(lambda);
    }
    if (place.dof == 3) return 1.0;
    store3(rec + 4, r0);
    store3(rec + 7, r1);
    if (!rigid0 && !rigid1) return 1.0;
    const double nf = norm(f1), n0 = norm(r0), n1 = norm(r1);
    const double push = view.h * view.h * nf, s = 4.0 * push * rec[assembly::kGeoSwing];
    const bool joint = K::kGeometry == Geometry::joint && rigid0 && rigid1;
    const double fast = joint ? unresolved(s) : 0.0, stiff = scale * (1.0 + kMoreStiffness * fast);
    if (rigid0) arm_stiffness(-f1, nf, r0, n0, stiff, rec + 10);
    if (rigid1) arm_stiffness(f1, nf, r1, n1, stiff, rec + 16);
    if (joint) {
        const double need = s < 1.0 ? s * s : 1.0 + kMoreDamping * fast;
        rec[22] = push * view.rotation_damping * (n0 < n1 ? n0 : n1) * need * (1.0 + fast);
    }
    return (1.0 - fast) / (1.0 + fast);
}

template <class K>
void evaluate_kind(const View& view, const std::int32_t* ids, const void* data_in,
                   std::int32_t begin, std::int32_t end) {
    constexpr int B = K::kBodies, R = K::kRows;
    const auto* data = static_cast<const typename K::Data*>(data_in);
    const double inv_h4 = 4.0 / view.h;
    for (std::int32_t k = begin; k < end; ++k) {
        if constexpr (requires { K::kLaneDof; }) {
            LaneRows<K> lanes(view);
            if (k + kLanes <= end && lanes.take(ids + k)) {
                lanes.evaluate(data + k);
                k += kLanes - 1;
                continue;
            }
        }
        const std::int32_t id = ids[k];
        const std::int32_t* body = view.body + kSlots * id;
        BodyRef refs[B];
        for (int b = 0; b < B; ++b) {
            const std::int32_t i = body[b];
            refs[b] = {load3(view.x + 3 * i), view.r + 9 * i, view.dof[i] == 6 || view.dof[i] == 0};
        }
        Rows<B, R> rows;
        K::evaluate(data[k], refs, rows);

        // Speeds of the rows, and the packed Jacobian.
        double speed[R] = {}, start[R] = {}, prescribed[R] = {}, before[R] = {};
        int width = 0;
        for (int b = 0; b < B; ++b) width += view.dof[body[b]];
        double* out = view.jacobian + view.jac_begin[id];
        int at = 0;
        for (int b = 0; b < B; ++b) {
            const std::int32_t i = body[b];
            const int dof = view.dof[i];
            if (dof == 0) {
                const double* u = view.v_fixed + 6 * i;
                const double* u_before = view.v_before + 6 * i;
                for (int r = 0; r < R; ++r)
                    for (int j = 0; j < 6; ++j) {
                        prescribed[r] += rows.J[b][r][j] * u[j];
                        before[r] += rows.J[b][r][j] * u_before[j];
                    }
                continue;
            }
            const double* v = view.v + view.dof_begin[i];
            const double* v_start = view.v_start + view.dof_begin[i];
            auto pack = [&]<int N>() {
                for (int r = 0; r < R; ++r)
                    for (int j = 0; j < N; ++j) {
                        const double value = rows.J[b][r][j];
                        out[r * width + at + j] = value;
                        speed[r] += value * v[j];
                        start[r] += value * v_start[j];
                    }
            };
            if (dof == 6)
                pack.template operator()<6>();
            else if (dof == 3)
                pack.template operator()<3>();
            else
                pack.template operator()<1>();
            at += dof;
        }
        const std::int32_t row = view.row_begin[id];
        for (int r = 0; r < R; ++r) {
            const double ups = view.upsilon[row + r];
            view.residual[row + r] = start[r];
            if (view.row_flags[row + r] & 1) {  // velocity row
                view.g[row + r] = 0.0;
                view.c[row + r] = rows.g[r] - prescribed[r];
            } else {
                view.g[row + r] = rows.g[r];
                view.c[row + r] = ups * (speed[r] + before[r] - inv_h4 * rows.g[r]) - prescribed[r];
                // What slid has no memory of its speed: it is to stop.
                if (view.flags[id] & 128)
                    view.c[row + r] -= (1.0 - view.active[id]) * ups * speed[r];
                if (view.flags[id] & 1) {
                    view.c[row + r] += when_slack(rows.g[r], speed[r] + before[r], ups, view.h);
                }
            }
        }
        if (view.flags[id] & 2) view.active[id] = rows.g[0] != 0.0 ? 1.0 : 0.0;  // range
        if (view.parted[id]) view.active[id] = 0.0;
        if constexpr (K::kGeometry != Geometry::none) {
            const double back = geometry<K>(view, data[k], refs, id, rows);
            if (view.geo[id].record >= 0) {
                geo_force(view, id, view.v, -back, view.geo[id].dof);
                geo_force(view, id, view.v_start);
            }
        }
    }
}

/// G u of one interaction for a packed vector u by body, R rows: one a lane, 0 in the others.
template <int R, class Offset>
inline V8 row_products(const View& view, std::int32_t id, const double* u, Offset offset) {
    const std::int32_t* body = view.body + kSlots * id;
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

/// λ and the residuals of one interaction, a row in each lane.
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
    // The first residual is that of the velocities at the start and of λ = 0.
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
}

}  // namespace

void evaluate(const View& view, InteractionKind kind, const std::int32_t* ids, const void* data,
              std::int32_t begin, std::int32_t end) noexcept {
    with_kind(kind, [&]<class K>() { evaluate_kind<K>(view, ids, data, begin, end); });
}

void row_update(const View& view, std::int32_t begin, std::int32_t end, bool first) noexcept {
    for (std::int32_t id = begin; id < end; ++id) {
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
}

void row_norms(const View& view, std::int32_t begin, std::int32_t end,
               assembly::Norms* norms) noexcept {
    assembly::Norms n = *norms;
    for (std::int32_t id = begin; id < end; ++id) {
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
        if (view.inv_length[id] > 0.0 && view.active[id] != 0.0) {
            const double force = view.lambda[row] / view.h;
            const double error = view.g[row] + view.epsilon[row] * force;
            const double relative = __builtin_fabs(error) * view.inv_length[id];
            if (!(relative <= n.stretch)) n.stretch = relative;
        }
    }
    *norms = n;
}

}  // namespace hawser::HAWSER_ISA
