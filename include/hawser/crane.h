// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file crane.h
/// Cranes on any body: knuckle-boom cranes with cylinders, and lattice cranes with tackles. Both
/// have a slew drive with brake, a multi-fall hoist, a rated load curve, a load moment indicator,
/// and a hook. The hook attaches and detaches loads during the run.
///
/// ```cpp
/// hawser::KnuckleCraneDef def;                       // dimensions: scenes/crane_knuckle.json
/// def.name = "crane";
/// def.mount = {.on = barge, .point = {0, -8, 2}};
/// …
/// def.loads = {{.body = box, .eyes = {{0, 0, 1.5}}, .sling_length = 4, .sling_EA = 2e7}};
/// world.add(def);
/// world.set_system_signal("crane.take", 1);          // attach the box once it is within reach
/// world.set_system_signal("crane.hoist", 0.3);       // [m/s], up
/// ```
/// *Frames*. The crane's frame has its origin in the slewing bearing. Its z axis is the slewing
/// axis, its x axis the direction of the boom at slew angle 0. The crane lies in the x-z plane of
/// the slewing column. The column's frame coincides with the crane's at slew angle 0. A boom's
/// frame has its origin at the foot pin and x along the boom; the jib's origin is the boom tip.
/// ```
///    knuckle boom             jib                lattice boom         /. head
///            boom  __.--o--.__                        gantry o-----=b/  \\ pendants, bridle b
///        foot o--''  //       o  head                        |\    //    \| falls
///             |_.--''cylinder  |  falls                      | \  // boom  |
///             |column         [h] hook                      _|__o'foot    [h] hook
/// ```
/// *Parts*. Bodies: NAME/column, NAME/boom, NAME/hook. Scalar body: NAME/hoist/drum. A knuckle boom
/// adds NAME/jib, NAME/luff/stroke and NAME/knuckle/stroke, a lattice crane NAME/bridle and
/// NAME/luffing/drum. Interactions NAME/slew, NAME/luff and NAME/knuckle are hinges, with /motor,
/// /friction, /limit. Lines are the routes NAME/hoist and NAME/luffing (route.h), and the pendants
/// NAME/pendant1 and so on. Outputs and inputs may refer to all of them.
///
/// *Cylinders*. The stroke s is a scalar body of mass m. A motor of limited force F pushes it
/// against a strut of rest length l₀ + s with the force N, so that m s̈ = F − N. At rest N = F.
/// Beyond the limits of F the rod yields at constant force, as with a relief valve.
///
/// *Load indicator*. The load is Σ T of the falls at the hook over g, minus the hook's mass,
/// filtered with the time constant `filter`. The rated load is linear between points of the curve,
/// constant inside the first and 0 beyond the last. Utilisation is load over rated load; alarm
/// level 1 starts at `warning`, level 2 at `overload`.
///
/// Inputs, as "name.signal":
/// - `slew`: slew speed [rad/s];
/// - `luff`, `knuckle`: speeds of the cylinders, or of the bridle [m/s];
/// - `hoist`: speed of the hook, > 0 up [m/s];
/// - `take`: number of the load to attach, 1 the first of `loads`; 0: none.
///
/// Outputs:
/// - `radius`, `height`: position of the hook in the crane's frame [m];
/// - `hang`: distance from the head to the sheaves of the hook [m];
/// - `load`, `rated`: load and rated load [kg]; `utilisation`: their ratio [1];
/// - `moment`: load moment [N m]; `alarm`: alarm level, 0 to 2;
/// - `held`: number of the attached load, 0: none; `cut`: 1 while motions are cut out.
///
/// Events: `alarm` and `alarm_end` of the hook; `join` and `detach` of the load.
///
/// Limits: ropes have no weight; booms are rigid; oil is a linear spring. Ropes start on their
/// sheaves and stay on them. Outputs are those at the start of the last step.

#include <hawser/def.h>
#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/math.h>

#include <string>
#include <vector>

