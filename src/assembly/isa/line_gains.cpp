// SPDX-License-Identifier: Apache-2.0
/// Energy that lines store beyond the work of the bodies at their ends, see solve/wires.h.
#include "assembly/isa/geo_force.h"
#include "assembly/isa/rows.h"
#include "base/lanes.h"
#include "base/transpose.h"

namespace hawser::HAWSER_ISA {
namespace {

using assembly::LineGain;
using assembly::View;

/// Both ends of an element: points, velocities before and after the step, and the impulse on the
/// second end.
template <class T>
struct Ends {
    V3T<T> separation;   ///< Vector between the points at the begin of the step [m].
    V3T<T> back, ahead;  ///< Vectors between the points half a step before and after [m].
    V3T<T> mean;         ///< Relative velocity, mean of before and after [m/s].
    V3T<T> along;        ///< Direction of the row.
    T rate[2], lambda;   ///< Speed of the row before and after, and its multiplier.
    T acts;              ///< 1: row_losses() counts the row.
    /// Impulse on the second end without the part of View::pair_mass, which is kinetic energy of
    /// the element.
    V3T<T> impulse;
    /// Violation, stiffness; pulls: 1 if the element stores nothing while short.
    T g, stiffness, pulls;
    T size;  ///< Magnitude of the coordinates; lengths have the rounding of coordinates.
};

template <class T>
inline T longer_by(const Ends<T>& e, const V3T<T>& separation, const T& rest) {
    const T longer = root(dot(separation, separation)) - rest;
    return select_greater(e.pulls, zero(rest), positive_part(longer), longer);
}
template <class T>
inline T size_of(const T& x) {
    return select_greater(x, zero(x), x, -x);
}

/// Return the loss of the row as row_losses() computes it.
template <class T>
inline T booked_loss(const Ends<T>& e, double half) {
    const T old = e.g - half * e.rate[0], now = e.g + half * e.rate[1];
    const T before = select_greater(e.pulls, zero(old), positive_part(old), old);
    const T after = select_greater(e.pulls, zero(now), positive_part(now), now);
    return 0.5 *
           (e.stiffness * (before * before - after * after) - e.lambda * (e.rate[0] + e.rate[1]));
}

template <class T>
inline void gain_of(const Ends<T>& e, double half, T& gain, T& exchanged, T& noise, T& unbooked) {
    const T rest = root(dot(e.separation, e.separation)) - e.g;
    const T before = longer_by(e, e.back, rest), after = longer_by(e, e.ahead, rest);
    const T change = 0.5 * e.stiffness * (after * after - before * before);
    constexpr double kRounding = 1e-15;  // rounding of a few sums
    const T one = change + dot(e.impulse, e.mean);
    gain += one;
    unbooked -= one + e.acts * booked_loss(e, half);
    exchanged += size_of(change);
    noise += kRounding * e.stiffness * (size_of(before) + size_of(after)) * e.size;
}

/// Rotate a vector by the Cayley map of the angle 4b.
inline V3 turned(const V3& r, const V3& b) {
    const V3 c = cross(b, r);
    return r + (2.0 / (1.0 + dot(b, b))) * (c + cross(b, c));
}

void one_gain(const View& view, std::int32_t id, LineGain* sum) {
    if (view.parted[id]) return;
    const assembly::GeoSlot& place = view.geo[id];
    const double *record = view.geo_record + place.record, *f = view.geo_force + place.force;
    const std::int32_t* body = view.body + kMaxInteractionBodies * id;
    const std::int32_t row = view.row_begin[id];
    const double h = view.h;
    V3 point[2], before[2], after[2], mean[2], speed[2], speed_after[2];
    for (int b = 0; b < 2; ++b) {
        V3 lin, ang, lin_after, ang_after;
        slot_velocity(view, view.v, body[b], lin, ang);
        slot_velocity(view, view.v_new, body[b], lin_after, ang_after);
        const V3 x = load3(view.x + 3 * body[b]);
        const V3 r = place.dof == 3 ? V3{0, 0, 0} : load3(record + 4 + 3 * b);
        point[b] = x + r;
        before[b] = x - (0.5 * h) * lin + turned(r, (-0.25 * h) * ang);
        after[b] = x + (0.5 * h) * lin_after + turned(r, (0.25 * h) * ang_after);
        speed[b] = lin + cross(ang, r);
        speed_after[b] = lin_after + cross(ang_after, r);
        mean[b] = 0.5 * (speed[b] + speed_after[b]);
    }
    // geometric impulse on slot 0
    const V3 across = load3(f + (place.dof == 3 ? 3 : 6)) - load3(f);
    const V3 gained = speed_after[1] - speed_after[0] - (speed[1] - speed[0]);
    const double* jac = view.jacobian + view.jac_begin[id];
    const V3 n = view.dof[body[1]] > 0 ? load3(jac + view.dof[body[0]]) : -load3(jac);
    // An interaction replaced by another force is inactive, but counts if it is tension-only.
    const bool acts = view.active[id] != 0.0 || (view.flags[id] & 1);
    const Ends<double> e{point[1] - point[0],
                         before[1] - before[0],
                         after[1] - after[0],
                         mean[1] - mean[0],
                         n,
                         {dot(n, speed[1] - speed[0]), dot(n, speed_after[1] - speed_after[0])},
                         view.lambda[row],
                         acts ? 1.0 : 0.0,
                         view.lambda[row] * n - across - pair_mass_of(view, id) * gained,
                         view.g[row],
                         1.0 / view.epsilon[row],
                         view.flags[id] & 1 ? 1.0 : 0.0,
                         size_of(point[0].x) + size_of(point[0].y) + size_of(point[0].z)};
    gain_of(e, 0.5 * h, sum->gain, sum->exchanged, sum->noise, sum->unbooked);
}

/// Add the gains of eight interactions of View::among_nodes. @return false if one is broken.
bool eight_gains(const View& view, const std::int32_t* ids, LineGain* sum) {
    std::int32_t x[2][kLanes], v[2][kLanes], row[kLanes], jac[kLanes], force[kLanes];
    double pulls[kLanes], acts[kLanes];
    for (int l = 0; l < kLanes; ++l) {
        const std::int32_t id = ids[l];
        if (view.parted[id] || !view.among_nodes[id]) return false;
        for (int b = 0; b < 2; ++b) {
            const std::int32_t body = view.body[kMaxInteractionBodies * id + b];
            x[b][l] = 3 * body;
            v[b][l] = view.dof_begin[body];
        }
        row[l] = view.row_begin[id];
        jac[l] = view.jac_begin[id];
        force[l] = view.geo[id].force;
        pulls[l] = view.flags[id] & 1 ? 1.0 : 0.0;
        acts[l] = view.active[id] != 0.0 || (view.flags[id] & 1) ? 1.0 : 0.0;
    }
    const bool points[2] = {are_contiguous<3>(x[0]), are_contiguous<3>(x[1])};
    const bool speeds[2] = {are_contiguous<3>(v[0]), are_contiguous<3>(v[1])};
    V8 at[2][3];
    auto separation = [&](const double* base, const std::int32_t(&from)[2][kLanes],
                          const bool(&in_turn)[2]) {
        for (int b = 0; b < 2; ++b) load_lanes_of_three(base, from[b], in_turn[b], at[b]);
        return V3T<W8>{at[1][0] - at[0][0], at[1][1] - at[0][1], at[1][2] - at[0][2]};
    };
    const V3T<W8> u = separation(view.v, v, speeds), w = separation(view.v_new, v, speeds);
    const V3T<W8> d = separation(view.x, x, points);
    const W8 size = size_of(W8(at[0][0])) + size_of(W8(at[0][1])) + size_of(W8(at[0][2]));
    V8 f[kLanes], line[kLanes];
    load_lanes(view.geo_force, force, f);
    load_lanes(view.jacobian, jac, line);
    const bool rows = are_contiguous<1>(row);
    const auto of_rows = [&](const double* values) {
        return rows ? W8(load(values + row[0])) : W8(gather_range(values, row, 0, kLanes));
    };
    const W8 half = constant(W8(f[0]), 0.5 * view.h), lambda = of_rows(view.lambda);
    const V3T<W8> across{f[3] - f[0], f[4] - f[1], f[5] - f[2]};
    const V3T<W8> n{line[3], line[4], line[5]};  // Jacobian of the second point mass
    V3T<W8> impulse = lambda * n - across;
    if (view.pair_mass) {
        double pair[kLanes];
        for (int l = 0; l < kLanes; ++l) pair[l] = pair_mass_of(view, ids[l]);
        impulse = impulse - W8(load(pair)) * (w - u);
    }
    const Ends<W8> e{d,
                     d - half * u,
                     d + half * w,
                     constant(half, 0.5) * (u + w),
                     n,
                     {dot(n, u), dot(n, w)},
                     lambda,
                     load(acts),
                     impulse,
                     of_rows(view.g),
                     1.0 / of_rows(view.epsilon),
                     load(pulls),
                     size};
    W8 gain{}, exchanged{}, noise{}, unbooked{};
    gain_of(e, 0.5 * view.h, gain, exchanged, noise, unbooked);
    sum->gain += hawser::HAWSER_ISA::sum(gain);
    sum->exchanged += hawser::HAWSER_ISA::sum(exchanged);
    sum->noise += hawser::HAWSER_ISA::sum(noise);
    sum->unbooked += hawser::HAWSER_ISA::sum(unbooked);
    return true;
}

}  // namespace

void line_gains(const View& view, const std::int32_t* ids, std::int32_t count,
                LineGain* sum) noexcept {
    std::int32_t i = 0;
    for (; i + kLanes <= count; i += kLanes) {
        if (eight_gains(view, ids + i, sum)) continue;
        for (int l = 0; l < kLanes; ++l) one_gain(view, ids[i + l], sum);
    }
    for (; i < count; ++i) one_gain(view, ids[i], sum);
}

}  // namespace hawser::HAWSER_ISA
