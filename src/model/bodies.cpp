// SPDX-License-Identifier: Apache-2.0
#include "model/bodies.h"

#include "base/index.h"
#include "base/small.h"
#include "base/sorted.h"
#include "base/turn.h"
#include "model/damping.h"

#include <Eigen/LU>

#include <algorithm>

namespace hawser::model {
namespace {

void put3(base::Array<double>& to, std::size_t begin, const Vec3& v) noexcept {
    for (int i = 0; i < 3; ++i) to[begin + at(i)] = v[i];
}

}  // namespace

void Bodies::reserve_more() {
    slots.reserve_more();
    base::reserve_more(kind, 1);
    for (base::Array<std::int32_t>* a : {&dof_begin, &quiet, &first_holder})
        base::reserve_more(*a, 1);
    for (std::vector<std::int32_t>* a : {&moving, &rigid, &driven}) base::reserve_more(*a, 1);
    for (base::Array<std::uint8_t>* a : {&weight, &asleep, &room}) base::reserve_more(*a, 1);
    for (base::Array<double>* a : {&x, &q, &r, &v, &v_start, &v_fixed, &spin_free, &spin_change,
                                   &mass, &inertia, &inv_inertia, &principal, &force, &damping})
        base::reserve_more(*a, 9);
}

int Bodies::add(const BodyDef& def) {
    const int place = vacant_slot_for(def.kind);
    if (place < 0) return append(def);
    slots.take(place);
    kind[at(place)] = def.kind;
    write(place, def);
    enlist(place);
    return place;
}

int Bodies::append(const BodyDef& def) {
    for (std::vector<std::int32_t>* list : {&moving, &rigid, &driven}) base::reserve_more(*list, 1);
    const int id = slots.append();
    const auto n = at(id) + 1;
    const int d = dof_of(def.kind);
    kind.push_back(def.kind);
    dof_begin.push_back(dofs);
    room.push_back(static_cast<std::uint8_t>(d));
    dofs += d;
    for (base::Array<double>* a : {&x, &spin_free, &spin_change}) a->resize(3 * n);
    for (base::Array<double>* a : {&v_fixed, &principal, &force, &damping}) a->resize(6 * n);
    for (base::Array<double>* a : {&r, &inertia, &inv_inertia}) a->resize(9 * n);
    for (base::Array<double>* a : {&v, &v_start}) a->resize(at(dofs));
    q.resize(4 * n);
    mass.resize(n);
    weight.resize(n);
    asleep.resize(n);
    quiet.resize(n);
    first_holder.push_back(-1);
    write(id, def);
    enlist(id);
    return id;
}

void Bodies::write(int body, const BodyDef& def) noexcept {
    const auto b = at(body);
    const int d = dof(body);
    const Vec3 none = Vec3::Zero();
    put3(x, 3 * b, def.position);
    const bool turns = def.kind != BodyKind::lump && def.kind != BodyKind::scalar;
    const Quat o = turns ? def.orientation.normalized() : Quat::Identity();
    const double wxyz[4] = {o.w(), o.x(), o.y(), o.z()};
    for (std::size_t i = 0; i < 4; ++i) q[4 * b + i] = wxyz[i];
    refresh_rotation(body);
    for (int i = 0; i < d; ++i) {
        const auto k = at(dof_begin[b] + i);
        v[k] = v_start[k] = i < 3 ? def.velocity[i] : def.angular_velocity[i - 3];
    }
    const bool driven_body = def.kind == BodyKind::kinematic;
    put3(v_fixed, 6 * b, driven_body ? def.velocity : none);
    put3(v_fixed, 6 * b + 3, driven_body ? def.angular_velocity : none);
    put3(spin_free, 3 * b, none);
    put3(spin_change, 3 * b, none);
    mass[b] = def.mass;
    const Mat3 inverse = def.kind == BodyKind::rigid ? Mat3(def.inertia.inverse()) : Mat3::Zero();
    for (int i = 0; i < 9; ++i) {
        inertia[9 * b + at(i)] = def.inertia(i / 3, i % 3);
        inv_inertia[9 * b + at(i)] = inverse(i / 3, i % 3);
    }
    const bool diagonal = def.kind == BodyKind::rigid && def.inertia.isDiagonal(0.0);
    put3(principal, 6 * b, diagonal ? Vec3(def.inertia.diagonal()) : none);
    put3(principal, 6 * b + 3, diagonal ? Vec3(inverse.diagonal()) : none);
    put3(force, 6 * b, def.force);
    put3(force, 6 * b + 3, def.torque);
    put3(damping, 6 * b, def.linear_damping);
    put3(damping, 6 * b + 3, def.angular_damping);
    weight[b] = def.gravity && def.kind != BodyKind::scalar ? 1 : 0;
    asleep[b] = 0;
    quiet[b] = 0;
}

void Bodies::enlist(int body) noexcept {
    if (dof(body) > 0) base::insert_sorted(moving, body);
    if (kind[at(body)] == BodyKind::rigid) base::insert_sorted(rigid, body);
    if (kind[at(body)] == BodyKind::kinematic) base::insert_sorted(driven, body);
}

void Bodies::remove(int body) noexcept {
    for (std::vector<std::int32_t>* list : {&moving, &rigid, &driven})
        base::erase_sorted(*list, body);
    std::fill_n(v.data() + dof_begin[at(body)], room[at(body)], 0.0);
    std::fill_n(v_start.data() + dof_begin[at(body)], room[at(body)], 0.0);
    kind[at(body)] = BodyKind::fixed;
    write(body, {.kind = BodyKind::fixed, .gravity = false});
    slots.vacate(body);
}

void Bodies::split_drag(double h) {
    drag_after.resize(damping.size());
    drag_before.resize(damping.size());
    for (std::size_t b = 0; b < kind.size(); ++b)
        for (std::size_t i = 0; i < 6; ++i) {
            const double d = damping[6 * b + i];
            double late = 0.5;
            if (d > 0.0 && dof(static_cast<int>(b)) > 0) {
                const double mobility = i < 3 ? 1.0 / mass[b] : inv_inertia[9 * b + 4 * (i - 3)];
                late = late_fraction(h * d * mobility);
            }
            drag_after[6 * b + i] = late * d;
            drag_before[6 * b + i] = d - late * d;
        }
}

void Bodies::truncate(int kept) {
    const auto n = static_cast<std::size_t>(kept);
    v_before.clear();
    if (kept >= count()) return;
    slots.truncate(kept);
    dofs = dof_begin[n];
    for (base::Array<double>* a : {&v, &v_start}) a->resize(at(dofs));
    for (std::vector<std::int32_t>* list : {&moving, &rigid, &driven})
        list->erase(std::lower_bound(list->begin(), list->end(), kept), list->end());
    kind.resize(n);
    dof_begin.resize(n);
    room.resize(n);
    for (base::Array<double>* a : {&x, &spin_free, &spin_change}) a->resize(3 * n);
    for (base::Array<double>* a : {&v_fixed, &principal, &force, &damping}) a->resize(6 * n);
    for (base::Array<double>* a : {&r, &inertia, &inv_inertia}) a->resize(9 * n);
    q.resize(4 * n);
    mass.resize(n);
    weight.resize(n);
    asleep.resize(n);
    quiet.resize(n);
    first_holder.resize(n);
}

Quat turn_by(const double* omega, double t) noexcept {
    const double half = 0.5 * t;
    const generic::V3 a{half * omega[0], half * omega[1], half * omega[2]};
    const double y = dot(a, a);
    return Quat(1.0 - y * generic::turn_bend(y), a.x, a.y, a.z).normalized();
}

void Bodies::drift(int body, const double* velocity, const double* omega, double t) noexcept {
    const auto b = static_cast<std::size_t>(body);
    for (std::size_t i = 0; i < 3; ++i) x[3 * b + i] += t * velocity[i];
    if (omega != nullptr) turn(body, turn_by(omega, t));
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
    return slots.bytes() + bytes(kind) + bytes(room) + bytes(dof_begin) + bytes(moving) +
           bytes(rigid) + bytes(driven) + bytes(x) + bytes(q) + bytes(r) + bytes(v) +
           bytes(v_start) + bytes(v_fixed) + bytes(spin_free) + bytes(spin_change) + bytes(mass) +
           bytes(inertia) + bytes(inv_inertia) + bytes(principal) + bytes(force) + bytes(damping) +
           bytes(drag_after) + bytes(drag_before) + bytes(weight) + bytes(first_holder);
}

}  // namespace hawser::model
