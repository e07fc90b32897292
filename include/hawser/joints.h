// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file joints.h
/// Joints as typed definitions, with range, motor and friction.
///
/// ```cpp
/// const hawser::JointIds boom = world.add(hawser::HingeDef{
///     .name = "boom", .a = ship, .b = boom_body, .point = {4, 0, 9}, .axis = {0, 1, 0},
///     .limit = hawser::AxisLimit{.min = -1.2, .max = 0.1},
///     .motor = hawser::AxisMotor{.force_min = -2e6, .force_max = 2e6},
///     .friction = hawser::AxisFriction{.bound = 500.0}});
/// ```
/// Each definition is translated to InteractionDefs (interactions.h). The table there defines
/// parameters, ranges and the defaults of omitted fields. The joint and its parts share points and
/// frames, so that their coordinates agree. Part names follow the joint's name: "boom",
/// "boom/limit", "boom/motor", "boom/friction". World::add() adds all parts or none.
///
/// *Frames*. Point and axis are given in the world frame at the present poses. The world transforms
/// them to the frame of each body, so that the joint has no initial violation. With
/// JointFrame::body_a they are in the frame of `a`, from its centre of mass, for a mechanism
/// described on a ship. Joints with an initial violation, or with other frames, are
/// InteractionDefs.
///
/// *Coordinate*. The coordinate of a joint is its angle [rad] or displacement [m]. At the present
/// poses it has the value `coordinate` of the definition. It increases when b turns about the axis
/// (right-hand rule) or moves along it, relative to a.

#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/math.h>

#include <cstdint>
#include <optional>
#include <string>

