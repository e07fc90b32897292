// SPDX-License-Identifier: Apache-2.0
#include "model/bodies.h"

#include "base/small.h"
#include "model/damping.h"

#include <Eigen/LU>

namespace hawser::model {
namespace {

template <class V>
void append3(base::Array<double>& to, const V& v) {
    for (int i = 0; i < 3; ++i) to.push_back(v[i]);
}

}  // namespace

void Bodies::make_room() {
    base::make_room(kind, 1);
    for (base::Array<std::int32_t>* a : {&dof_begin, &quiet}) base::make_room(*a, 1);
    for (std::vector<std::int32_t>* a : {&moving, &rigid, &driven}) base::make_room(*a, 1);
    for (base::Array<std::uint8_t>* a : {&weight, &asleep}) base::make_room(*a, 1);
    for (base::Array<double>* a : {&x, &q, &r, &v, &v_start, &v_fixed, &spin_free, &spin_change,
                                   &mass, &inertia, &inv_inertia, &principal, &force, &damping})
        base::make_room(*a, 9);
}

int Bodies::add(const BodyDef& def) {
    const int id = count();
    const int d = dof_of(def.kind);
    kind.push_back(def.kind);
    dof_begin.push_back(dofs);
    if (d > 0) moving.push_back(id);
    if (def.kind == BodyKind::rigid) rigid.push_back(id);
    if (def.kind == BodyKind::kinematic) driven.push_back(id);
    append3(x, def.position);
    const bool turns = def.kind != BodyKind::lump && def.kind != BodyKind::scalar;
    const Quat o = turns ? def.orientation.normalized() : Quat::Identity();
    q.insert(q.end(), {o.w(), o.x(), o.y(), o.z()});
    r.resize(r.size() + 9);
    refresh_rotation(id);
    for (int i = 0; i < d; ++i) v.push_back(i < 3 ? def.velocity[i] : def.angular_velocity[i - 3]);
    v_start.insert(v_start.end(), v.end() - d, v.end());
    const bool driven_body = def.kind == BodyKind::kinematic;
    append3(v_fixed, driven_body ? def.velocity : Vec3::Zero().eval());
    append3(v_fixed, driven_body ? def.angular_velocity : Vec3::Zero().eval());
    append3(spin_free, Vec3::Zero().eval());
    append3(spin_change, Vec3::Zero().eval());
    mass.push_back(def.mass);
    const Mat3 inverse = def.kind == BodyKind::rigid ? Mat3(def.inertia.inverse()) : Mat3::Zero();
    for (int i = 0; i < 9; ++i) {
        inertia.push_back(def.inertia(i / 3, i % 3));
        inv_inertia.push_back(inverse(i / 3, i % 3));
    }
    const bool diagonal = def.kind == BodyKind::rigid && def.inertia.isDiagonal(0.0);
    append3(principal, diagonal ? Vec3(def.inertia.diagonal()) : Vec3::Zero().eval());
    append3(principal, diagonal ? Vec3(inverse.diagonal()) : Vec3::Zero().eval());
    append3(force, def.force);
    append3(force, def.torque);
    append3(damping, def.linear_damping);
    append3(damping, def.angular_damping);
    weight.push_back(def.gravity && def.kind != BodyKind::scalar ? 1 : 0);
    asleep.push_back(0);
    quiet.push_back(0);
    dofs += d;
    return id;
}

void Bodies::share_drag(double h) {
    drag_after.resize(damping.size());
    drag_before.resize(damping.size());
    for (std::size_t b = 0; b < kind.size(); ++b)
        for (std::size_t i = 0; i < 6; ++i) {
            const double d = damping[6 * b + i];
            const double mobility = i < 3 ? 1.0 / mass[b] : inv_inertia[9 * b + 4 * (i - 3)];
            const double late =
                d > 0.0 && dof(static_cast<int>(b)) > 0 ? late_share(h * d * mobility) : 0.5;
            drag_after[6 * b + i] = late * d;
            drag_before[6 * b + i] = d - late * d;
        }
}

void Bodies::truncate(int kept) {
    const auto n = static_cast<std::size_t>(kept);
    kind.resize(n);
    dof_begin.resize(n);
    for (base::Array<double>* a : {&x, &spin_free, &spin_change}) a->resize(3 * n);
    for (base::Array<double>* a : {&v_fixed, &principal, &force, &damping}) a->resize(6 * n);
    for (base::Array<double>* a : {&r, &inertia, &inv_inertia}) a->resize(9 * n);
    q.resize(4 * n);
    mass.resize(n);
    weight.resize(n);
    asleep.resize(n);
    quiet.resize(n);
    v_before.clear();
}

void Bodies::drift(int body, const double* velocity, const double* omega, double t) noexcept {
    const auto b = static_cast<std::size_t>(body);
    for (std::size_t i = 0; i < 3; ++i) x[3 * b + i] += t * velocity[i];
    const double half = 0.5 * t;
    if (omega != nullptr) turn(body, Quat(1.0, half * omega[0], half * omega[1], half * omega[2]));
}

void Bodies::turn(int body, const Quat& turn) noexcept {
    double* p = &q[4 * static_cast<std::size_t>(body)];
    const Quat now = (turn * Quat(p[0], p[1], p[2], p[3])).normalized();
    p[0] = now.w();
    p[1] = now.x();
    p[2] = now.y();
    p[3] = now.z();
    refresh_rotation(body);
}

void Bodies::refresh_rotation(int body) noexcept {
    const auto b = static_cast<std::size_t>(body);
    const generic::M3 m = generic::rotation(&q[4 * b]);
    for (std::size_t i = 0; i < 9; ++i) r[9 * b + i] = m.a[i];
}

std::size_t Bodies::bytes() const noexcept {
    using base::bytes;
    return bytes(kind) + bytes(dof_begin) + bytes(moving) + bytes(rigid) + bytes(driven) +
           bytes(x) + bytes(q) + bytes(r) + bytes(v) + bytes(v_start) + bytes(v_fixed) +
           bytes(spin_free) + bytes(spin_change) + bytes(mass) + bytes(inertia) +
           bytes(inv_inertia) + bytes(principal) + bytes(force) + bytes(damping) +
           bytes(drag_after) + bytes(drag_before) + bytes(weight);
}

}  // namespace hawser::model
