// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file joints.h
/// Joints as typed definitions, with what limits, drives and rubs them.
///
/// ```cpp
/// const hawser::JointIds boom = world.add(hawser::HingeDef{
///     .name = "boom", .a = ship, .b = boom_body, .point = {4, 0, 9}, .axis = {0, 1, 0},
///     .limit = hawser::AxisLimit{.min = -1.2, .max = 0.1},
///     .motor = hawser::AxisMotor{.force_min = -2e6, .force_max = 2e6},
///     .friction = hawser::AxisFriction{.bound = 500.0}});
/// ```
/// They are a way to write InteractionDefs (interactions.h), whose table alone knows parameters,
/// ranges and defaults: what is left out here is taken from there. The joint and its parts get the
/// same points and frames, so that their coordinates agree, and names from the joint's: "boom",
/// "boom/limit", "boom/motor", "boom/friction". All parts are added or none.
///
/// **Frames.** A point and an axis are given in the world, as the bodies stand now; the world works
/// out where that is in each of them, so that the joint begins closed. JointFrame::body_a takes
/// them in the frame of `a` instead, from its centre of mass: for a mechanism that is described on
/// a ship wherever that ship is. Joints that begin open, or with other frames, are InteractionDefs.
///
/// **Zero.** The coordinate is `coordinate` as the bodies stand now, and grows where b turns about
/// the axis, by the right hand, or moves along it, against a.

#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/math.h>

#include <cstdint>
#include <optional>
#include <string>

