// SPDX-License-Identifier: Apache-2.0
/// Compute the loads of coefficients and strips on a hull (hawser/water_hull.h, hawser/hydro.h).
#include <hawser/world.h>

#include "base/index.h"
#include "marine/sea_system.h"

#include <algorithm>
#include <cmath>

namespace hawser::marine {

Matrix6 motion_at(const Vec3& p) noexcept {
    Matrix6 t = Matrix6::Identity();  // v + ω × p
    t(0, 4) = p.z();
    t(0, 5) = -p.y();
    t(1, 3) = -p.z();
    t(1, 5) = p.x();
    t(2, 3) = p.y();
    t(2, 4) = -p.x();
    return t;
}

double heading_of(const Quat& q) noexcept {
    return std::atan2(2.0 * (q.w() * q.z() + q.x() * q.y()),
                      1.0 - 2.0 * (q.y() * q.y() + q.z() * q.z()));
}

namespace {

Mat3 about_z(double angle) noexcept {
    const double c = std::cos(angle), s = std::sin(angle);
    Mat3 out;
    out << c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0;
    return out;
}

/// Keep the positive semi-definite part of heave, roll and pitch of a symmetric matrix. Unstable
/// motions remain in the force only.
void stable_part(Matrix6& m) noexcept {
    for (int i = 0; i < 6; ++i) {
        if (i >= 2 && i <= 4 && m(i, i) > 0.0) continue;
        m.row(i).setZero();
        m.col(i).setZero();
    }
    // Reduce couplings until the matrix is diagonally dominant.
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < i; ++j) {
            const double most = 0.5 * std::sqrt(m(i, i) * m(j, j));
            m(i, j) = m(j, i) = std::clamp(m(i, j), -most, most);
        }
}

}  // namespace

void HullWater::add_matrix(const Mat3& axes, const Matrix6& m,
                           std::array<double, 21>& to) noexcept {
    Matrix6 turn = Matrix6::Zero();
    turn.topLeftCorner<3, 3>() = turn.bottomRightCorner<3, 3>() = axes;
    const Matrix6 w = turn * m * turn.transpose();
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j <= i; ++j)
            to[static_cast<std::size_t>(triangle(i, j))] += 0.5 * (w(i, j) + w(j, i));
}

void HullWater::add_force(const Vec3& push, const Vec3& moment) noexcept {
    for (int k = 0; k < 3; ++k) {
        force[at(k)] += push[k];
        force[at(3 + k)] += moment[k];
    }
}

/// Add a force and a moment that act at the reference point of the coefficients.
void HullWater::add_at_reference(const Vec6& f) noexcept {
    const Vec3 push = frame_ * f.head<3>();
    const Vec3 arm = frame_ * def_->coefficients->reference;
    add_force(push, frame_ * f.tail<3>() + arm.cross(push));
}

void HullWater::remember(const Sea& sea, const SeaMoment& now) noexcept {
    lost_ = false;
    if (!def_->coefficients) return;
    frame_ = axes_;
    if (waves_.any()) {
        const Vec3 at = pose_.position + axes_ * def_->coefficients->reference;
        waves_.follow(at.x(), at.y(), heading_of(pose_.orientation));
        lost_ = !waves_.act(sea, now, pushed_);
        frame_ = about_z(waves_.heading());
    }
    if (!memory_.follows()) return;
    const Vec3 arm = frame_ * def_->coefficients->reference;
    Vec6 v;
    v << frame_.transpose() * (twist_.linear + twist_.angular.cross(arm)),
        frame_.transpose() * twist_.angular;
    ahead_ = memory_.ahead(v);
    memory_.push(v);
    if (memory_.any()) remembered_ = memory_.force();
}

