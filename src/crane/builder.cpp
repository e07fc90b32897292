// SPDX-License-Identifier: Apache-2.0
#include "crane/builder.h"

#include <cmath>
#include <utility>

namespace hawser::crane {
namespace {

Mat3 box_inertia(double mass, const Vec3& half) {
    const Vec3 s = half.cwiseProduct(half);
    return (mass / 3.0 * Vec3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y())).asDiagonal();
}

Vec3 without_component(const Vec3& v, const Vec3& along) { return v - v.dot(along) * along; }

}  // namespace

Quat hinge_turn() {
    Mat3 m;
    m.col(0) = Vec3::UnitX();
    m.col(1) = Vec3::UnitZ();
    m.col(2) = -Vec3::UnitY();
    return Quat(m);
}

Builder::Builder(CraneSite& site, const Common& common)
    : site_(site),
      common_(common),
      mount_body_(site.find(common.mount.on)),
      gravity_(site.gravity()) {
    if (mount_body_.kind == BodyKind::lump || mount_body_.kind == BodyKind::scalar)
        throw_def_error(common.name, "mount/on",
                        "a crane needs a rigid, kinematic or fixed body as its base");
    base_.id = common.mount.on;
    base_.turn = (mount_body_.pose.orientation * common.mount.orientation).normalized();
    base_.pin = mount_body_.pose.position + mount_body_.pose.orientation * common.mount.point;
    // Its link frame: of_world() and local() must return coordinates of the body's own frame.
    base_.centre = Vec3::Zero();
    const Quat slewed = base_.turn * Quat(Eigen::AngleAxisd(common.slew.angle, Vec3::UnitZ()));
    up_ = gravity_.norm() > 0.0 ? Vec3(-gravity_.normalized()) : slewed * Vec3::UnitZ();
    raise_axis_ = slewed * -Vec3::UnitY();
    const Vec3 level = without_component(slewed * Vec3::UnitX(), up_);
    if (!(level.norm() > 0.1))
        throw_def_error(common.name, "mount/orientation", "its boom would point along gravity");
    ahead_ = level.normalized();
}

BodyId Builder::add_body(BodyDef def) {
    const Vec3 lever = def.position - mount_body_.pose.position;
    if (def.kind != BodyKind::scalar) {
        def.velocity = mount_body_.velocity.linear + mount_body_.velocity.angular.cross(lever);
        if (def.kind == BodyKind::rigid) def.angular_velocity = mount_body_.velocity.angular;
    }
    const BodyId id = site_.add(def);
    route_bodies_[id.index] = {def.position, def.orientation, def.kind, def.mass};
    return id;
}

Link Builder::add_box(const char* what, double mass, const Vec3& half_size, const Vec3& pin,
                      const Quat& turn, const Vec3& centre, const Vec3& damping) {
    Link link{.pin = pin, .turn = turn.normalized(), .centre = centre};
    BodyDef def{.name = part_name(what)};
    def.position = link.world(centre);
    def.orientation = link.turn;
    def.mass = mass;
    def.inertia = box_inertia(mass, half_size);
    def.half_size = half_size;
    def.angular_damping = damping;
    link.id = add_body(std::move(def));
    return link;
}

Link Builder::add_link(const char* what, const CraneLink& def, const Vec3& pin, const Quat& turn) {
    const double centre = std::isnan(def.centre) ? 0.5 * def.length : def.centre;
    return add_box(what, def.mass, {0.5 * def.length, 0.5 * def.width, 0.5 * def.height}, pin, turn,
                   {centre, 0.0, 0.0});
}

BodyId Builder::add_lump(const char* what, double mass, const Vec3& at) {
    BodyDef def{.name = part_name(what), .kind = BodyKind::lump, .position = at};
    def.mass = mass;
    return add_body(std::move(def));
}

BodyId Builder::add_scalar(const char* what, double mass) {
    BodyDef def{.name = part_name(what), .kind = BodyKind::scalar};
    def.mass = mass;
    def.gravity = false;
    return add_body(std::move(def));
}

Link Builder::add_column() {
    const Quat turn = base_.turn * Quat(Eigen::AngleAxisd(common_.slew.angle, Vec3::UnitZ()));
    const Link column = add_box("column", common_.column.mass, common_.column.half_size, base_.pin,
                                turn, common_.column.centre);
    HingeParts parts;
    parts.torque = common_.slew.torque;
    parts.brake = common_.slew.brake;
    add_hinge("slew", base_, column, base_.pin, Quat::Identity(), parts);
    return column;
}

