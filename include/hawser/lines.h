// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file lines.h
/// Rods, springs, pieces of lines and drums as typed definitions.
///
/// ```cpp
/// const auto drum = world.add(hawser::DrumDef{.name = "winch", .drum = drum_body,
///                                             .motor = hawser::AxisMotor{.speed = 0.0}});
/// world.add(hawser::WinchStretchDef{.a = boom, .b = hook, .point_a = {30, 0, 0},
///                                   .drum = drum_body, .radius = 0.4, .EA = 5e7});
/// ```
/// They are a way to write InteractionDefs (interactions.h): what is left out is taken from the
/// table there, lengths from the present poses. Unlike the point of a joint, the ends of a line are
/// given in the frame of the body that each belongs to, from its centre of mass: an eye on a deck
/// stays where it is on that deck. World::local_point() tells it for a place in the world. A lump
/// is a point: its own is left out.

#include <hawser/joints.h>

namespace hawser {

/// A massless rod between two points, or a spring where it has a compliance.
struct DistanceDef {
    std::string name{};              ///< Unique in the world, or empty.
    BodyId a{}, b{};                 ///< Required.
    Vec3 point_a{0.0, 0.0, 0.0};     ///< In the frame of a [m].
    Vec3 point_b{0.0, 0.0, 0.0};     ///< In the frame of b [m].
    double length = kDefault;        ///< [m]; as they stand now.
    double compliance = kDefault;    ///< [m/N]; 1/k of a spring, 0 rigid.
    double damping_time = kDefault;  ///< [s]; c/k of a spring with a damper.
};

/// An elastic piece of a line, which only pulls.
struct StretchDef {
    std::string name{};                  ///< Unique in the world, or empty.
    BodyId a{}, b{};                     ///< Required.
    Vec3 point_a{0.0, 0.0, 0.0};         ///< In the frame of a [m].
    Vec3 point_b{0.0, 0.0, 0.0};         ///< In the frame of b [m].
    double length = kDefault;            ///< Without tension [m]; as they stand now.
    double EA = kDefault;                ///< Axial stiffness [N]. Required.
    std::optional<bool> tension_only{};  ///< False: it also pushes.
    double breaking_load = kDefault;     ///< It parts above this tension [N].
    double damping_time = kDefault;      ///< [s].
    /// Of the element, of which lumps at its ends hold half each [kg]: it moves as a straight piece
    /// (WireDef::consistent_mass). 0: the lumps move by themselves.
    double mass = 0.0;
};

/// A piece of a line whose length a drum pays out: length + radius × coordinate of the drum.
struct WinchStretchDef {
    std::string name{};  ///< Unique in the world, or empty.
    BodyId a{}, b{};     ///< Required: the body with the fairlead, and where the line ends.
    Vec3 point_a{0.0, 0.0, 0.0};  ///< Fairlead, in the frame of a [m].
    Vec3 point_b{0.0, 0.0, 0.0};  ///< In the frame of b [m].
    BodyId drum{};                ///< A scalar body. Required.
    double radius = kDefault;  ///< Line paid out per unit of the drum's coordinate [m]. Required.
    double length = kDefault;  ///< At drum coordinate 0, without tension [m]; as they stand now.
    double EA = kDefault;      ///< Axial stiffness [N]. Required.
    std::optional<bool> tension_only{};  ///< False: it also pushes.
    double breaking_load = kDefault;     ///< It parts above this tension [N].
    double damping_time = kDefault;      ///< [s].
};

/// Bending stiffness of a line at the middle one of three nodes in order.
struct BendDef {
    std::string name{};                ///< Unique in the world, or empty.
    BodyId first{}, middle{}, last{};  ///< Required.
    Vec3 point_first{0.0, 0.0, 0.0};   ///< In the frame of `first` [m].
    Vec3 point_middle{0.0, 0.0, 0.0};  ///< In the frame of `middle` [m].
    Vec3 point_last{0.0, 0.0, 0.0};    ///< In the frame of `last` [m].
    double EI = kDefault;              ///< Bending stiffness [N m²]. Required.
    double length = kDefault;          ///< Mean length of the two pieces [m]. Required.
    double damping_time = kDefault;    ///< [s].
};

/// Torsional stiffness of a line between two rigid bodies about an axis, free of torque as they
/// stand now.
struct TwistDef {
    std::string name{};              ///< Unique in the world, or empty.
    BodyId a{}, b{};                 ///< Required; not lumps or scalar bodies.
    Vec3 axis{0.0, 0.0, 1.0};        ///< World frame, of any length but 0.
    double GJ = kDefault;            ///< Torsional stiffness [N m²]. Required.
    double length = kDefault;        ///< Over which the twist acts [m]. Required.
    double damping_time = kDefault;  ///< [s].
};

/// Linear restoring of a floating body in heave, roll and pitch.
struct HydrostaticDef {
    std::string name{};                 ///< Unique in the world, or empty.
    BodyId body{};                      ///< A rigid one. Required.
    double heave_stiffness = kDefault;  ///< ρ g times the waterplane area [N/m]. Required.
    double roll_stiffness = kDefault;   ///< About the body's x axis [N m/rad]. Required.
    double pitch_stiffness = kDefault;  ///< About the body's y axis [N m/rad]. Required.
    double heave_damping = kDefault;    ///< [N s/m]; 0.
    double roll_damping = kDefault;     ///< [N m s/rad]; 0.
    double pitch_damping = kDefault;    ///< [N m s/rad]; 0.
    double rest_height = kDefault;      ///< Of the centre of mass, world frame [m]; as it is now.
};

/// What drives, brakes or holds a drum or another scalar body. Parts are called "name/motor",
/// "name/friction", "name/hold".
struct DrumDef {
    std::string name{};  ///< Of the parts: "name/motor" and so on; or empty.
    BodyId drum{};       ///< A scalar body. Required.
    std::optional<AxisMotor> motor{};
    std::optional<AxisFriction> friction{};  ///< Its own_load has to be 0: there is no joint.
    std::optional<double> hold{};  ///< Coordinate to hold it at, come what may [m or rad].
};

struct DrumIds {
    InteractionId motor{}, friction{}, hold{};
};

/// What World::add() of these calls. All or nothing. @throws DefError as add_interaction() does.
InteractionId define(World& world, const DistanceDef& def);
InteractionId define(World& world, const StretchDef& def);
InteractionId define(World& world, const WinchStretchDef& def);
InteractionId define(World& world, const BendDef& def);
InteractionId define(World& world, const TwistDef& def);
InteractionId define(World& world, const HydrostaticDef& def);
DrumIds define(World& world, const DrumDef& def);

}  // namespace hawser
