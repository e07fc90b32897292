// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lines.h
/// Rods, springs, line elements and drums as typed definitions.
///
/// ```cpp
/// const auto drum = world.add(hawser::DrumDef{.name = "winch", .drum = drum_body,
///                                             .motor = hawser::AxisMotor{.speed = 0.0}});
/// world.add(hawser::WinchStretchDef{.a = boom, .b = hook, .point_a = {30, 0, 0},
///                                   .drum = drum_body, .radius = 0.4, .EA = 5e7});
/// ```
/// Each definition is translated to InteractionDefs (interactions.h). Omitted fields have the
/// defaults of the table there; omitted lengths follow from the present poses.
///
/// Each end of a line is given in the frame of its own body, from the centre of mass. This differs
/// from joints, whose point is in the world frame. World::local_point() converts a world position.
/// The end on a lumped mass is the mass itself; its point is not used.

#include <hawser/joints.h>

namespace hawser {

/// Massless rod between two points, or a spring if it has compliance.
struct DistanceDef {
    std::string name{};              ///< Unique name in the world, or empty.
    BodyId a{}, b{};                 ///< Bodies at the ends. Required.
    Vec3 point_a{0.0, 0.0, 0.0};     ///< End in the frame of a [m].
    Vec3 point_b{0.0, 0.0, 0.0};     ///< End in the frame of b [m].
    double length = kDefault;        ///< Length [m]; default: the present distance.
    double compliance = kDefault;    ///< Compliance [m/N]: 1/k of a spring, 0 rigid.
    double damping_time = kDefault;  ///< Damping time [s]: c/k of a spring with a damper.
};

/// Elastic line element. It carries tension only, unless `tension_only` is false: T = EA (l −
/// l₀)/l₀ for l > l₀, else 0.
struct StretchDef {
    std::string name{};                  ///< Unique name in the world, or empty.
    BodyId a{}, b{};                     ///< Bodies at the ends. Required.
    Vec3 point_a{0.0, 0.0, 0.0};         ///< End in the frame of a [m].
    Vec3 point_b{0.0, 0.0, 0.0};         ///< End in the frame of b [m].
    double length = kDefault;            ///< Unstretched length [m]; default: the present distance.
    double EA = kDefault;                ///< Axial stiffness [N]. Required.
    std::optional<bool> tension_only{};  ///< False: it also carries compression; default: true.
    double breaking_load = kDefault;  ///< Tension above which it breaks [N]; default: unbreakable.
    double damping_time = kDefault;   ///< Damping time [s].
    /// Mass of the element for the consistent mass matrix (WireDef::consistent_mass) [kg]. The
    /// lumped masses at its ends must include half of it each. 0: lumped masses only.
    double mass = 0.0;
};

/// Line element between a fairlead and a body, whose rest length follows a drum: l₀ = length +
/// radius × coordinate of the drum.
struct WinchStretchDef {
    std::string name{};           ///< Unique name in the world, or empty.
    BodyId a{}, b{};              ///< Body with the fairlead, and body at the line's end. Required.
    Vec3 point_a{0.0, 0.0, 0.0};  ///< Fairlead, in the frame of a [m].
    Vec3 point_b{0.0, 0.0, 0.0};  ///< End in the frame of b [m].
    BodyId drum{};                ///< Scalar body. Required.
    double radius = kDefault;  ///< Length paid out per unit of the drum's coordinate [m]. Required.
    double length = kDefault;  ///< Unstretched length at drum coordinate 0 [m]; default: from the
                               ///< present poses.
    double EA = kDefault;      ///< Axial stiffness [N]. Required.
    std::optional<bool> tension_only{};  ///< False: it also carries compression; default: true.
    double breaking_load = kDefault;  ///< Tension above which it breaks [N]; default: unbreakable.
    double damping_time = kDefault;   ///< Damping time [s].
};

/// Bending stiffness of a line at the middle one of three consecutive nodes.
struct BendDef {
    std::string name{};                ///< Unique name in the world, or empty.
    BodyId first{}, middle{}, last{};  ///< Nodes. Required.
    Vec3 point_first{0.0, 0.0, 0.0};   ///< Position of the node in the frame of `first` [m].
    Vec3 point_middle{0.0, 0.0, 0.0};  ///< Position of the node in the frame of `middle` [m].
    Vec3 point_last{0.0, 0.0, 0.0};    ///< Position of the node in the frame of `last` [m].
    double EI = kDefault;              ///< Bending stiffness [N m²]. Required.
    double length = kDefault;          ///< Mean length of the two elements [m]. Required.
    double damping_time = kDefault;    ///< Damping time [s].
};

/// Torsional stiffness of a line between two rigid bodies about an axis. The torque is 0 at the
/// present poses.
struct TwistDef {
    std::string name{};              ///< Unique name in the world, or empty.
    BodyId a{}, b{};                 ///< Bodies; not lumped masses or scalar bodies. Required.
    Vec3 axis{0.0, 0.0, 1.0};        ///< Axis in the world frame, any length but 0.
    double GJ = kDefault;            ///< Torsional stiffness [N m²]. Required.
    double length = kDefault;        ///< Length over which the twist acts [m]. Required.
    double damping_time = kDefault;  ///< Damping time [s].
};

/// Linear hydrostatic stiffness of a floating body in heave, roll and pitch.
struct HydrostaticDef {
    std::string name{};                 ///< Unique name in the world, or empty.
    BodyId body{};                      ///< Rigid body. Required.
    double heave_stiffness = kDefault;  ///< Heave stiffness, ρ g times the waterplane area [N/m].
                                        ///< Required.
    double roll_stiffness = kDefault;   ///< Stiffness about the body's x axis [N m/rad]. Required.
    double pitch_stiffness = kDefault;  ///< Stiffness about the body's y axis [N m/rad]. Required.
    double heave_damping = kDefault;    ///< Heave damping [N s/m]; default: 0.
    double roll_damping = kDefault;     ///< Roll damping [N m s/rad]; default: 0.
    double pitch_damping = kDefault;    ///< Pitch damping [N m s/rad]; default: 0.
    double rest_height = kDefault;  ///< z of the centre of mass at rest, world frame [m]; default:
                                    ///< the present one.
};

/// Motor, brake and hold of a drum or another scalar body. Parts are named "name/motor",
/// "name/friction", "name/hold".
struct DrumDef {
    std::string name{};  ///< Name prefix of the parts ("name/motor" and so on), or empty.
    BodyId drum{};       ///< Scalar body. Required.
    std::optional<AxisMotor> motor{};        ///< Motor; none: the drum turns freely.
    std::optional<AxisFriction> friction{};  ///< Friction or brake. Its own_load must be 0, since
                                             ///< there is no joint.
    std::optional<double> hold{};  ///< Value at which the coordinate is fixed with any force [m or
                                   ///< rad]; none: free.
};

/// Ids of the parts of a drum; invalid for omitted parts.
struct DrumIds {
    InteractionId motor{}, friction{}, hold{};
};

/// Add an interaction, or all parts of a drum or none; World::add() calls it.
/// @throws DefError as World::add_interaction().
InteractionId define(World& world, const DistanceDef& def);
InteractionId define(World& world, const StretchDef& def);
InteractionId define(World& world, const WinchStretchDef& def);
InteractionId define(World& world, const BendDef& def);
InteractionId define(World& world, const TwistDef& def);
InteractionId define(World& world, const HydrostaticDef& def);
DrumIds define(World& world, const DrumDef& def);

}  // namespace hawser
