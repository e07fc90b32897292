// SPDX-License-Identifier: Apache-2.0
#include <hawser/joints.h>
#include <hawser/pin.h>
#include <hawser/post.h>
#include <hawser/world.h>

#include "base/number.h"
#include "wire/pin_system.h"
#include "wire/post_system.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string>

namespace hawser {
namespace wire {

namespace {
constexpr double kTargetTolerance =
    1e-3;  ///< Distance from the target at which the pin stands [m].
}

void PinSystem::visit_state(StateVisitor& v) {
    for (double* x : {&up_, &height_, &speed_}) v.visit(*x);
}

void PinSystem::signals(SignalTable& table) {
    table.input("up", "1", up_, 0.0, 1.0);
    table.output("height", "1", height_);
}

void PinSystem::holds(HoldTable& table) const {
    table.hold(drive_.motor);
    table.hold(drive_.speed);
}

void PinSystem::prestep(Prestep& now, Loads&) noexcept {
    const double way = now.world.coordinate(drive_.motor);
    height_ = 1.0 + way / drive_.length;
    const double left = (up_ - 1.0) * drive_.length - way;
    const double target_speed =
        std::abs(left) < kTargetTolerance
            ? 0.0
            : std::clamp(0.5 * left / now.step, -drive_.max_speed, drive_.max_speed);
    if (target_speed != speed_) now.set_input(drive_.speed, target_speed);
    speed_ = target_speed;
}

}  // namespace wire

namespace {

/// Play of a pin beyond the range of its motor, between its stops [m].
constexpr double kStopPlay = 0.01;

[[noreturn]] void throw_def_error(const PinDef& def, const std::string& why) {
    throw DefError("pin '" + def.name + "': " + why);
}

void check(World& world, const PinDef& def) {
    if (def.name.empty()) throw DefError("a pin needs a name");
    for (const std::string& name : {def.name, def.name + "/post"})
        if (world.find_system(name) != nullptr)
            throw_def_error(def, "there is a system '" + name + "' already; names must be unique");
    if (!world.alive(def.body)) throw_def_error(def, "its body is missing; give one");
    const BodyKind kind = world.body_def(def.body).kind;
    if (kind == BodyKind::lump || kind == BodyKind::scalar)
        throw_def_error(def,
                        "it is on a point mass or a scalar body; give a body with an orientation");
    if (!def.from.allFinite() || !def.to.allFinite() || !((def.to - def.from).norm() >= 0.01))
        throw_def_error(def, "its axis from `from` to `to` is shorter than 0.01 m, or not finite");
    if (!(def.radius > 0.0 && def.radius <= 100.0))
        throw_def_error(def,
                        "radius = " + number(def.radius) + " m; give a length above 0 up to 100");
    if (!(def.speed > 0.0 && def.speed <= 100.0))
        throw_def_error(def,
                        "speed = " + number(def.speed) + " m/s; give a speed above 0 up to 100");
    if (!(def.density > 0.0 && def.density <= 1e6))
        throw_def_error(def,
                        "density = " + number(def.density) + " kg/m^3; give one above 0 up to 1e6");
}

double pin_mass(const PinDef& def) {
    return def.density * std::numbers::pi * def.radius * def.radius * (def.to - def.from).norm();
}

void check_force(const World& world, const PinDef& def) {
    const double weight = pin_mass(def) * world.settings().gravity.norm();
    if (!(def.force > weight && def.force <= 1e12))
        throw_def_error(def, "force = " + number(def.force) + " N; give more than its weight of " +
                                 number(weight) + " N, up to 1e12");
}

BodyId add_body(World& world, const PinDef& def) {
    const Vec3 along = def.to - def.from;
    const double length = along.norm();
    const Pose on = world.pose(def.body);
    const Twist twist = world.velocity(def.body);
    BodyDef body;
    body.name = def.name;
    const Vec3 sunk = def.up ? Vec3::Zero() : along;
    body.position = world.world_point(def.body, 0.5 * (def.from + def.to) - sunk);
    body.orientation = (on.orientation * turn_between(Vec3::UnitZ(), along / length)).normalized();
    body.velocity = twist.linear + twist.angular.cross(body.position - on.position);
    body.angular_velocity = twist.angular;
    body.mass = pin_mass(def);
    const double r2 = def.radius * def.radius, across = (3.0 * r2 + length * length) / 12.0;
    body.inertia = (body.mass * Vec3(across, across, 0.5 * r2)).asDiagonal();
    body.half_size = {def.radius, def.radius, 0.5 * length};
    return world.add_body(body);
}

}  // namespace

BodyId define(World& world, const PinDef& def) {
    check(world, def);
    check_force(world, def);
    const double length = (def.to - def.from).norm();
    const BodyId body = add_body(world, def);
    try {
        PrismaticDef slide{.name = def.name + "/slide", .a = def.body, .b = body};
        slide.point = world.pose(body).position;
        slide.axis = world.pose(body).orientation * Vec3::UnitZ();
        slide.coordinate = def.up ? 0.0 : -length;
        // Wire that runs along the pin must not move it beyond its housing.
        slide.limit = AxisLimit{.min = -length - kStopPlay, .max = kStopPlay};
        slide.motor = AxisMotor{.force_min = -def.force, .force_max = def.force};
        const JointIds joint = world.add(slide);
        const ShapeId shape = world.add_shape({.name = def.name + "/post",
                                               .kind = ShapeKind::cylinder,
                                               .body = body,
                                               .radius = def.radius,
                                               .half_length = 0.5 * length,
                                               .material = def.material,
                                               .group = def.group,
                                               .touches = def.touches,
                                               .margin = def.margin});
        wire::PinDrive drive{.motor = joint.motor, .length = length, .max_speed = def.speed};
        drive.speed = world.add_input(
            {.name = def.name + "/speed", .interaction = joint.motor, .param = "speed"});
        wire::add_post(world,
                       {.name = def.name + "/post",
                        .shape = shape,
                        .friction = def.friction,
                        .efficiency = def.efficiency,
                        .wires = def.wires},
                       def.body);
        world.add_system(std::make_unique<wire::PinSystem>(def.name, drive, def.up));
    } catch (...) {
        if (System* post = world.find_system(def.name + "/post")) (void)world.remove_system(*post);
        (void)world.remove_body(body);
        throw;
    }
    return body;
}

}  // namespace hawser
