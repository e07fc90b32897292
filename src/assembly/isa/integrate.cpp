// SPDX-License-Identifier: Apache-2.0
/// Motion of a step. Consecutive rigid bodies are processed eight at a time.
#include "assembly/isa/rigid_lanes.h"
#include "assembly/isa/rows.h"
#include "base/simd.h"
#include "base/turn.h"

namespace hawser::HAWSER_ISA {
namespace {

using assembly::View;

void move_body(const View& view, std::int32_t body) {
    const double h = view.h;
    const int dof = view.dof[body];
    double* x = view.x + 3 * body;
    double* v = view.v + view.dof_begin[body];
    const double* u = view.v_new + view.dof_begin[body];
    double* start = view.v_start + view.dof_begin[body];
    for (int j = 0; j < dof; ++j) {
        start[j] = 2.0 * u[j] - v[j];
        v[j] = u[j];
    }
    if (dof == 1) {
        x[0] += h * v[0];
        return;
    }
    add3(x, h * load3(v));
    if (dof < 6) return;
    store3(view.spin_change + 3 * body,
           tmul(load9(view.r + 9 * body), load3(v + 3) - load3(view.spin_free + 3 * body)));
    // q₊ = (s, hω/2)/|·| ⊗ q, ω in the world frame (base/turn.h).
    double* q = view.q + 4 * body;
    const V3 w = (0.5 * h) * load3(v + 3), p = load3(q + 1);
    const double y = dot(w, w), s = 1.0 - y * turn_bend(y);
    const V3 turned = s * p + q[0] * w + cross(w, p);
    const double scalar = s * q[0] - dot(w, p);
    const double inverse = 1.0 / __builtin_sqrt(scalar * scalar + dot(turned, turned));
    q[0] = scalar * inverse;
    store3(q + 1, inverse * turned);
    const M3 m = rotation(q);
    for (int i = 0; i < 9; ++i) view.r[9 * body + i] = m.a[i];
}

/// Apply move_body() to eight rigid bodies.
void move_eight(const View& view, std::int32_t body) {
    const std::int32_t begin = view.dof_begin[body];
    const W8 none{}, h = none + view.h;
    V8 u[kLanes], q[kLanes];
    load_bodies(view.v_new + begin, 6, u);
    load_bodies(view.q + 4L * body, 4, q);
    const WM3 old = load_bodies9(view.r + 9L * body);
    for (int k = 0; k < 6 * kLanes; k += kLanes) {
        const V8 v = load(view.v + begin + k), next = load(view.v_new + begin + k);
        store(view.v_start + begin + k, 2.0 * next - v);
        store(view.v + begin + k, next);
    }
    double* x = view.x + 3L * body;
    store_threes(x, load_threes(x) + h * W3{u[0], u[1], u[2]});
    const W3 spin{u[3], u[4], u[5]};
    const W3 before = load_threes(view.spin_free + 3L * body);
    store_threes(view.spin_change + 3L * body, tmul(old, spin - before));

    const W3 w = (0.5 * h) * spin, p{q[1], q[2], q[3]};
    const W8 y = dot(w, w), s = one(y) - y * turn_bend(y);
    const W3 turned = s * p + W8(q[0]) * w + cross(w, p);
    const W8 scalar = s * q[0] - dot(w, p);
    const W8 inverse = 1.0 / root(scalar * scalar + dot(turned, turned));
    const W8 to[4] = {scalar * inverse, turned.x * inverse, turned.y * inverse, turned.z * inverse};
    V8 pose[kLanes] = {to[0], to[1], to[2], to[3]};
    store_bodies(view.q + 4L * body, 4, 4, pose);
    const WM3 m = rotation(to, one(s));
    V8 first[kLanes], last[kLanes];  // entries 0-7 and 1-8
    for (int i = 0; i < kLanes; ++i) {
        first[i] = m.a[i];
        last[i] = m.a[i + 1];
    }
    transpose(first);
    transpose(last);
    for (int l = 0; l < kLanes; ++l) {
        store(view.r + 9L * (body + l), first[l]);
        store(view.r + 9L * (body + l) + 1, last[l]);
    }
}

}  // namespace

void integrate(const View& view, std::int32_t begin, std::int32_t end) noexcept {
    for (std::int32_t body = begin; body < end; ++body) {
        if (body + kLanes <= end && eight_rigid(view, body)) {
            move_eight(view, body);
            body += kLanes - 1;
        } else if (view.dof[body] > 0) {
            move_body(view, body);
        }
    }
}

}  // namespace hawser::HAWSER_ISA