void Builder::add_hinge(const char* what, const Link& a, const Link& b, const Vec3& at,
                        const Quat& turn, const HingeParts& parts) {
    InteractionDef def;
    def.name = part_name(what);
    def.kind = InteractionKind::Hinge;
    def.body[0] = a.id;
    def.body[1] = b.id;
    // The body under the crane has its own frame, which differs from that of the mount.
    const bool mount = a.id == base_.id;
    const Pose& on = mount_body_.pose;
    def.point[0] = mount ? Vec3(on.orientation.conjugate() * (at - on.position)) : a.of_world(at);
    def.point[1] = b.of_world(at);
    def.frame[0] = mount ? Quat((on.orientation.conjugate() * a.turn * turn).normalized()) : turn;
    def.frame[1] = turn;
    site_.add(def);
    InteractionDef more = def;
    const auto add_part = [&](const char* suffix, InteractionKind kind) -> InteractionDef& {
        more.name = def.name + suffix;
        more.kind = kind;
        more.params.fill(kDefault);
        return more;
    };
    if (parts.range)
        site_.add(add_part("/limit", InteractionKind::HingeRange)
                      .set("min", parts.range->first)
                      .set("max", parts.range->second));
    // The motor starts without force, because the brake is set.
    if (parts.torque)
        site_.add(add_part("/motor", InteractionKind::HingeMotor)
                      .set("force_min", 0.0)
                      .set("force_max", 0.0));
    if (parts.brake)
        site_.add(
            add_part("/friction", InteractionKind::HingeFriction).set("torque", *parts.brake));
}

void Builder::add_cylinder(const char* what, const CraneCylinder& def, const Link& a, const Link& b,
                           double tension) {
    const std::string name = part_name(what);
    const BodyId stroke = add_scalar((std::string(what) + "/stroke").c_str(), def.mass);
    const double now = (b.world(def.head) - a.world(def.foot)).norm();
    InteractionDef strut;
    strut.name = name + "/cylinder";
    strut.kind = InteractionKind::WinchStretch;
    strut.body[0] = a.id;
    strut.body[1] = b.id;
    strut.body[2] = stroke;
    strut.point[0] = a.local(def.foot);
    strut.point[1] = b.local(def.head);
    strut.set("length", now - tension / def.stiffness).set("EA", def.stiffness * now);
    strut.set("radius", 1.0).set("tension_only", 0.0);
    strut.compliance[0] = 1.0 / def.stiffness;
    site_.add(strut);
    InteractionDef motor;
    motor.name = name + "/motor";
    motor.kind = InteractionKind::ScalarMotor;
    motor.body[0] = stroke;
    motor.set("force_min", -def.pull).set("force_max", def.push);
    site_.add(motor);
}

BodyId Builder::add_drum(const char* what, const CraneTackle& def) {
    const std::string name = part_name(what);
    const BodyId drum = add_scalar((std::string(what) + "/drum").c_str(), def.drum_inertia);
    InteractionDef motor;
    motor.name = name + "/motor";
    motor.kind = InteractionKind::ScalarMotor;
    motor.body[0] = drum;
    motor.set("force_min", 0.0).set("force_max", 0.0);
    site_.add(motor);
    InteractionDef brake;
    brake.name = name + "/friction";
    brake.kind = InteractionKind::ScalarFriction;
    brake.body[0] = drum;
    brake.set("force", def.brake * def.drum_radius);
    site_.add(brake);
    return drum;
}

RouteBody Builder::route_body(BodyId id) const {
    const auto own = route_bodies_.find(id.index);
    if (own == route_bodies_.end())
        throw_def_error(common_.name, "mount/on", "a line runs over a foreign body");
    return own->second;
}

void Builder::add_route(const RouteDef& def) {
    const RouteBodies bodies = [this](BodyId id) { return route_body(id); };
    std::vector<BodyId> slides;
    for (BodyDef& slide : route_slides(def, bodies)) slides.push_back(add_body(slide));
    RoutePlan plan = plan_route(def, bodies, slides);
    std::vector<InteractionId> parts;
    for (const InteractionDef& d : plan.parts) parts.push_back(site_.add(d));
    for (RoutePlan::Friction& f : plan.frictions) {
        for (std::size_t k = 0; k < 2; ++k) f.def.load[k].interaction = parts[f.place + k];
        site_.add(f.def);
    }
}

}  // namespace hawser::crane
