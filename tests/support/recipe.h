// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file recipe.h
/// Small scenes built in code: a list of definitions that makes a World or a bare StepContext.

#include <hawser/world.h>

#include "model/interactions.h"
#include "step/prepare.h"
#include "step/step.h"
#include "support/random.h"

#include <memory>
#include <string>
#include <vector>

namespace hawser::test {

/// Make a definition of a kind between the given bodies.
inline InteractionDef between(InteractionKind kind, const std::vector<BodyId>& ids) {
    InteractionDef d;
    d.kind = kind;
    for (std::size_t b = 0; b < ids.size(); ++b) d.body[b] = ids[b];
    return d;
}

struct Recipe {
    /// Random worlds tear and overlap, which does not matter in most tests.
    WorldDef world{.on_diverged = OnDiverged::warn};
    std::vector<BodyDef> bodies;
    std::vector<InteractionDef> interactions;

    BodyId add(BodyDef def) {
        bodies.push_back(std::move(def));
        return BodyId{static_cast<std::int32_t>(bodies.size()) - 1};
    }
    BodyId ground() { return add({.name = "ground", .kind = BodyKind::fixed}); }
    BodyId lump(const Vec3& x, double mass) {
        return add({.kind = BodyKind::lump, .position = x, .mass = mass});
    }
    BodyId scalar(double x, double mass) {
        return add({.kind = BodyKind::scalar, .position = {x, 0, 0}, .mass = mass});
    }
    BodyId rigid(const Vec3& x, const Quat& q, double mass, const Vec3& principal) {
        return add({.kind = BodyKind::rigid,
                    .position = x,
                    .orientation = q,
                    .mass = mass,
                    .inertia = principal.asDiagonal().toDenseMatrix()});
    }
    InteractionId add(const InteractionDef& def) {
        interactions.push_back(def);
        return InteractionId{static_cast<std::int32_t>(interactions.size()) - 1};
    }
    /// Attach at a world point with a world frame: consistent, so that the violation is zero.
    InteractionDef at(InteractionKind kind, const std::vector<BodyId>& ids, const Vec3& point,
                      const Quat& frame = Quat::Identity()) const {
        InteractionDef d = between(kind, ids);
        for (std::size_t b = 0; b < ids.size(); ++b) {
            const BodyDef& body = bodies[static_cast<std::size_t>(ids[b].index)];
            const bool turns = body.kind != BodyKind::lump && body.kind != BodyKind::scalar;
            const Quat q = turns ? body.orientation.normalized() : Quat::Identity();
            d.point[b] = turns ? Vec3(q.conjugate() * (point - body.position)) : Vec3::Zero();
            d.frame[b] = q.conjugate() * frame;
        }
        return d;
    }

    [[nodiscard]] World make() const { return make(world); }
    [[nodiscard]] World make(const WorldDef& def) const {
        World w(def);
        for (const BodyDef& b : bodies) w.add_body(b);
        for (const InteractionDef& i : interactions) w.add_interaction(i);
        return w;
    }
    /// Prepare a context with the bodies and interactions, without a World.
    [[nodiscard]] std::unique_ptr<context::StepContext> context() const {
        auto ctx = std::make_unique<context::StepContext>(world);
        for (const BodyDef& b : bodies) ctx->model.bodies.add(b);
        for (InteractionDef d : interactions) {
            Vec3 position[kMaxInteractionBodies], point[kMaxInteractionBodies];
            const int count = kind_info(d.kind).bodies;
            for (std::size_t b = 0; b < static_cast<std::size_t>(count); ++b) {
                const BodyDef& body = bodies[static_cast<std::size_t>(d.body[b].index)];
                const bool turns = body.kind != BodyKind::lump && body.kind != BodyKind::scalar;
                position[b] = body.position;
                point[b] = body.position;
                if (turns) point[b] += body.orientation.normalized() * d.point[b];
            }
            model::complete(d, position, count > 1 ? (point[1] - point[0]).norm() : 0.0);
            ctx->model.interactions.add(d, ctx->model.bodies, world.step);
        }
        step::prepare(*ctx);
        return ctx;
    }
};

/// Make a point mass on a rod, at x = length from the fixed point.
inline Recipe pendulum(double length = 1.0, double mass = 1.0) {
    Recipe r;
    const BodyId g = r.ground(), b = r.lump({length, 0, 0}, mass);
    InteractionDef d = between(InteractionKind::Distance, {g, b});
    r.add(d.set("length", length));
    return r;
}

/// Make rigid links of 1 m with ball joints, extended along x.
inline Recipe link_chain(int links, double mass = 10.0) {
    Recipe r;
    BodyId last = r.ground();
    for (int i = 0; i < links; ++i) {
        const BodyId b =
            r.rigid({i + 0.5, 0, 0}, Quat::Identity(), mass, {0.1, mass / 12.0, mass / 12.0});
        r.add(r.at(InteractionKind::Ball, {last, b}, {static_cast<double>(i), 0, 0}));
        last = b;
    }
    return r;
}

/// Make a sagging wire of point masses with stretch and bend between two fixed points.
inline Recipe wire(int elements, double length = 20.0) {
    Recipe r;
    std::vector<BodyId> node{r.ground()};
    const double l = length / elements;
    for (int i = 1; i < elements; ++i)
        node.push_back(r.lump({i * l, 0, -0.02 * i * (elements - i) * l}, 5.0 * l));
    node.push_back(r.add({.name = "far", .kind = BodyKind::fixed, .position = {length, 0, 0}}));
    for (std::size_t i = 0; i + 1 < node.size(); ++i) {
        InteractionDef d = between(InteractionKind::Stretch, {node[i], node[i + 1]});
        r.add(d.set("EA", 1e7).set("length", l));
    }
    for (std::size_t i = 0; i + 2 < node.size(); ++i) {
        InteractionDef d = between(InteractionKind::Bend, {node[i], node[i + 1], node[i + 2]});
        r.add(d.set("EI", 200.0).set("length", l));
    }
    return r;
}

/// Make one island with every kind of body and interaction, drawn from a seed.
Recipe mixed(std::uint64_t seed, int links = 6);

/// Make chains of random rigid links from the ground to one hull, numbered from end to end. The
/// joints of every other chain have their bodies in the opposite order.
Recipe chains(std::uint64_t seed, int count, int links);

}  // namespace hawser::test
