// SPDX-License-Identifier: Apache-2.0
/// Rods in the sea (hawser/water_rod.h), segment by segment in matrices of six rows.
#include "verify/sea_loads.h"
#include "verify/sea_tools.h"

#include <algorithm>
#include <cmath>

namespace hawser::verify {

namespace {

/// Terms of a rod in addition to the sums over its segments. Stiffness: the exact one if the
/// surface cuts the rod, otherwise a secant.
struct Lift {
    M6 cut = M6::Zero(), whole = M6::Zero();
    double deepest = 0.0, righting_couple = 0.0;
    bool crosses_surface = false;

    void put(M6& stiffness) const {
        if (crosses_surface)
            stiffness += cut;
        else if (deepest > 0.0)
            stiffness += whole / deepest;
        for (int k = 3; k < 5; ++k) stiffness(k, k) += std::max(righting_couple, 0.0);
    }
};

}  // namespace

void SeaVerifier::add_rod(const WaterRod& def, const Pose& pose, const Twist& twist) {
    const LineWater& w = def.water;
    const double volume = std::isnan(w.volume) ? kHalfTurn / 4 * w.diameter * w.diameter : w.volume;
    const Vec3 begin = pose.orientation * def.from, end = pose.orientation * def.to;
    const double length = (end - begin).norm() / def.segments, rho = def_->density;
    const Vec3 t = (end - begin).normalized(), up(0, 0, 1);
    const Mat3 tt = t * t.transpose(), across = Mat3::Identity() - tt;
    // Height of a cylinder's highest point above its middle: half its axis, and the rim of its end.
    const double half = 0.5 * std::abs((end - begin).z()) / def.segments +
                        0.5 * w.diameter * (up - t * t.z()).norm();
    Load& out = load_[static_cast<std::size_t>(def.body.index)];
    Lift lift;
    for (int i = 0; i < def.segments; ++i) {
        const double fraction = (2 * i + 1) / (2.0 * def.segments);
        const Vec3 arm = (1.0 - fraction) * begin + fraction * end;
        Water at = water(pose.position + arm);
        if (def_->convective) at.rate += convection(pose.position + arm);
        const double depth = at.surface - (pose.position + arm).z() + half;
        const double wet = std::clamp(0.5 * depth / half, 0.0, 1.0);
        if (wet <= 0.0) continue;
        out.wet = true;
        const M6 whole = motions_at(arm);
        const Eigen::Matrix<double, 3, 6> at_point = whole.topRows<3>();
        const Vec3 v = twist.linear + twist.angular.cross(arm);
        const Vec3 r = at.flow - v, rn = across * r, rt = tt * r;
        const double cn = 0.5 * rho * w.cd_normal * w.diameter * length * wet;
        const double ct = 0.5 * rho * w.cd_tangential * kHalfTurn * w.diameter * length * wet;
        Mat3 drag = cn * rn.norm() * across + 2.0 * ct * rt.norm() * tt;
        if (rn.norm() > 0.0) drag += cn / rn.norm() * rn * rn.transpose();
        const double mass = rho * volume * length * wet;
        const Mat3 added = mass * (w.ca_normal * across + w.ca_tangential * tt);
        const Vec3 inward = twist.angular.cross(twist.angular.cross(arm));
        const Vec3 push = cn * rn.norm() * rn + ct * rt.norm() * rt + drag * v +
                          (mass * Mat3::Identity() + added) * at.rate - added * inward +
                          mass * gravity_ * up;
        out.force += at_point.transpose() * push;
        out.mass += at_point.transpose() * added * at_point;
        out.damping += at_point.transpose() * drag * at_point;
        const double weight = rho * volume * length * gravity_;
        const Mat3 rise = up * up.transpose();
        lift.righting_couple += mass * gravity_ * arm.z();
        lift.deepest = std::max(lift.deepest, depth);
        if (wet < 1.0) {
            lift.crosses_surface = true;
            lift.cut += at_point.transpose() * (weight / (2.0 * half) * rise) * at_point;
        } else {
            lift.whole += at_point.transpose() * (weight * rise) * at_point;
        }
    }
    lift.put(out.stiffness);
}

}  // namespace hawser::verify
