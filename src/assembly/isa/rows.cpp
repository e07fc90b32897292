// SPDX-License-Identifier: Apache-2.0
/// Violation, Jacobian and right-hand side of every row.
#include "assembly/isa/rows.h"

#include "assembly/geo.h"
#include "assembly/isa/geo_force.h"
#include "assembly/isa/joint_rows.h"
#include "assembly/isa/lane_rows.h"
#include "assembly/isa/slack.h"
#include "base/simd.h"
#include "model/kinds/all.h"

#include <algorithm>

namespace hawser::HAWSER_ISA {
namespace {

using assembly::View;

constexpr int kSlots = kMaxInteractionBodies;

/// True if joints of the kind may have an arms record instead of a Jacobian (model/arms.h).
template <class K>
constexpr bool kCompactKind = requires { requires K::kMayBeCompact; };

/// True if the kind is the range of a joint (kinds/drives.h).
template <class K>
constexpr bool kHasEnds = requires { &K::evaluate_ends; };

/// Return the fraction of the geometric stiffness that is used for an interaction whose force has
/// the magnitude nf.
double fade(const View& view, std::int32_t id, double nf) {
    if (!view.completed[id]) return 1.0;
    return completed_stiffness(4.0 * view.h * view.h * nf * view.vibration[id]);
}

/// Return the fraction of the geometric stiffness of a line between turning bodies without point
/// masses. It vanishes if the vibration is resolved, because the stiffness preserves angular
/// momentum to second order only. @param s  As in across_fractions().
double line_fade(const View& view, const std::int32_t* body, double s) {
    for (int b = 0; b < 2; ++b)
        if (view.dof[body[b]] == 3 || view.dof[body[b]] == 1) return 1.0;
    return s < 0.25 ? 16.0 * s * s : 1.0;
}

/// Vectors from the centres of the first two bodies to the points at which the interaction acts.
template <class K>
struct Arms {
    V3 at[2];
    Arms(const typename K::Data& data, const BodyRef* refs) {
        if constexpr (requires { K::line_arms(data, refs, at); })
            K::line_arms(data, refs, at);
        else
            for (int k = 0; k < 2; ++k) at[k] = refs[k].arm(data.point[k]);
    }
};

/// Compute the record of geometric stiffness of an interaction. The force on slot b acts at the
/// point of the joint, since its first three rows are translations along ±E. @return for a joint:
/// factor by which the damping of the record is reduced for the velocity before the step. For a
/// line: fraction of K in its record that acts on that velocity; the rest acts on the extrapolated
/// one.
template <class K>
double geometry(const View& view, const typename K::Data& data, const BodyRef* refs,
                std::int32_t id, const Rows<K::kBodies, K::kRows>& rows) {
    const assembly::GeoSlot& place = view.geo[id];
    if (place.record < 0) return 1.0;
    double* rec = view.geo_record + place.record;
    const std::int32_t* body = view.body + kSlots * id;
    const bool rigid0 = view.dof[body[0]] == 6, rigid1 = view.dof[body[1]] == 6;
    const int size = place.dof == 3 ? assembly::kGeoLine : assembly::kGeoVibration;
    for (int i = 0; i < size; ++i) rec[i] = 0.0;
    if constexpr (K::kGeometry == Geometry::line) {
        store3(rec + 1, load3(rows.J[1][0]));
        if (place.dof == 6) {
            const Arms<K> arm(data, refs);
            store3(rec + 4, arm.at[0]);
            store3(rec + 7, arm.at[1]);
        }
    }
    if (view.geometric_stiffness == 0.0 && view.rotation_damping == 0.0) return 1.0;
    if (view.active[id] == 0.0) return 1.0;
    const double scale = 0.25 * view.h * view.h * view.geometric_stiffness;
    const double per_h = 1.0 / view.h;
    const double* lambda = view.lambda + view.row_begin[id];
    const Arms<K> arm(data, refs);
    const V3 r0 = arm.at[0], r1 = arm.at[1];
    double fraction = 1.0, resolved = 1.0;
    V3 f1;  // force on body 1
    if constexpr (K::kGeometry == Geometry::line) {
        const V3 u = load3(rows.J[1][0]);
        const double tension = -lambda[0] * per_h;
        // Compression has a negative geometric stiffness. It is omitted, so that M̃ stays positive.
        if (!(tension > 0.0)) return 1.0;
        const double length = norm(refs[1].x + r1 - refs[0].x - r0);
        const double full =
            4.0 * scale * fade(view, id, tension) * tension / (length > 1e-9 ? length : 1e-9);
        const double s = full * view.lightness[id];
        // Bodies that turn with a line between two rigid bodies would lose momentum.
        const auto [late, ahead] = across_fractions(rigid0 && rigid1 ? 0.0 : s, view.flagged[id]);
        resolved = line_fade(view, body, s);
        rec[0] = resolved * (late + ahead) * full;
        fraction = late / (late + ahead);
        f1 = -tension * u;
    } else {
        f1 = per_h * load3(lambda);
    }
    if (place.dof == 3) return fraction;
    store3(rec + 4, r0);
    store3(rec + 7, r1);
    if (!rigid0 && !rigid1) return fraction;
    const double nf = norm(f1), n0 = norm(r0), n1 = norm(r1);
    const bool joint = K::kGeometry == Geometry::joint && rigid0 && rigid1;
    const bool completed = view.completed[id] != 0;
    const JointTerms<double> t = joint_terms(view, nf, n0, n1, rec[assembly::kGeoVibration]);
    const double stiff =
        completed ? scale * fade(view, id, nf) : (joint ? t.stiff : resolved * scale);
    if (rigid0) arm_stiffness(-f1, nf, r0, n0, stiff, rec + 10);
    if (rigid1) arm_stiffness(f1, nf, r1, n1, stiff, rec + 16);
    if (completed) return fraction;  // without damping
    if (joint) rec[22] = t.damping;
    if (K::kGeometry == Geometry::line) return fraction;
    return joint && t.damping > 0.0 ? t.back / t.damping : 1.0;
}

/// Compute the record and the damping torques of a compact joint.
template <class K>
void evaluate_arms(const View& view, const typename K::Data& data, const BodyRef* refs,
                   std::int32_t id) {
    double* record = view.jacobian + view.jac_begin[id];
    const V3 r0 = refs[0].arm(data.point[0]), r1 = refs[1].arm(data.point[1]);
    const V3 f = (view.active[id] / view.h) * load3(view.lambda + view.row_begin[id]);
    const JointTerms<double> t =
        joint_terms(view, norm(f), norm(r0), norm(r1), record[model::kArmsVibration]);
    store3(record, r0);
    store3(record + 3, r1);
    record[model::kArmsDamping] = t.damping;
    auto turn = [&](const double* v) {  // ω₀ − ω₁
        const std::int32_t* body = view.body + kSlots * id;
        return load3(v + view.dof_begin[body[0]] + 3) - load3(v + view.dof_begin[body[1]] + 3);
    };
    double* force = view.geo_force + view.geo[id].force;
    if (view.v_start) store3(force, t.damping * turn(view.v_start));
    store3(force + 3, -t.back * turn(view.v));
}

/// Process leading entries of `count` ids eight at a time, one per lane. The last group may overlap
/// the one before, with the same results. @return number of processed entries.
template <class Lanes, class Data, class Goes>
std::int32_t by_eights(const View& view, const std::int32_t* ids, const Data* data,
                       std::int32_t count, Goes goes) {
    // Limit a run, so that entries rejected in one run are not tested repeatedly.
    constexpr std::int32_t kMaximum = 16 * kLanes;
    std::int32_t run = 0;
    while (run < std::min(count, kMaximum) && goes(run)) ++run;
    if (run < kLanes) return 0;
    for (std::int32_t k = 0; k < run; k += kLanes) {
        const std::int32_t from = k + kLanes <= run ? k : run - kLanes;
        Lanes lanes(view);
        if (!lanes.take(ids + from)) return k;
        lanes.evaluate(data + from);
    }
    return run;
}
template <class K>
std::int32_t evaluate_lanes(const View& view, const std::int32_t* ids, const typename K::Data* data,
                            std::int32_t count) {
    if constexpr (requires { requires K::kMayBeCompact; }) {
        return by_eights<JointRows>(view, ids, data, count, [&](std::int32_t k) {
            return view.arms[ids[k]] != 0 && ids[k] - ids[0] == k;
        });
    } else if constexpr (requires { K::kInLanes; }) {
        return by_eights<LaneRows<K>>(view, ids, data, count, [&](std::int32_t k) {
            return view.among_nodes[ids[k]] != 0 && view.completed[ids[k]] == 0;
        });
    } else {
        return 0;
    }
}

/// Speeds of the rows of one interaction. For bodies with degrees of freedom: G v at the velocity
/// before the step and at the initial velocity of the solve. For prescribed bodies: G v in this
/// step and in the one before.
template <int R>
struct Speeds {
    double now[R] = {}, start[R] = {}, prescribed[R] = {}, before[R] = {};
};

/// Write violations, right-hand sides and the active flag of the interaction.
template <class K>
HAWSER_INLINE void write_rows(const View& view, std::int32_t id,
                              const Rows<K::kBodies, K::kRows>& rows, const Speeds<K::kRows>& s) {
    const double inv_h4 = 4.0 / view.h;
    const std::int32_t row = view.row_begin[id];
    for (int r = 0; r < K::kRows; ++r) {
        const double ups = view.upsilon[row + r], recalled = ups * view.recall[row + r];
        view.residual[row + r] = s.start[r];
        if (view.row_flags[row + r] & 1) {  // velocity row
            view.g[row + r] = 0.0;
            view.c[row + r] = rows.g[r] - s.prescribed[r];
        } else {
            view.g[row + r] = rows.g[r];
            view.c[row + r] =
                recalled * (s.now[r] + s.before[r]) - ups * inv_h4 * rows.g[r] - s.prescribed[r];
            // A sliding friction row does not recall its speed: it is to stop.
            if (view.flags[id] & 128)
                view.c[row + r] -= (1.0 - view.active[id]) * recalled * s.now[r];
            if (view.flags[id] & 1) {
                view.c[row + r] += when_slack(rows.g[r], s.now[r] + s.before[r], recalled, view.h);
            }
        }
    }
    if (view.parted[id]) view.active[id] = 0.0;
}

/// Write the right-hand side and the active flag of the range of a joint. Inside the range the row
/// refers to the end that the coordinate approaches at the speed w of the last step, or to the
/// nearer one. The coordinate is to be at this end, at distance d, after the step: G v₊ ≤ d/h. The
/// solver may choose the other end (solve/bounds.h).
template <class K>
HAWSER_INLINE void write_range(const View& view, std::int32_t id, const kinds::RangeEnds& ends,
                               const Speeds<1>& s) {
    constexpr double kElastic = 1e-11;  // model::kElasticCompliance
    constexpr int kDamper = 4;          // model::kRowDamper
    constexpr double kNoWidth = 1e-9;   // model::kNoWidth
    const std::int32_t row = view.row_begin[id];
    const double g = view.g[row];
    view.low[id] = ends.low;
    view.high[id] = ends.high;
    if (ends.low + ends.high <= kNoWidth) {
        view.upper[id] = 1;
        view.active[id] = 1.0;  // a joint
    } else if (g != 0.0) {
        view.upper[id] = g > 0.0 ? 1 : 0;
        view.active[id] = 1.0;
        // A stop does not continue an outward motion. A spring with a damper does.
        const double speed = s.now[0] + s.before[0];
        const bool bumper = view.epsilon[row] > kElastic && (view.row_flags[row] & kDamper);
        if (speed * g > 0.0 && !bumper) view.c[row] -= view.upsilon[row] * view.recall[row] * speed;
    } else {
        const double w = s.now[0] + s.prescribed[0];
        const double low = ends.low + view.h * w, high = ends.high - view.h * w;
        const bool upper = high < low;
        view.upper[id] = upper ? 1 : 0;
        view.c[row] = (upper ? ends.high : -ends.low) / view.h - s.prescribed[0];
        view.active[id] = (upper ? high : low) < 0.0 || view.lambda[row] != 0.0 ? 1.0 : 0.0;
    }
    if (view.parted[id]) view.active[id] = 0.0;
}

/// Write records of geometric stiffness and damping, and their forces at the present velocities.
template <class K>
HAWSER_INLINE void write_geometry(const View& view, const typename K::Data& data,
                                  const BodyRef* refs, std::int32_t id,
                                  const Rows<K::kBodies, K::kRows>& rows) {
    if constexpr (kCompactKind<K>) {
        if (view.arms[id]) {
            evaluate_arms<K>(view, data, refs, id);
            return;
        }
    }
    if constexpr (K::kGeometry != Geometry::none) {
        const double back = geometry<K>(view, data, refs, id, rows);
        if (view.geo[id].record >= 0) {
            if constexpr (K::kGeometry == Geometry::line)
                line_past(view, id, back);
            else
                geo_force(view, id, view.v, -back, view.geo[id].dof);
            if (view.v_start) geo_force(view, id, view.v_start);
        }
    }
}

template <class K>
void evaluate_kind(const View& view, const std::int32_t* ids, const void* data_in,
                   std::int32_t begin, std::int32_t end) {
    constexpr int B = K::kBodies, R = K::kRows;
    const auto* data = static_cast<const typename K::Data*>(data_in);
    for (std::int32_t k = begin; k < end; ++k) {
        if (const std::int32_t done = evaluate_lanes<K>(view, ids + k, data + k, end - k)) {
            k += done - 1;
            continue;
        }
        const std::int32_t id = ids[k];
        const std::int32_t* body = view.body + kSlots * id;
        BodyRef refs[B];
        for (int b = 0; b < B; ++b) {
            const std::int32_t i = body[b];
            refs[b] = {load3(view.x + 3 * i), view.r + 9 * i, view.dof[i] == 6 || view.dof[i] == 0};
        }
        Rows<B, R> rows;
        [[maybe_unused]] kinds::RangeEnds ends{};
        if constexpr (kHasEnds<K>)
            ends = K::evaluate_ends(data[k], refs, rows);
        else
            K::evaluate(data[k], refs, rows);

        // Compute the speeds of the rows and the packed Jacobian.
        Speeds<R> speed;
        int width = 0;
        for (int b = 0; b < B; ++b) width += view.dof[body[b]];
        double buffer[model::kArmBufferSize];
        double* out =
            kCompactKind<K> && view.arms[id] ? buffer : view.jacobian + view.jac_begin[id];
        int at = 0;
        for (int b = 0; b < B; ++b) {
            const std::int32_t i = body[b];
            const int dof = view.dof[i];
            if (dof == 0) {
                const double* u = view.v_fixed + 6 * i;
                const double* u_before = view.v_before + 6 * i;
                for (int r = 0; r < R; ++r)
                    for (int j = 0; j < 6; ++j) {
                        speed.prescribed[r] += rows.J[b][r][j] * u[j];
                        speed.before[r] += rows.J[b][r][j] * u_before[j];
                    }
                continue;
            }
            const double* v = view.v + view.dof_begin[i];
            const double* v_start = (view.v_start ? view.v_start : view.v) + view.dof_begin[i];
            auto pack = [&]<int N>() {
                for (int r = 0; r < R; ++r)
                    for (int j = 0; j < N; ++j) {
                        const double value = rows.J[b][r][j];
                        out[r * width + at + j] = value;
                        speed.now[r] += value * v[j];
                        speed.start[r] += value * v_start[j];
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
        write_rows<K>(view, id, rows, speed);
        if constexpr (kHasEnds<K>) write_range<K>(view, id, ends, speed);
        write_geometry<K>(view, data[k], refs, id, rows);
    }
}

}  // namespace

void evaluate(const View& view, InteractionKind kind, const std::int32_t* ids, const void* data,
              std::int32_t begin, std::int32_t end) noexcept {
    with_kind(kind, [&]<class K>() { evaluate_kind<K>(view, ids, data, begin, end); });
}

}  // namespace hawser::HAWSER_ISA
