// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file def.h
/// Plain definition structs with defaults and units, and the error of the set-up interface.

#include <hawser/id.h>
#include <hawser/math.h>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace hawser {

/// A definition that the world refuses; what() says which field, its value and the remedy.
class DefError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

enum class BodyKind : std::uint8_t {
    rigid,      ///< 6 degrees of freedom.
    lump,       ///< 3: a point mass, such as a wire node.
    scalar,     ///< 1: a drum or spool; coordinate in position.x().
    fixed,      ///< 0: part of the world.
    kinematic,  ///< 0: moves with its prescribed velocity, whatever pulls at it.
};

/// One body.
struct BodyDef {
    std::string name;  ///< Unique in the world, or empty.
    BodyKind kind = BodyKind::rigid;
    Vec3 position{0.0, 0.0, 0.0};          ///< Centre of mass [m]; scalar: x() [m or rad].
    Quat orientation = Quat::Identity();   ///< Body to world; normalised on entry.
    Vec3 velocity{0.0, 0.0, 0.0};          ///< At time 0, world frame [m/s]; scalar: x().
    Vec3 angular_velocity{0.0, 0.0, 0.0};  ///< At time 0, world frame [rad/s].
    double mass = 0.0;                     ///< [kg]; scalar: [kg] or [kg m²]. Positive if it moves.
    Mat3 inertia = Mat3::Zero();           ///< About the centre of mass, body frame [kg m²].
    Vec3 force{0.0, 0.0, 0.0};             ///< Constant applied force, world frame [N].
    Vec3 torque{0.0, 0.0, 0.0};            ///< Constant applied torque, world frame [N m].
    Vec3 linear_damping{0.0, 0.0, 0.0};    ///< Drag along the body's axes [N s/m], ≥ 0.
    Vec3 angular_damping{0.0, 0.0, 0.0};   ///< Drag about the body's axes [N m s], ≥ 0.
    bool gravity = true;                   ///< False: weightless (floating at rest, drums).
    Vec3 half_size{0.0, 0.0, 0.0};         ///< Box for pictures only [m]; zero: a point.
};

/// Which form of the time step's equations to factor (paper, eq. (1)).
enum class Form : std::uint8_t {
    automatic,  ///< Per interaction: condensed where that is numerically safe, else kept.
    saddle,     ///< Every interaction kept as rows with multipliers.
    condensed,  ///< Every row with compliance > 0 eliminated first into the bodies' blocks.
};

/// Settings of a world; fixed once it has been created except where World has a setter.
struct WorldDef {
    double step = 1.0 / 60.0;       ///< Time step h [s].
    Vec3 gravity{0.0, 0.0, -9.81};  ///< [m/s²].
    Form form = Form::automatic;
    double geometric_stiffness = 1.0;  ///< Scale of the conservative K_g terms; 0 = off.
    double rotation_damping =
        0.1;                      ///< k_b: numerical relative-rotation damping of joints; 0 = off.
    bool staggered_start = true;  ///< v₀ taken at t = −h/2, which makes the scheme second order.
    int refinements = 1;          ///< Refinement steps on the saddle residual, 0-4.
    int threads = 1;              ///< Worker threads; results do not depend on it.
    std::int32_t max_bodies = 4'000'000;        ///< Refuse to grow beyond this.
    std::int32_t max_interactions = 8'000'000;  ///< Refuse to grow beyond this.
};

/// A number that may be changed between steps by name, within a range.
struct InputDef {
    std::string name;             ///< Unique among inputs. Required.
    InteractionId interaction{};  ///< Interaction whose parameter is driven, or …
    std::string param;            ///< … name of a parameter with ParamInfo::input set.
    BodyId body{};                ///< … body whose applied force (0-2) or torque (3-5) is driven.
    int component = 0;            ///< 0-2 force x, y, z [N]; 3-5 torque [N m]; with `body` only.
    double min = -1e30;           ///< Values are clamped to the range, with a warning.
    double max = 1e30;
};

}  // namespace hawser