namespace hawser {

class World;

/// Mounting of a crane on a body.
struct CraneMount {
    BodyId on{};  ///< Body that carries the crane; not a lumped mass or scalar body. Required.
    Vec3 point{0.0, 0.0, 0.0};            ///< Slewing bearing, in the frame of the body [m].
    Quat orientation = Quat::Identity();  ///< Rotation from the crane's frame to that of the body.
};

/// Slewing part without booms: column, machinery, counterweight. Inertia and pictures are those of
/// a solid box.
struct CraneColumn {
    double mass = 0.0;              ///< Mass [kg]. Required.
    Vec3 centre{0.0, 0.0, 0.0};     ///< Centre of mass, in the column's frame [m].
    Vec3 half_size{0.0, 0.0, 0.0};  ///< Half sizes of the box [m]. Required.
};

/// Boom or jib with the inertia of a solid box.
struct CraneLink {
    double length = 0.0;       ///< Length from foot pin to head [m]. Required.
    double mass = 0.0;         ///< Mass [kg]. Required.
    double centre = kDefault;  ///< Distance of the centre of mass from the foot pin [m]; default:
                               ///< half the length.
    double width = 0.0;        ///< Width of the box [m]. Required.
    double height = 0.0;       ///< Height of the box [m]. Required.
};

/// Slew motor and brake. The brake is applied while the set speed is 0.
struct CraneSlew {
    double torque = 0.0;    ///< Largest torque of the motor [N m]. Required.
    double brake = 0.0;     ///< Torque at which the brake slips [N m]. Required.
    double friction = 0.0;  ///< Friction torque of the turning bearing [N m].
    double speed = 0.0;     ///< Largest slew speed [rad/s]. Required.
    double angle = 0.0;     ///< Slew angle at the start [rad].
};

/// Hydraulic cylinder between two pins. Its initial force balances the crane with an empty hook.
struct CraneCylinder {
    Vec3 foot{0.0, 0.0, 0.0};  ///< Pin nearer the column, in the frame of that link [m]; y = 0.
    Vec3 head{0.0, 0.0, 0.0};  ///< Pin on the moved link, in its frame [m]; y = 0.
    double min_length = 0.0;   ///< Distance of the pins, rod in [m]. Required.
    double max_length = 0.0;   ///< Distance of the pins, rod out [m]. Required.
    double push = 0.0;         ///< Largest pushing force [N]. Required.
    double pull = 0.0;         ///< Largest pulling force [N]. Required.
    double speed = 0.0;        ///< Largest speed [m/s]. Required.
    double stiffness = 0.0;    ///< Stiffness of oil and pins at the initial stroke [N/m]. Required.
    double mass = 0.0;         ///< Mass of the moving rod and oil [kg]. Required.
};

/// Tackle: rope in several falls between two blocks, with its drum. The brake is applied while the
/// set speed is 0.
struct CraneTackle {
    int falls = 0;                ///< Number of load-bearing falls, 1 to 64. Required.
    double EA = 0.0;              ///< Axial stiffness of the rope [N]. Required.
    double efficiency = 1.0;      ///< Efficiency η of each sheave [1], (0, 1].
    double sheave_radius = 0.3;   ///< Sheave radius of a hoist [m]; luffing tackles run over eyes.
    double sheave_inertia = 0.0;  ///< Inertia of each sheave at the head of a hoist [kg m²].
    Vec3 drum{0.0, 0.0, 0.0};   ///< Point at which the rope leaves the drum, in the column's frame
                                ///< [m]; for a knuckle boom's hoist in the boom's frame.
    double drum_radius = 0.0;   ///< Radius of the drum [m]. Required.
    double drum_inertia = 0.0;  ///< Inertia of drum, motor and gear [kg m²]. Required.
    double pull = 0.0;          ///< Largest line pull of the motor [N]. Required.
    double brake = 0.0;         ///< Line pull at which the brake slips [N]. Required.
    double speed = 0.0;         ///< Largest speed of hook or bridle [m/s]. Required.
    double breaking_load = 1e30;     ///< Breaking load of the rope [N].
    double damping_time = kDefault;  ///< Damping time of the rope [s].
};

/// Hook with its block, below the head. Loads are attached at the hook's point.
struct CraneHook {
    double mass = 0.0;    ///< Mass of hook and block [kg]. Required.
    double height = 0.0;  ///< Distance of the hook's point below the axis of its sheaves [m].
                          ///< Required.
    Vec3 half_size{0.3, 0.3, 0.5};  ///< Half sizes of the box for inertia and pictures [m].
    double hang = 0.0;        ///< Distance from the head to the hook's sheaves at the start [m].
                              ///< Required.
    double least_hang = 0.0;  ///< Distance from the head at which hoisting is cut out [m].
    double angular_damping = 0.0;  ///< Angular drag of the hook [N m s].
};

/// Point of a rated load curve.
struct CraneRatedLoad {
    double radius;  ///< Radius [m].
    double mass;    ///< Rated load [kg].
};

/// Rated load curve and alarm. Without points there is no rated load.
struct CraneRating {
    std::vector<CraneRatedLoad> curve{};  ///< Points of the curve: ascending radii, non-increasing
                                          ///< masses.
    double warning = 0.9;                 ///< Utilisation at which alarm level 1 starts [1].
    double overload = 1.0;                ///< Utilisation at which alarm level 2 starts [1].
    double hold = 0.5;     ///< Time beyond a threshold before the alarm level changes [s].
    double filter = 0.5;   ///< Time constant of the load filter [s].
    bool cut_out = false;  ///< True: at level 2 motions that increase the moment are stopped.
};

/// Load of the hook, attached by slings of equal length from the hook's point to eyes.
struct CraneLoad {
    BodyId body{};              ///< Rigid body or lumped mass. Required.
    std::vector<Vec3> eyes{};   ///< Eyes in the load's frame [m], 1 to 8.
    double sling_length = 0.0;  ///< Unstretched length of each sling [m]. Required.
    double sling_EA = 0.0;      ///< Axial stiffness of each sling [N]. Required.
    /// Permitted excess of the distance over sling_length at attachment [m]. All eyes must be
    /// within sling_length + reach of the hook's point. If the distance exceeds sling_length, it is
    /// the unstretched length of this sling.
    double reach = 0.0;
    double breaking_load = 1e30;  ///< Breaking load of each sling [N].
};

/// Knuckle-boom crane: boom and jib, each with a cylinder.
struct KnuckleCraneDef {
    std::string name{};  ///< Unique name among systems. Required.
    CraneMount mount{};
    CraneSlew slew{};
    CraneColumn column{};
    Vec3 boom_foot{0.0, 0.0, 0.0};  ///< Foot pin, in the column's frame [m]; y = 0.
    CraneLink boom{};
    double boom_angle = 0.0;  ///< Angle above the horizontal at the start [rad].
    CraneCylinder boom_cylinder{};
    CraneLink jib{};
    double jib_angle = 0.0;  ///< Angle relative to the boom at the start [rad]; < 0: folded down.
    CraneCylinder jib_cylinder{};
    CraneTackle hoist{};
    CraneHook hook{};
    CraneRating rating{};
    std::vector<CraneLoad> loads{};
    int take = 0;       ///< Number of the load attached at the start; 0: none.
    double ramp = 2.0;  ///< Time from rest to the largest speed of each motion [s].
};

/// Lattice crane: boom on pendants, with a luffing tackle to a gantry on the column.
struct LatticeCraneDef {
    std::string name{};  ///< Unique name among systems. Required.
    CraneMount mount{};
    CraneSlew slew{};
    CraneColumn column{};
    Vec3 boom_foot{0.0, 0.0, 0.0};  ///< Foot pin, in the column's frame [m]; y = 0.
    CraneLink boom{};
    double boom_angle = 0.0;  ///< Angle above the horizontal at the start [rad].
    double least_angle = 0.1, most_angle = 1.45;  ///< Limits of the boom angle [rad].
    Vec3 gantry{0.0, 0.0, 0.0};   ///< Head of the gantry, in the column's frame [m]; y = 0.
    double bridle_mass = 0.0;     ///< Mass of the bridle [kg]. Required.
    double pendant_length = 0.0;  ///< Length from boom head to bridle at the start [m]. Required.
    double pendant_EA = 0.0;      ///< Axial stiffness of each of the two pendants [N]. Required.
    double pendant_breaking_load = 1e30;  ///< Breaking load of each pendant [N].
    CraneTackle luffing{};
    CraneTackle hoist{};
    CraneHook hook{};
    CraneRating rating{};
    std::vector<CraneLoad> loads{};
    int take = 0;       ///< Number of the load attached at the start; 0: none.
    double ramp = 2.0;  ///< Time from rest to the largest speed of each motion [s].
};

/// State of a body that the construction of a crane reads.
struct CraneBody {
    Pose pose{};                      ///< Pose.
    Twist velocity{};                 ///< Velocity.
    BodyKind kind = BodyKind::fixed;  ///< Kind of the body.
    double mass = 0.0;                ///< Mass [kg].
};

/// Receiver of a crane's parts: a World, or a scene before its world exists.
class CraneSite {
  public:
    /// Add a body.
    virtual BodyId add(const BodyDef& def) = 0;
    /// Add an interaction between added bodies.
    virtual InteractionId add(const InteractionDef& def) = 0;
    /// Return the state of a body.
    /// @throws DefError if it does not exist.
    [[nodiscard]] virtual CraneBody find(BodyId id) const = 0;
    /// Return gravity, world frame [m/s²].
    [[nodiscard]] virtual Vec3 gravity() const = 0;

  protected:
    ~CraneSite() = default;
};

/// Add the bodies and interactions of a crane, with their initial state.
/// @throws DefError if the definition is invalid, before anything is added, or if the site rejects
/// a part.
void build_crane(CraneSite& site, const KnuckleCraneDef& def);
void build_crane(CraneSite& site, const LatticeCraneDef& def);
/// Add the inputs and the system of a crane whose parts build_crane() has added to the world.
/// @throws DefError if a part is missing.
void start_crane(World& world, const KnuckleCraneDef& def);
void start_crane(World& world, const LatticeCraneDef& def);

/// Principal parts of a crane. World::find_body() and find_interaction() find the others by name.
struct CraneIds {
    BodyId column{}, boom{}, jib{}, bridle{}, hook{};  ///< `jib` or `bridle` is invalid if the
                                                       ///< crane has none.
    std::vector<InteractionId> falls{};                ///< Falls that carry the hook.
};

/// Add a crane, all of it or nothing, by build_crane() and start_crane(). World::add() calls it.
/// @throws DefError if the definition is invalid.
CraneIds define(World& world, const KnuckleCraneDef& def);
CraneIds define(World& world, const LatticeCraneDef& def);

}  // namespace hawser
