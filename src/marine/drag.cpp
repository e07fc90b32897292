// SPDX-License-Identifier: Apache-2.0
#include "marine/drag.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hawser::marine {
namespace {

/// Add the buoyancy of the wetted fraction `wet`, and its stiffness if the surface cuts the piece.
void add_buoyancy(double weight, double wet, double spread, PointLoad& out) noexcept {
    out.force.z() += weight * wet;
    if (wet > 0.0 && wet < 1.0) out.stiffness.m[5] += weight / spread;
}

}  // namespace

double wet_fraction(double surface, double low, double spread) noexcept {
    const double depth = surface - low;
    return depth >= spread ? 1.0 : std::clamp(depth / spread, 0.0, 1.0);
}

PieceWater water_past(const WetPiece& piece, const Vec3& velocity, const WaterPoint& water,
                      double density) noexcept {
    const LineWater& of = *piece.of;
    const Vec3 &t = piece.t, r = water.velocity - velocity;
    PieceWater out;
    const double slide = t.dot(r);
    out.along = t * slide;
    out.across = r - out.along;
    const double sweep = 0.5 * density * of.diameter * piece.length * piece.wet;
    out.cn = sweep * of.cd_normal;
    out.ct = std::numbers::pi * sweep * of.cd_tangential;
    out.fast = out.across.norm();
    out.slide = std::abs(slide);  // t is a unit vector, or 0
    out.drag = out.cn * out.fast * out.across + out.ct * out.slide * out.along;
    out.displaced = density * of.volume * piece.length;
    out.mass = out.displaced * piece.wet;
    const Vec3 &a = water.acceleration, a_along = t * t.dot(a);
    out.wave = out.mass * (a + of.ca_normal * (a - a_along) + of.ca_tangential * a_along);
    return out;
}

void add_half_element(const HalfElement& half, const PointMotion& lump, const WaterPoint& water,
                      const WaterLaw& law, PointLoad& out) noexcept {
    const LineWater& of = *half.of;
    const double z = lump.position.z(), spread = std::abs(half.middle.z() - z) + of.diameter;
    const double low = std::min(z, half.middle.z()) - 0.5 * of.diameter;
    const double wet = wet_fraction(water.elevation, low, spread);
    if (!(wet > 0.0) || !(half.length > 0.0)) return;
    out.any = true;
    const Vec3& t = half.along;
    const PieceWater p =
        water_past({half.of, t, half.length, wet}, lump.velocity, water, law.density);
    Sym3 damping;
    const bool known = t.x() != 0.0 || t.y() != 0.0 || t.z() != 0.0;
    const auto add_plane = [&](Sym3& to, double c) {
        if (known) return to.add_across(c, t);
        for (const int k : {0, 2, 5}) to.m[k] += c;
    };
    add_plane(damping, p.cn * p.fast);
    if (p.fast > 0.0) damping.add(p.cn / p.fast, p.across);
    damping.add(2.0 * p.ct * p.slide, t);
    add_plane(out.mass, p.mass * of.ca_normal);
    out.mass.add(p.mass * of.ca_tangential, t);
    out.force += p.drag + damping * lump.velocity;
    out.force += p.wave;
    for (int k = 0; k < 6; ++k) out.damping.m[k] += damping.m[k];
    add_buoyancy(p.displaced * law.gravity, wet, spread, out);
}

void add_body_drag(const Mat3& axes, const Vec3& areas, double half_density, const Vec3& flow,
                   const Vec3& velocity, Vec3& force, Sym3& damping) noexcept {
    const Vec3 r = flow - velocity;
    Vec3 b, pushed = Vec3::Zero();
    double square = 0.0;
    for (int k = 0; k < 3; ++k) {
        b[k] = std::cbrt(half_density * areas[k]);
        b[k] *= b[k];
        const double past = axes.col(k).dot(r);
        square += b[k] * past * past;
        pushed += b[k] * past * axes.col(k);
    }
    const double q = std::sqrt(square);
    if (!(q > 0.0)) return;
    Sym3 tangent;
    for (int k = 0; k < 3; ++k) tangent.add(q * b[k], axes.col(k));
    tangent.add(1.0 / q, pushed);
    force += q * pushed + tangent * velocity;
    for (int k = 0; k < 6; ++k) damping.m[k] += tangent.m[k];
}

void add_body_water(const WaterBody& body, double height, const Mat3& axes,
                    const PointMotion& motion, const WaterPoint& water, const Vec3& wind,
                    double air, const WaterLaw& law, PointLoad& out) noexcept {
    const double wet = wet_fraction(water.elevation, motion.position.z() - 0.5 * height, height);
    const Vec3 no_area = Vec3::Zero();
    if (wet < 1.0 && body.wind_area != no_area) {
        out.any = true;
        add_body_drag(axes, body.wind_area, 0.5 * air * (1.0 - wet), wind, motion.velocity,
                      out.force, out.damping);
    }
    if (!(wet > 0.0)) return;
    out.any = true;
    add_body_drag(axes, body.drag_area, 0.5 * law.density * wet, water.velocity, motion.velocity,
                  out.force, out.damping);
    const double displaced = law.density * body.volume, mass = displaced * wet;
    const Vec3& a = water.acceleration;
    out.force += mass * a;
    for (int k = 0; k < 3; ++k) {
        out.mass.add(mass * body.added_mass[k], axes.col(k));
        out.force += mass * body.added_mass[k] * axes.col(k).dot(a) * axes.col(k);
    }
    out.force.z() += displaced * law.gravity * wet;
    // Until it is out of the water.
    const double rise = water.elevation - motion.position.z() + 0.5 * height;
    out.stiffness.m[5] += displaced * law.gravity * wet / rise;
}

}  // namespace hawser::marine
