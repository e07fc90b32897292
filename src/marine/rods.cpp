// SPDX-License-Identifier: Apache-2.0
#include "marine/rods.h"

#include <hawser/world.h>

#include "marine/bodies.h"

#include <algorithm>
#include <cmath>

namespace hawser::marine {
namespace {

static_assert(RodWater::kChunk <= WaterField::kMostPoints);

/// Add c b bᵀ for b = (n, p × n): the contribution of the direction n at the point p to the six
/// motions.
void add_at(double c, const Vec3& n, const Vec3& arm, std::array<double, 21>& to) noexcept {
    const Vec3 turn = arm.cross(n);
    const double b[6] = {n.x(), n.y(), n.z(), turn.x(), turn.y(), turn.z()};
    for (int i = 0, k = 0; i < 6; ++i) {
        const double row = c * b[i];
        for (int j = 0; j <= i; ++j, ++k) to[static_cast<std::size_t>(k)] += row * b[j];
    }
}

/// Add c r rᵀ for r = (1, y, −x).
void add_rise(double c, const Vec3& arm, std::array<double, 6>& to) noexcept {
    const double r[3] = {1.0, arm.y(), -arm.x()};
    for (int i = 0, k = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j, ++k) to[static_cast<std::size_t>(k)] += c * r[i] * r[j];
}

template <std::size_t N>
void add_all(const std::array<double, N>& from, std::array<double, N>& to) noexcept {
    for (std::size_t k = 0; k < N; ++k) to[k] += from[k];
}

}  // namespace

RodWater::RodWater(const WaterRod& def)
    : def_(def),
      along_((def.to - def.from).normalized()),
      side_(along_.unitOrthogonal()),
      other_(along_.cross(side_)),
      length_((def.to - def.from).norm() / def.segments),
      parts_(static_cast<std::size_t>((def.segments + kChunk - 1) / kChunk)),
      t_(along_),
      n_{side_, other_} {
    def_.water = with_volume(def.water);
}

void RodWater::begin(const World& world) noexcept {
    const Pose pose = world.pose(def_.body);
    position_ = pose.position;
    twist_ = world.velocity(def_.body);
    axes_ = pose.orientation.toRotationMatrix();
    t_ = axes_ * along_;
    n_[0] = axes_ * side_;
    n_[1] = axes_ * other_;
    // √(1 − t_z²), computed without cancellation.
    vertical_extent_ =
        length_ * std::abs(t_.z()) + def_.water.diameter * std::hypot(t_.x(), t_.y());
}

void RodWater::load(const WaterField& field, bool convective, int chunk) noexcept {
    Part& out = parts_[static_cast<std::size_t>(chunk)];
    out = {};
    const Sea& sea = field.sea();
    const WaterLaw law{sea.density(), sea.gravity()};
    const int first = chunk * kChunk, count = std::min(kChunk, def_.segments - first);
    FieldPoint points[kChunk];
    WaterPoint water[kChunk];
    for (int i = 0; i < count; ++i) {
        const double fraction = (first + i + 0.5) / def_.segments;
        const Vec3 place = position_ + axes_ * (def_.from + fraction * (def_.to - def_.from));
        points[i] = {place, place.z() + 0.5 * vertical_extent_};
    }
    field.water(points, count, water);
    for (int i = 0; i < count; ++i) {
        const double fraction = (first + i + 0.5) / def_.segments;
        const Vec3 arm = axes_ * (def_.from + fraction * (def_.to - def_.from));
        if (convective) water[i].acceleration += sea.convection(field.now(), position_ + arm);
        add_segment(arm, water[i], law, out);
    }
}

void RodWater::add_segment(const Vec3& arm, const WaterPoint& water, const WaterLaw& law,
                           Part& out) const noexcept {
    const LineWater& of = def_.water;
    const double depth = water.elevation - (position_.z() + arm.z() - 0.5 * vertical_extent_);
    const double wet = wet_fraction(depth, 0.0, vertical_extent_);
    if (!(wet > 0.0)) return;
    out.wet = true;
    out.deepest = std::max(out.deepest, depth);
    const Vec3 turning = twist_.angular.cross(arm), velocity = twist_.linear + turning;
    const PieceWater p = water_past({&of, t_, length_, wet}, velocity, water, law.density);
    Vec3 push = p.drag + p.wave;
    for (const Vec3& n : n_) {
        add_at(p.cn * p.fast, n, arm, out.damping);
        add_at(p.mass * of.ca_normal, n, arm, out.mass);
    }
    const Vec3 past = velocity - t_ * t_.dot(velocity);
    push += p.cn * p.fast * past + 2.0 * p.ct * p.slide * (velocity - past);
    if (p.fast > 0.0) {
        add_at(p.cn / p.fast, p.across, arm, out.damping);
        push += p.cn / p.fast * p.across.dot(velocity) * p.across;
    }
    add_at(2.0 * p.ct * p.slide, t_, arm, out.damping);
    add_at(p.mass * of.ca_tangential, t_, arm, out.mass);
    // Part of the point's acceleration that does not come from the change of the body's velocity.
    const Vec3 inward = twist_.angular.cross(turning), inward_along = t_ * t_.dot(inward);
    push -= p.mass * (of.ca_normal * (inward - inward_along) + of.ca_tangential * inward_along);
    const double weight = p.displaced * law.gravity;
    push.z() += weight * wet;
    out.righting += weight * wet * arm.z();
    if (wet < 1.0) {
        out.pierced = true;
        add_rise(weight / vertical_extent_, arm, out.cut);
    } else {
        add_rise(weight, arm, out.under);
    }
    const Vec3 moment = arm.cross(push);
    for (std::size_t k = 0; k < 3; ++k) {
        out.force[k] += push[static_cast<int>(k)];
        out.force[3 + k] += moment[static_cast<int>(k)];
    }
}

void RodWater::finish() noexcept {
    force.fill(0.0);
    mass.fill(0.0);
    damping.fill(0.0);
    stiffness.fill(0.0);
    Part all;
    for (const Part& part : parts_) {
        all.wet = all.wet || part.wet;
        all.pierced = all.pierced || part.pierced;
        all.deepest = std::max(all.deepest, part.deepest);
        all.righting += part.righting;
        add_all(part.cut, all.cut);
        add_all(part.under, all.under);
        add_all(part.force, force);
        add_all(part.mass, mass);
        add_all(part.damping, damping);
    }
    any_ = all.wet;
    if (!any_) return;
    const double secant = all.pierced ? 0.0 : 1.0 / all.deepest;
    for (int i = 0, k = 0; i < 3; ++i)  // heave, turns about x and y are rows 2, 3, 4
        for (int j = 0; j <= i; ++j, ++k)
            stiffness[static_cast<std::size_t>(triangle(2 + i, 2 + j))] +=
                all.cut[static_cast<std::size_t>(k)] +
                secant * all.under[static_cast<std::size_t>(k)];
    const double stable = std::max(all.righting, 0.0);
    stiffness[static_cast<std::size_t>(triangle(3, 3))] += stable;
    stiffness[static_cast<std::size_t>(triangle(4, 4))] += stable;
}

}  // namespace hawser::marine