namespace hawser {

class World;

/// Where points and axes of a definition are given.
enum class JointFrame : std::uint8_t {
    world,   ///< In the world, at the present poses.
    body_a,  ///< In the frame of the first body, from its centre of mass.
};

/// Range of a coordinate; an end that is left out is as far away as the table allows.
struct AxisLimit {
    double min = kDefault, max = kDefault;  ///< [rad or m].
    double compliance = kDefault;           ///< [rad/(N m) or m/N].
    double damping_time = kDefault;         ///< [s].
};

/// Drives a coordinate at a speed, within a range of its force.
struct AxisMotor {
    double speed = kDefault;                            ///< Wanted [rad/s or m/s].
    double force_min = kDefault, force_max = kDefault;  ///< [N m or N].
    double power = kDefault;       ///< Largest driving power [W]; default: no limit.
    double compliance = kDefault;  ///< [rad/s/(N m) or m/s/N].
};

/// Dry friction, or a brake whose bound an input drives.
struct AxisFriction {
    double bound = kDefault;  ///< Largest torque or force, loads apart [N m or N].
    /// Share of the joint's own force that adds to the bound: μ of a slide [1], μ times the radius
    /// of a bearing [m]. 0: none.
    double own_load = 0.0;
    FrictionLoad load{};             ///< What else presses on it; none.
    double compliance = kDefault;    ///< [rad/(N m) or m/N].
    double damping_time = kDefault;  ///< [s].
};

/// Ids of a joint's parts; invalid where a part was not asked for.
struct JointIds {
    InteractionId joint{}, limit{}, motor{}, friction{};
};

/// Ids of what acts along or about an axis.
struct AxisIds {
    InteractionId limit{}, motor{}, friction{};
};

struct CylindricalIds {
    InteractionId joint{};
    AxisIds along{}, about{};
};

/// The bodies share a point and turn about an axis.
struct HingeDef {
    std::string name{};         ///< Unique in the world, or empty; its parts have none either then.
    BodyId a{}, b{};            ///< Required; not lumps or scalar bodies.
    Vec3 point{0.0, 0.0, 0.0};  ///< [m].
    Vec3 axis{0.0, 0.0, 1.0};   ///< Of any length but 0.
    JointFrame frame = JointFrame::world;
    double coordinate = 0.0;         ///< Angle as the bodies stand now [rad].
    double compliance = kDefault;    ///< Of each row [m/N, rad/(N m)]; 0 is rigid.
    double damping_time = kDefault;  ///< Of each row [s].
    std::optional<AxisLimit> limit{};
    std::optional<AxisMotor> motor{};
    std::optional<AxisFriction> friction{};
};

/// b slides along an axis and does not turn against a.
struct PrismaticDef {
    std::string name{};         ///< As in HingeDef.
    BodyId a{}, b{};            ///< Required; not lumps or scalar bodies.
    Vec3 point{0.0, 0.0, 0.0};  ///< Of b, on the axis [m].
    Vec3 axis{0.0, 0.0, 1.0};   ///< Of any length but 0.
    JointFrame frame = JointFrame::world;
    double coordinate = 0.0;         ///< Way as the bodies stand now [m].
    double compliance = kDefault;    ///< Of each row [m/N, rad/(N m)]; 0 is rigid.
    double damping_time = kDefault;  ///< Of each row [s].
    std::optional<AxisLimit> limit{};
    std::optional<AxisMotor> motor{};
    std::optional<AxisFriction> friction{};
};

/// What acts on one freedom of a joint that has two.
struct AxisParts {
    double coordinate = 0.0;  ///< As the bodies stand now [m or rad].
    std::optional<AxisLimit> limit{};
    std::optional<AxisMotor> motor{};
    std::optional<AxisFriction> friction{};
};

/// b slides along an axis and turns about it. Parts are called "name/along/motor" and so on.
/// World::coordinate() of the joint itself is the way along the axis.
struct CylindricalDef {
    std::string name{};         ///< As in HingeDef.
    BodyId a{}, b{};            ///< Required; not lumps or scalar bodies.
    Vec3 point{0.0, 0.0, 0.0};  ///< Of b, on the axis [m].
    Vec3 axis{0.0, 0.0, 1.0};   ///< Of any length but 0.
    JointFrame frame = JointFrame::world;
    double compliance = kDefault;    ///< Of each row [m/N, rad/(N m)]; 0 is rigid.
    double damping_time = kDefault;  ///< Of each row [s].
    AxisParts along{}, about{};
};

/// The bodies share a point; an axis of each stays square to the other's.
struct UniversalDef {
    std::string name{};          ///< Unique in the world, or empty.
    BodyId a{}, b{};             ///< Required; not lumps or scalar bodies.
    Vec3 point{0.0, 0.0, 0.0};   ///< [m].
    Vec3 axis_a{1.0, 0.0, 0.0};  ///< Fixed in a; of any length but 0.
    Vec3 axis_b{0.0, 1.0, 0.0};  ///< Fixed in b, square to axis_a to 1e-6.
    JointFrame frame = JointFrame::world;
    double compliance = kDefault;    ///< Of each row [m/N, rad/(N m)]; 0 is rigid.
    double damping_time = kDefault;  ///< Of each row [s].
};

/// The bodies share a point.
struct BallDef {
    std::string name{};         ///< Unique in the world, or empty.
    BodyId a{}, b{};            ///< Required. A lump has to lie at the point.
    Vec3 point{0.0, 0.0, 0.0};  ///< [m].
    JointFrame frame = JointFrame::world;
    double compliance = kDefault;    ///< Of each row [m/N]; 0 is rigid.
    double damping_time = kDefault;  ///< Of each row [s].
};

/// The bodies keep the pose that they have against each other.
struct LockDef {
    std::string name{};         ///< Unique in the world, or empty.
    BodyId a{}, b{};            ///< Required; not lumps or scalar bodies.
    Vec3 point{0.0, 0.0, 0.0};  ///< Where they are held, which its force is of [m].
    JointFrame frame = JointFrame::world;
    double compliance = kDefault;    ///< Of each row [m/N, rad/(N m)]; 0 is rigid.
    double damping_time = kDefault;  ///< Of each row [s].
};

/// Two wheels that mesh on a carrier. Their hinges, with parallel axes, are definitions of their
/// own.
struct GearDef {
    std::string name{};                    ///< Unique in the world, or empty.
    BodyId carrier{}, first{}, second{};   ///< Required; not lumps or scalar bodies.
    Vec3 axis{0.0, 0.0, 1.0};              ///< Of both wheels, of any length but 0.
    JointFrame frame = JointFrame::world;  ///< body_a: in the frame of the carrier.
    int teeth_first = 0;                   ///< 1 to 10,000. Required.
    int teeth_second = 0;            ///< Below 0: the first one turns within a ring. Required.
    double compliance = kDefault;    ///< Of the mesh, in turns of the first wheel [rad/(N m)].
    double damping_time = kDefault;  ///< [s].
};

/// What World::add() of these calls. All or nothing. @throws DefError as add_interaction() does.
JointIds define(World& world, const HingeDef& def);
JointIds define(World& world, const PrismaticDef& def);
CylindricalIds define(World& world, const CylindricalDef& def);
InteractionId define(World& world, const UniversalDef& def);
InteractionId define(World& world, const BallDef& def);
InteractionId define(World& world, const LockDef& def);
InteractionId define(World& world, const GearDef& def);

}  // namespace hawser
