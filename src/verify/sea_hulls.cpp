// SPDX-License-Identifier: Apache-2.0
/// Hulls in the sea: polygons cut at the surface and three Gauss points for each triangle, exact
/// for integrands of second degree.
#include "verify/sea_loads.h"

#include <algorithm>
#include <cmath>

namespace hawser::verify {

namespace {

struct Spot {
    Vec3 x;  ///< Point relative to the centre of mass [m].
    double depth, pressure;
};

Spot crossing_point(const Spot& a, const Spot& b, double t) {
    return {a.x + t * (b.x - a.x), a.depth + t * (b.depth - a.depth),
            a.pressure + t * (b.pressure - a.pressure)};
}

/// Return the part of a triangle under the surface, corner by corner.
std::vector<Spot> wet_polygon(const Spot (&corner)[3]) {
    std::vector<Spot> out;
    for (int k = 0; k < 3; ++k) {
        const Spot &a = corner[k], &b = corner[(k + 1) % 3];
        if (a.depth > 0.0) out.push_back(a);
        if ((a.depth > 0.0) == (b.depth > 0.0)) continue;
        Spot cut = crossing_point(a, b, a.depth / (a.depth - b.depth));
        cut.depth = cut.pressure = 0.0;
        out.push_back(cut);
    }
    return out;
}

}  // namespace

void SeaVerifier::add_hull(const WaterHull& def, const Pose& pose, const Twist& twist) {
    const Vec3& velocity = twist.linear;
    const double weight = def_->density * gravity_;
    std::vector<Spot> spots;
    for (const Vec3& vertex : def.mesh.vertices) {
        Spot spot{pose.orientation * vertex, 0.0, 0.0};
        const Water at = water(pose.position + spot.x);
        const bool still = def.excitation == ExcitationKind::full;
        spot.depth = (still ? level_ : at.surface) - (pose.position + spot.x).z();
        spot.pressure = def.wave_pressure ? at.pressure : weight * std::max(spot.depth, 0.0);
        spots.push_back(spot);
    }
    Load& out = load_[static_cast<std::size_t>(def.body.index)];
    double volume = 0.0, lever = 0.0, whole = 0.0, plane = 0.0;

    Mat3 second = Mat3::Zero();
    for (const auto& t : def.mesh.triangles) {
        const Spot corner[3] = {spots[static_cast<std::size_t>(t[0])],
                                spots[static_cast<std::size_t>(t[1])],
                                spots[static_cast<std::size_t>(t[2])]};
        whole += corner[0].x.dot(corner[1].x.cross(corner[2].x)) / 6.0;
        const std::vector<Spot> part = wet_polygon(corner);
        for (std::size_t k = 2; k < part.size(); ++k) {
            const Spot &a = part[0], &b = part[k - 1], &c = part[k];
            const Vec3 area = 0.5 * (b.x - a.x).cross(c.x - a.x);
            for (int g = 0; g < 3; ++g) {
                const double w[3] = {g == 0 ? 2.0 / 3 : 1.0 / 6, g == 1 ? 2.0 / 3 : 1.0 / 6,
                                     g == 2 ? 2.0 / 3 : 1.0 / 6};
                const Vec3 x = w[0] * a.x + w[1] * b.x + w[2] * c.x;
                const double p = w[0] * a.pressure + w[1] * b.pressure + w[2] * c.pressure;
                const double s = w[0] * a.depth + w[1] * b.depth + w[2] * c.depth;
                const Vec3 push = -p * area / 3.0;
                out.force.head<3>() += push;
                out.force.tail<3>() += x.cross(push);
                const double ground = -area.z() / 3.0;
                volume += ground * s;
                lever += ground * s * (x.z() + 0.5 * s);
                const Vec3 r(1.0, x.y(), -x.x());
                plane += ground;

                second += ground * r * r.transpose();
            }
        }
    }
    const double wet = def.linear.on ? 1.0 : std::clamp(volume / whole, 0.0, 1.0);
    out.wet = wet > 0.0 || !def.wind_area.isZero(0.0);
    if (def.linear.on) out.force.setZero();  // add_statics() contains the pressure
    const Flow flow = flow_over(def, pose);
    if (wet > 0.0) add_strips(def, pose, twist, flow.wet_fraction, out);
    if (wet > 0.0 && !def.linear.on) {
        if (plane > 1e-9 * std::pow(volume, 2.0 / 3.0))
            out.stiffness.block<3, 3>(2, 2) += weight * second;
        double deepest = 0.0;
        for (const Spot& spot : spots) deepest = std::max(deepest, spot.depth);
        out.stiffness(2, 2) = std::max(out.stiffness(2, 2), weight * volume / deepest);
        for (int k = 3; k < 5; ++k) out.stiffness(k, k) += weight * std::max(lever, 0.0);
    }
    add_motion(def, pose, velocity, wet, flow, out);
}

void SeaVerifier::add_motion(const WaterHull& def, const Pose& pose, const Vec3& velocity,
                             double wet, const Flow& flow, Load& out) {
    const Mat3 axes = pose.orientation.toRotationMatrix();
    if (wet > 0.0) {
        Mat3 a[2], d[2];
        for (int k = 0; k < 2; ++k) {
            const double* m = def.added_mass.data() + 3 * k;
            const double* c = def.damping.data() + 3 * k;
            a[k] = axes * Vec3(m[0], m[1], m[2]).asDiagonal() * axes.transpose();
            d[k] = axes * Vec3(c[0], c[1], c[2]).asDiagonal() * axes.transpose();
            out.mass.block<3, 3>(3 * k, 3 * k) += a[k];
            out.damping.block<3, 3>(3 * k, 3 * k) += d[k];
        }
        out.force.head<3>() += a[0] * flow.rate + d[0] * flow.velocity;
        out.force.tail<3>() += a[1] * flow.turn_rate + d[1] * flow.turn;
        add_drag(axes, def.drag_area.cwiseProduct(flow.wet_fraction), 0.5 * def_->density,
                 flow.velocity, velocity, out);
    }
    if (wet < 1.0)
        add_drag(axes, def.wind_area.cwiseProduct(flow.dry_fraction), 0.5 * def_->wind.density,
                 wind(std::max(pose.position.z(), level_ + 10.0)), velocity, out);
}

}  // namespace hawser::verify
