// SPDX-License-Identifier: Apache-2.0
#include "friction_loads.h"

#include <hawser/hawser.h>

#include <cmath>
#include <limits>

namespace hawser::bench {
namespace {

constexpr double kGravity = 9.81;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

WorldDef settings(const Method& method) {
    WorldDef def;
    def.nonsmooth = method.nonsmooth;
    def.nonsmooth_sweeps = method.sweeps;
    return def;
}

}  // namespace

double creep(const Method& method, double duration) {
    World world(settings(method));
    constexpr double kFriction = 0.5, kShare = 0.8, kHalf = 0.25;
    const Quat tilt(Eigen::AngleAxisd(std::atan(kShare * kFriction), Vec3::UnitY()));
    MaterialDef steel{.name = "steel"};
    steel.friction = kFriction;
    const MaterialId material = world.add_material(steel);
    const BodyId slope =
        world.add_body({.name = "slope", .kind = BodyKind::fixed, .orientation = tilt});
    constexpr double kMass = 1000.0;
    BodyDef block{.name = "block"};
    block.position = tilt * Vec3(0.0, 0.0, kHalf);
    block.orientation = tilt;
    block.mass = kMass;
    block.inertia = Vec3(0.0625 + 0.25, 0.0625 + 0.25, 0.25 + 0.25).asDiagonal() * (kMass / 3.0);
    const BodyId body = world.add_body(block);
    world.add_shape({.kind = ShapeKind::plane, .body = slope, .material = material});
    world.add_shape({.kind = ShapeKind::box,
                     .body = body,
                     .half_size = {0.5, 0.5, kHalf},
                     .material = material});
    const auto steps = static_cast<int>(duration * 60.0 + 0.5);
    Vec3 at(0.0, 0.0, 0.0);
    for (int i = 0; i < steps; ++i) {
        if (world.step() != Status::ok) return kNone;
        if (i == 59) at = world.pose(body).position;
    }
    return (world.pose(body).position - at).norm();
}

Carried chain_load(const Method& method) {
    World world(settings(method));
    constexpr int kLinks = 100;
    constexpr double kMass = 1.0, kRatio = 1e4, kLength = 0.5;
    BodyId above = world.add_body({.name = "ceiling", .kind = BodyKind::fixed});
    InteractionId top{};
    double weight = 0.0;
    for (int i = 1; i <= kLinks; ++i) {
        BodyDef lump{.name = "", .kind = BodyKind::lump};
        lump.position = {0.0, 0.0, -kLength * i};
        lump.mass = i == kLinks ? kRatio * kMass : kMass;
        weight += lump.mass * kGravity;
        const BodyId here = world.add_body(lump);
        InteractionDef link{.kind = InteractionKind::Distance, .body = {above, here}};
        const InteractionId id = world.add_interaction(link.set("length", kLength));
        if (i == 1) top = id;
        above = here;
    }
    Carried carried;
    for (int i = 0; i < 60; ++i) {
        if (world.step() != Status::ok) return {kNone, kNone};
        const double share = -world.force(top)[0] / weight;
        if (i == 0) carried.first = share;
        carried.second = share;
    }
    return carried;
}

}  // namespace hawser::bench
