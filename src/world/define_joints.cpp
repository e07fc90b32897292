// SPDX-License-Identifier: Apache-2.0
#include <hawser/joints.h>
#include <hawser/world.h>

#include "world/checks.h"
#include "world/define.h"

#include <cmath>
#include <utility>

namespace hawser {
namespace world {

void Parts::add_to(World& world) const {
    std::vector<InteractionId> made(defs.size());
    world.add_interactions(defs, made);
    for (std::size_t i = 0; i < made.size(); ++i) *ids[i] = made[i];
}

std::string part_name(const std::string& name, const char* part) {
    return name.empty() ? name : name + "/" + part;
}

void set_if_given(InteractionDef& def, std::string_view param, double value) {
    if (!std::isnan(value)) def.set(param, value);
}

void set_rows(InteractionDef& def, double compliance, double damping_time) {
    def.compliance.fill(compliance);
    def.damping_time.fill(damping_time);
}

void set_frames(InteractionDef& def, const World& world, std::size_t count, const Vec3& axis,
                JointFrame in) {
    const double length = axis.norm();
    if (!std::isfinite(length) || !(length > 1e-9))
        throw DefError(label(kind_info(def.kind).name, def.name) +
                       ": its axis has no direction; give one of any length but 0");
    const Vec3 unit_axis = axis / length;
    const Vec3 z = in == JointFrame::body_a ? Vec3(world.pose(def.body[0]).orientation * unit_axis)
                                            : unit_axis;
    const Quat frame = turn_between(Vec3::UnitZ(), z);
    for (std::size_t b = 0; b < count; ++b)
        def.frame[b] = (world.pose(def.body[b]).orientation.conjugate() * frame).normalized();
}

void set_motor(InteractionDef& def, const AxisMotor& motor) {
    set_if_given(def, "speed", motor.speed);
    set_if_given(def, "force_min", motor.force_min);
    set_if_given(def, "force_max", motor.force_max);
    set_if_given(def, "power", motor.power);
    def.compliance[0] = motor.compliance;
}

void set_friction(InteractionDef& def, const AxisFriction& friction) {
    if (!std::isnan(friction.bound)) def.params[0] = friction.bound;
    set_rows(def, friction.compliance, friction.damping_time);
    if (!friction.load.interaction.valid() && friction.load.factor != 0.0)
        throw DefError(label("interaction", def.name) +
                       ": its load names no interaction; own_load is that of the joint itself");
    def.load[0].factor = friction.own_load;
    def.load[friction.own_load == 0.0 ? 0 : 1] = friction.load;
}

namespace {

/// Set a limit. A missing end gets the largest allowed distance.
void set_limit(InteractionDef& def, const AxisLimit& limit) {
    for (const ParamInfo& p : kind_info(def.kind).params) {
        const bool low = std::string_view(p.name) == "min";
        const double bound = low ? limit.min : limit.max;
        def.set(p.name, !std::isnan(bound) ? bound : low ? p.min : p.max);
    }
    set_rows(def, limit.compliance, limit.damping_time);
}

}  // namespace

void add_axis(Parts& parts, const InteractionDef& frame, const std::string& name,
              const AxisKinds& kinds, const std::optional<AxisLimit>& limit,
              const std::optional<AxisMotor>& motor, const std::optional<AxisFriction>& friction,
              AxisIds& ids) {
    const auto part = [&](InteractionKind kind, const char* what) {
        InteractionDef def;
        def.kind = kind;
        def.name = part_name(name, what);
        def.body = frame.body;
        def.point = frame.point;
        def.frame = frame.frame;
        return def;
    };
    if (limit) {
        InteractionDef def = part(kinds.limit, "limit");
        set_limit(def, *limit);
        parts.add(std::move(def), ids.limit);
    }
    if (motor) {
        InteractionDef def = part(kinds.motor, "motor");
        set_motor(def, *motor);
        parts.add(std::move(def), ids.motor);
    }
    if (friction) {
        InteractionDef def = part(kinds.friction, "friction");
        set_friction(def, *friction);
        parts.add(std::move(def), ids.friction);
    }
}

namespace {

constexpr AxisKinds kHingeKinds{InteractionKind::HingeRange, InteractionKind::HingeMotor,
                                InteractionKind::HingeFriction};
constexpr AxisKinds kSliderKinds{InteractionKind::SlideRange, InteractionKind::SlideMotor,
                                 InteractionKind::SlideFriction};

/// A joint of two bodies and its position in the world.
class Joint {
  public:
    template <class Def>
    Joint(const World& world, InteractionKind kind, const Def& def)
        : world_(world), kind_(kind), name_(def.name), in_a_(def.frame == JointFrame::body_a) {
        out.kind = kind;
        out.name = def.name;
        out.body = {def.a, def.b};
        pose_[0] = world.pose(def.a);
        pose_[1] = world.pose(def.b);
        point_ = in_a_ ? Vec3(pose_[0].position + pose_[0].orientation * def.point) : def.point;
        for (std::size_t b = 0; b < 2; ++b) set_point(b, point_);
        set_rows(out, def.compliance, def.damping_time);
    }

