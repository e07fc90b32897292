// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file site.h
/// Bodies, shapes and a collider for tests, without a world.

#include "collide/collider.h"
#include "runtime/tasks.h"

#include <string>
#include <vector>

namespace hawser::test {

struct Site {
    model::Bodies bodies;
    model::Interactions interactions;
    collide::Collider collider;
    collide::ContactSet set;
    runtime::Pool pool;
    double h = 1.0 / 60.0;

    explicit Site(int threads = 1) : pool(threads) {}

    std::int32_t body(BodyKind kind, const Vec3& position, const Vec3& velocity = Vec3::Zero(),
                      const Vec3& spin = Vec3::Zero()) {
        BodyDef d;
        d.kind = kind;
        d.position = position;
        d.velocity = velocity;
        d.angular_velocity = spin;
        d.mass = 1.0;
        d.inertia = Mat3::Identity();
        return bodies.add(d);
    }
    std::int32_t lump(const Vec3& position, const Vec3& velocity = Vec3::Zero()) {
        return body(BodyKind::lump, position, velocity);
    }
    std::int32_t shape(ShapeKind kind, std::int32_t body, double radius = 0.0) {
        ShapeDef d;
        d.kind = kind;
        d.body = BodyId{body};
        d.radius = radius;
        return collider.add(d, bodies);
    }
    std::int32_t segment(std::int32_t a, std::int32_t b, double radius) {
        ShapeDef d;
        d.kind = ShapeKind::capsule;
        d.body = BodyId{a};
        d.body_b = BodyId{b};
        d.radius = radius;
        return collider.add(d, bodies);
    }
    /// Add point masses at the given positions and segments between them. @return the first
    /// segment.
    std::int32_t wire(const std::vector<Vec3>& nodes, double radius,
                      const Vec3& velocity = Vec3::Zero()) {
        std::vector<std::int32_t> lumps;
        for (const Vec3& x : nodes) lumps.push_back(lump(x, velocity));
        const std::int32_t first = collider.count();
        for (std::size_t i = 1; i < lumps.size(); ++i) segment(lumps[i - 1], lumps[i], radius);
        return first;
    }
    void prepare() {
        collider.prepare(bodies, interactions, h);
        collider.surfaces(h, set);
    }
    bool collide() {
        pool.resume();
        const bool ok = collider.collide(bodies, h, set, pool);
        pool.pause();
        return ok;
    }
    void move(std::int32_t body, const Vec3& by) {
        for (int i = 0; i < 3; ++i) bodies.x[static_cast<std::size_t>(3 * body + i)] += by[i];
    }
};

}  // namespace hawser::test
