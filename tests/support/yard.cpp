// SPDX-License-Identifier: Apache-2.0
#include "support/yard.h"

#include <algorithm>
#include <cmath>

namespace hawser::test {

Mat3 box_inertia(double mass, const Vec3& h) {
    const Vec3 s = h.cwiseProduct(h);
    return (mass / 3.0 * Vec3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y())).asDiagonal();
}

void Yard::use(const MaterialDef& def) {
    MaterialDef d = def;
    d.name = "m" + std::to_string(++names);
    material = world.add_material(d);
}

void Yard::friction(double mu) {
    MaterialDef d;
    d.friction = mu;
    use(d);
}

BodyId Yard::fixed(const Vec3& at) {
    BodyDef d;
    d.kind = BodyKind::fixed;
    d.position = at;
    return world.add_body(d);
}

BodyId Yard::body(const Vec3& at, double mass, const Vec3& half_size, const Quat& turn) {
    BodyDef d;
    d.position = at;
    d.orientation = turn;
    d.mass = mass;
    d.inertia = box_inertia(mass, half_size);
    return world.add_body(d);
}

BodyId Yard::lump(const Vec3& at, double mass) {
    BodyDef d;
    d.kind = BodyKind::lump;
    d.position = at;
    d.mass = mass;
    return world.add_body(d);
}

void Yard::add(ShapeDef shape, BodyId on) {
    shape.body = on;
    shape.material = material;
    world.add_shape(shape);
}

void Yard::plane(BodyId on) {
    ShapeDef d;
    d.kind = ShapeKind::plane;
    add(d, on);
}

BodyId Yard::box(const Vec3& at, double mass, const Vec3& half_size, const Quat& turn) {
    const BodyId b = body(at, mass, half_size, turn);
    ShapeDef d;
    d.kind = ShapeKind::box;
    d.half_size = half_size;
    add(d, b);
    return b;
}

BodyId Yard::ball(const Vec3& at, double mass, double radius) {
    return any(ShapeKind::sphere, at, mass, radius);
}

BodyId Yard::any(ShapeKind kind, const Vec3& at, double mass, double half_size) {
    const BodyId b = body(at, mass, Vec3::Constant(half_size));
    add(shape_of(kind, half_size), b);
    return b;
}

void Yard::segment(BodyId a, BodyId b, double radius) {
    ShapeDef d;
    d.kind = ShapeKind::capsule;
    d.body_b = b;
    d.radius = radius;
    add(d, a);
}

ShapeDef shape_of(ShapeKind kind, double size) {
    ShapeDef d;
    d.kind = kind;
    d.radius = size;
    d.half_length = kind == ShapeKind::capsule ? 0.5 * size : size;
    d.half_size = Vec3::Constant(size);
    if (kind == ShapeKind::hull)
        for (int i = 0; i < 6; ++i) {
            Vec3 v = Vec3::Zero();
            v[i / 2] = i % 2 == 0 ? size : -size;
            d.vertices.push_back(v);
        }
    return d;
}

std::string not_finite(const World& w) {
    for (const BodyId id : w.bodies()) {
        const std::int32_t i = id.index;
        const Pose p = w.pose(id);
        const Twist v = w.velocity(id);
        if (!p.position.allFinite()) return "position of body " + std::to_string(i);
        if (!(std::abs(p.orientation.norm() - 1.0) < 1e-9))
            return "orientation of body " + std::to_string(i);
        if (!v.linear.allFinite() || !v.angular.allFinite())
            return "velocity of body " + std::to_string(i);
    }
    const StepStats& s = w.stats();
    if (!std::isfinite(s.momentum_residual)) return "momentum residual";
    if (!std::isfinite(s.constraint_residual)) return "constraint residual";
    if (!std::isfinite(s.natural_map)) return "natural map";
    if (!std::isfinite(s.factor_work)) return "factor work";
    const Energy e = w.energy();
    if (!std::isfinite(e.mechanical() + e.applied + e.driven + e.dissipated)) return "energy";
    for (const ContactView& c : w.contacts()) {
        if (!c.point.allFinite() || !c.force.allFinite() || !std::isfinite(c.gap))
            return "a contact of shape " + std::to_string(c.shape[0].index);
        if (!(std::abs(c.normal.norm() - 1.0) < 1e-9)) return "a normal";
    }
    return "";
}

double fastest(const World& w) {
    double most = 0.0;
    for (const BodyId id : w.bodies()) most = std::max(most, w.velocity(id).linear.norm());
    return most;
}

}  // namespace hawser::test