namespace hawser {

class World;

/// Frame of the points and axes of a definition.
enum class JointFrame : std::uint8_t {
    world,   ///< World frame, at the present poses.
    body_a,  ///< Frame of the first body, from its centre of mass.
};

/// Range of a coordinate with stops at both ends. Omitted members have the defaults of the table
/// (interactions.h).
struct AxisLimit {
    double min = kDefault, max = kDefault;  ///< Ends of the range [rad or m].
    double compliance = kDefault;           ///< Compliance of the stops [rad/(N m) or m/N].
    double damping_time = kDefault;         ///< Damping time of the stops [s].
};

/// Motor that drives a coordinate at a set speed, with a torque or force within a range.
struct AxisMotor {
    double speed = kDefault;                            ///< Set speed [rad/s or m/s].
    double force_min = kDefault, force_max = kDefault;  ///< Range of torque or force [N m or N]; >
                                                        ///< 0 increases the coordinate.
    double power = kDefault;       ///< Largest driving power [W]; default: no limit.
    double compliance = kDefault;  ///< Velocity compliance γ [rad/s/(N m) or m/s/N].
};

/// Dry friction of a coordinate. It is a brake if an input drives its bound.
struct AxisFriction {
    double bound = kDefault;  ///< Largest torque or force of friction without loads [N m or N].
    /// Factor of the joint's own force in the bound; 0: no effect. Slide: μ [1]; bearing: μ times
    /// its radius [m].
    double own_load = 0.0;
    FrictionLoad load{};  ///< Another interaction whose force adds to the bound; default: none.
    double compliance = kDefault;    ///< Compliance while sticking [rad/(N m) or m/N].
    double damping_time = kDefault;  ///< Damping time while sticking [s].
};

/// Ids of the parts of a joint; invalid for omitted parts.
struct JointIds {
    InteractionId joint{}, limit{}, motor{}, friction{};
};

/// Ids of the parts along or about an axis.
struct AxisIds {
    InteractionId limit{}, motor{}, friction{};
};

/// Ids of the parts of a cylindrical joint.
struct CylindricalIds {
    InteractionId joint{};
    AxisIds along{}, about{};
};

/// Hinge: the bodies share a point and turn about an axis.
struct HingeDef {
    std::string name{};  ///< Unique name in the world, or empty; its parts are then also unnamed.
    BodyId a{}, b{};     ///< Bodies; not lumped masses or scalar bodies. Required.
    Vec3 point{0.0, 0.0, 0.0};               ///< Point on the axis [m].
    Vec3 axis{0.0, 0.0, 1.0};                ///< Direction of the axis, any length but 0.
    JointFrame frame = JointFrame::world;    ///< Frame of `point` and `axis`.
    double coordinate = 0.0;                 ///< Angle at the present poses [rad].
    double compliance = kDefault;            ///< Compliance of each row [m/N, rad/(N m)]; 0: rigid.
    double damping_time = kDefault;          ///< Damping time of each row [s].
    std::optional<AxisLimit> limit{};        ///< Range of the angle; none: unlimited.
    std::optional<AxisMotor> motor{};        ///< Motor; none: the hinge turns freely.
    std::optional<AxisFriction> friction{};  ///< Friction or brake; none: without friction.
};

/// Prismatic joint: b slides along an axis without rotation relative to a.
struct PrismaticDef {
    std::string name{};         ///< As in HingeDef.
    BodyId a{}, b{};            ///< Bodies; not lumped masses or scalar bodies. Required.
    Vec3 point{0.0, 0.0, 0.0};  ///< Point of b on the axis [m].
    Vec3 axis{0.0, 0.0, 1.0};   ///< Direction of the axis, any length but 0.
    JointFrame frame = JointFrame::world;    ///< Frame of `point` and `axis`.
    double coordinate = 0.0;                 ///< Displacement at the present poses [m].
    double compliance = kDefault;            ///< Compliance of each row [m/N, rad/(N m)]; 0: rigid.
    double damping_time = kDefault;          ///< Damping time of each row [s].
    std::optional<AxisLimit> limit{};        ///< Range of the displacement; none: unlimited.
    std::optional<AxisMotor> motor{};        ///< Motor; none: the joint slides freely.
    std::optional<AxisFriction> friction{};  ///< Friction or brake; none: without friction.
};

/// Range, motor and friction of one of the two degrees of freedom of a cylindrical joint.
struct AxisParts {
    double coordinate = 0.0;                 ///< Coordinate at the present poses [m or rad].
    std::optional<AxisLimit> limit{};        ///< Range; none: unlimited.
    std::optional<AxisMotor> motor{};        ///< Motor; none: moves freely.
    std::optional<AxisFriction> friction{};  ///< Friction or brake; none: without friction.
};

/// Cylindrical joint: b slides along an axis and turns about it. Parts are named "name/along/motor"
/// and so on. World::coordinate() of the joint is the displacement along the axis [m].
struct CylindricalDef {
    std::string name{};         ///< As in HingeDef.
    BodyId a{}, b{};            ///< Bodies; not lumped masses or scalar bodies. Required.
    Vec3 point{0.0, 0.0, 0.0};  ///< Point of b on the axis [m].
    Vec3 axis{0.0, 0.0, 1.0};   ///< Direction of the axis, any length but 0.
    JointFrame frame = JointFrame::world;  ///< Frame of `point` and `axis`.
    double compliance = kDefault;          ///< Compliance of each row [m/N, rad/(N m)]; 0: rigid.
    double damping_time = kDefault;        ///< Damping time of each row [s].
    AxisParts along{}, about{};            ///< Parts that act along and about the axis.
};

/// Universal joint: the bodies share a point; one axis of each stays perpendicular to that of the
/// other.
struct UniversalDef {
    std::string name{};          ///< Unique name in the world, or empty.
    BodyId a{}, b{};             ///< Bodies; not lumped masses or scalar bodies. Required.
    Vec3 point{0.0, 0.0, 0.0};   ///< Common point [m].
    Vec3 axis_a{1.0, 0.0, 0.0};  ///< Axis fixed in a, any length but 0.
    Vec3 axis_b{0.0, 1.0, 0.0};  ///< Axis fixed in b, perpendicular to axis_a to 1e-6.
    JointFrame frame = JointFrame::world;
    double compliance = kDefault;    ///< Compliance of each row [m/N, rad/(N m)]; 0: rigid.
    double damping_time = kDefault;  ///< Damping time of each row [s].
};

/// Ball joint: the bodies share a point and turn about it in any direction.
struct BallDef {
    std::string name{};         ///< Unique name in the world, or empty.
    BodyId a{}, b{};            ///< Bodies. A lumped mass must lie at the point. Required.
    Vec3 point{0.0, 0.0, 0.0};  ///< Common point [m].
    JointFrame frame = JointFrame::world;
    double compliance = kDefault;    ///< Compliance of each row [m/N]; 0: rigid.
    double damping_time = kDefault;  ///< Damping time of each row [s].
};

/// Lock: rigid connection; the bodies keep their present relative pose.
struct LockDef {
    std::string name{};         ///< Unique name in the world, or empty.
    BodyId a{}, b{};            ///< Bodies; not lumped masses or scalar bodies. Required.
    Vec3 point{0.0, 0.0, 0.0};  ///< Reference point of the joint's force [m].
    JointFrame frame = JointFrame::world;
    double compliance = kDefault;    ///< Compliance of each row [m/N, rad/(N m)]; 0: rigid.
    double damping_time = kDefault;  ///< Damping time of each row [s].
};

/// Pair of gear wheels on a carrier. Their hinges, with parallel axes, are separate definitions.
struct GearDef {
    std::string name{};                   ///< Unique name in the world, or empty.
    BodyId carrier{}, first{}, second{};  ///< Bodies; not lumped masses or scalar bodies. Required.
    Vec3 axis{0.0, 0.0, 1.0};             ///< Direction of both wheels' axes, any length but 0.
    JointFrame frame = JointFrame::world;  ///< body_a: frame of the carrier.
    int teeth_first = 0;                   ///< Number of teeth, 1 to 10,000. Required.
    int teeth_second = 0;  ///< Number of teeth; < 0: internal gear, the first wheel turns within a
                           ///< ring. Required.
    double compliance = kDefault;    ///< Compliance of the mesh, as rotation of the first wheel
                                     ///< [rad/(N m)].
    double damping_time = kDefault;  ///< Damping time of the mesh [s].
};

/// Add a joint with its parts, all or none; World::add() calls it.
/// @throws DefError as World::add_interaction().
JointIds define(World& world, const HingeDef& def);
JointIds define(World& world, const PrismaticDef& def);
CylindricalIds define(World& world, const CylindricalDef& def);
InteractionId define(World& world, const UniversalDef& def);
InteractionId define(World& world, const BallDef& def);
InteractionId define(World& world, const LockDef& def);
InteractionId define(World& world, const GearDef& def);

}  // namespace hawser