void HullWater::add_coefficients(const Sea& sea, const SeaMoment& now) noexcept {
    if (!def_->coefficients) return;
    add_matrix(frame_, added_, mass);
    add_matrix(frame_, constant_, damping);
    if (memory_.any()) add_at_reference(remembered_);
    if (waves_.any()) add_at_reference(pushed_);
    if (!def_->coriolis) return;
    // dP/dt of P = A ν in turning axes, less what A (V₊ − V) has of it in those of the world.
    // Velocities are half a step older than poses: those of the pose's time keep energy to second
    // order.
    const Vec3 turn = ahead_.tail<3>();
    const Vec3 past =
        ahead_.head<3>() - turn.cross(def_->coefficients->reference) -
        frame_.transpose() * sea.current(now, std::min(pose_.position.z(), now.level));
    Vec6 v, swept = Vec6::Zero();
    v << past, turn;
    swept.head<3>() = turn.cross(past);
    const Vec6 p = added_ * v, same = added_ * swept;
    add_force(frame_ * (same.head<3>() - turn.cross(p.head<3>())),
              frame_ * (same.tail<3>() - turn.cross(p.tail<3>()) - past.cross(p.head<3>())));
}

/// Add the linear hydrostatics of small motions about rest: the weight of the displaced water minus
/// C (x − x₀).
void HullWater::add_linear(const Sea&, const SeaMoment& now) noexcept {
    const Mat3 level = waves_.any() ? frame_ : about_z(heading_of(pose_.orientation));
    const Mat3 tilt = level.transpose() * axes_;
    Vec6 x = Vec6::Zero();
    x[2] = pose_.position.z() - now.level - def_->linear.height;
    x[3] = 0.5 * (tilt(2, 1) - tilt(1, 2));
    x[4] = 0.5 * (tilt(0, 2) - tilt(2, 0));
    const Vec6 back = -(statics_ * x);
    add_force(level * back.head<3>(), level * back.tail<3>());
    force[2] += weight_;
    Matrix6 k = statics_;
    stable_part(k);
    add_matrix(level, k, stiffness);
}

void HullWater::flow_past(const WaterField& field, int chunk) noexcept {
    const int first = chunk * kChunk;
    const int count = std::min(kChunk, static_cast<int>(flows_.size()) - first);
    FieldPoint points[kChunk];
    WaterPoint water[kChunk];
    for (int i = 0; i < count; ++i) {
        const Vec3 place =
            pose_.position +
            axes_ * def_->strips[static_cast<std::size_t>(first) + static_cast<std::size_t>(i)].at;
        points[i] = {place, place.z()};
    }
    field.water(points, count, water);
    for (int i = 0; i < count; ++i) flows_[at(first + i)] = water[i].velocity;
}

void HullWater::add_strips(const Sea& sea) noexcept {
    for (std::size_t k = 0; k < flows_.size(); ++k) {
        const HullStrip& strip = def_->strips[k];
        const Vec3 arm = axes_ * strip.at, n = axes_ * strip.axis;
        Vec6 s, v;
        s << n, arm.cross(n);
        v << twist_.linear, twist_.angular;
        const double past = n.dot(flows_[k]) - s.dot(v);
        const double fraction = strip.axis.cwiseProduct(strip.axis).dot(flow_.wet_fraction);
        const double c = 0.5 * sea.density() * strip.drag_area * fraction * std::abs(past);
        const double push = c * past + 2.0 * c * s.dot(v);
        for (int i = 0; i < 6; ++i) {
            force[static_cast<std::size_t>(i)] += push * s[i];
            for (int j = 0; j <= i; ++j)
                damping[static_cast<std::size_t>(triangle(i, j))] += 2.0 * c * s[i] * s[j];
        }
    }
}

void HullWater::visit_state(StateVisitor& v) {
    memory_.visit_state(v);
    waves_.visit_state(v);
}

void HullWater::check_state(StateRules& rules) const {
    memory_.check_state(rules);
    waves_.check_state(rules);
}

void HullWater::write_memory(HullMemory& out) const {
    memory_.write_memory(out);
    waves_.write_memory(out);
}

}  // namespace hawser::marine