    void set_point(std::size_t slot, const Vec3& point) {
        out.point[slot] = pose_[slot].orientation.conjugate() * (point - pose_[slot].position);
        const bool lump = world_.body_def(out.body[slot]).kind == BodyKind::lump;
        // Positions are written with six decimals.
        if (lump && out.point[slot].norm() > 2e-6)
            throw_def_error("a lump is a point, " + number(out.point[slot].norm()) +
                            " m away from there; put the joint at its position");
    }
    /// Return a direction of the definition in world axes.
    [[nodiscard]] Vec3 direction(const Vec3& axis) const {
        const double length = axis.norm();
        if (!std::isfinite(length) || !(length > 1e-9))
            throw_def_error("its axis has no direction; give one of any length but 0");
        return (in_a_ ? Vec3(pose_[0].orientation * axis) : axis) / length;
    }
    /// Set the frame of one side with z along a direction of the world.
    void set_frame(std::size_t slot, const Vec3& z) {
        set_frame(slot, turn_between(Vec3::UnitZ(), z));
    }
    void set_frame(std::size_t slot, const Quat& frame) {
        out.frame[slot] = (pose_[slot].orientation.conjugate() * frame).normalized();
    }
    /// Set the joint frames of both bodies with z along an axis. The frames differ by the initial
    /// coordinates: the angle `turned` about the axis and the distance `separation` along it.
    void set_axis(const Vec3& axis, double turned, double separation) {
        if (!std::isfinite(turned) || !std::isfinite(separation))
            throw_def_error("its coordinate is not a finite number");
        const Vec3 z = direction(axis);
        const Quat frame = turn_between(Vec3::UnitZ(), z);
        set_frame(0, frame);
        set_frame(1, frame * Quat(Eigen::AngleAxisd(turned, Vec3::UnitZ())));
        set_point(0, point_ - separation * z);
    }
    [[noreturn]] void throw_def_error(const std::string& what) const {
        throw DefError(std::string(kind_info(kind_).name) + " " +
                       (name_.empty() ? "(unnamed)" : "'" + name_ + "'") + ": " + what);
    }

    InteractionDef out;

  private:
    const World& world_;
    InteractionKind kind_;
    std::string name_;
    bool in_a_;
    Pose pose_[2];
    Vec3 point_;
};

/// Add a hinge or slider with its parts.
template <class Def>
JointIds add_driven(World& world, InteractionKind kind, const AxisKinds& kinds, const Def& def) {
    Joint joint(world, kind, def);
    const bool turns = kind_info(kind).coordinate == KindCoordinate::about;
    joint.set_axis(def.axis, turns ? def.coordinate : 0.0, turns ? 0.0 : def.coordinate);
    JointIds ids;
    AxisIds axis;
    Parts parts;
    parts.add(joint.out, ids.joint);
    add_axis(parts, joint.out, def.name, kinds, def.limit, def.motor, def.friction, axis);
    parts.add_to(world);
    ids.limit = axis.limit;
    ids.motor = axis.motor;
    ids.friction = axis.friction;
    return ids;
}

InteractionId add_joint(World& world, const InteractionDef& def) {
    return world.add_interaction(def);
}

}  // namespace
}  // namespace world

JointIds define(World& world, const HingeDef& def) {
    return world::add_driven(world, InteractionKind::Hinge, world::kHingeKinds, def);
}

JointIds define(World& world, const PrismaticDef& def) {
    return world::add_driven(world, InteractionKind::Prismatic, world::kSliderKinds, def);
}

CylindricalIds define(World& world, const CylindricalDef& def) {
    world::Joint joint(world, InteractionKind::Cylindrical, def);
    joint.set_axis(def.axis, def.about.coordinate, def.along.coordinate);
    CylindricalIds ids;
    world::Parts parts;
    parts.add(joint.out, ids.joint);
    const auto add = [&](const AxisParts& p, const char* name, const world::AxisKinds& kinds,
                         AxisIds& to) {
        world::add_axis(parts, joint.out, world::part_name(def.name, name), kinds, p.limit, p.motor,
                        p.friction, to);
    };
    add(def.along, "along", world::kSliderKinds, ids.along);
    add(def.about, "about", world::kHingeKinds, ids.about);
    parts.add_to(world);
    return ids;
}

InteractionId define(World& world, const UniversalDef& def) {
    world::Joint joint(world, InteractionKind::Universal, def);
    const Vec3 a = joint.direction(def.axis_a), b = joint.direction(def.axis_b);
    // Axes are written with six decimals.
    if (std::abs(a.dot(b)) > 1e-6)
        joint.throw_def_error("its axes are not square to each other: their cosine is " +
                              world::number(a.dot(b)));
    joint.set_frame(0, a);
    joint.set_frame(1, b);
    return world::add_joint(world, joint.out);
}

InteractionId define(World& world, const BallDef& def) {
    return world::add_joint(world, world::Joint(world, InteractionKind::Ball, def).out);
}

InteractionId define(World& world, const GearDef& def) {
    InteractionDef out;
    out.kind = InteractionKind::Gear;
    out.name = def.name;
    out.body = {def.carrier, def.first, def.second};
    world::set_frames(out, world, 3, def.axis, def.frame);
    out.set("teeth_1", def.teeth_first);
    out.set("teeth_2", def.teeth_second);
    world::set_rows(out, def.compliance, def.damping_time);
    return world.add_interaction(out);
}

InteractionId define(World& world, const LockDef& def) {
    world::Joint joint(world, InteractionKind::Lock, def);
    for (std::size_t b = 0; b < 2; ++b) joint.set_frame(b, Quat::Identity());
    return world::add_joint(world, joint.out);
}

}  // namespace hawser
