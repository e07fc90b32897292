// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file crane.h
/// Cranes on any body: knuckle-boom cranes with cylinders, lattice cranes with tackles; slew drive
/// with brake, hoist of many falls, rated load curve, load moment indicator, and a hook that takes
/// and lets go of loads while the world runs.
///
/// ```cpp
/// hawser::KnuckleCraneDef def;                       // dimensions: scenes/crane_knuckle.json
/// def.name = "crane";
/// def.mount = {.on = barge, .point = {0, -8, 2}};
/// …
/// def.loads = {{.body = box, .eyes = {{0, 0, 1.5}}, .sling_length = 4, .sling_EA = 2e7}};
/// world.add(def);
/// world.set_system_signal("crane.take", 1);          // the hook takes the box once in reach
/// world.set_system_signal("crane.hoist", 0.3);       // [m/s], up
/// ```
/// **Frame.** The crane's frame has its origin in the slewing bearing, z is the slewing axis, x
/// where the boom points at slew angle 0. All of the crane lies in the x-z plane of what slews. The
/// column's frame is the crane's at slew angle 0; a boom's frame begins at its foot pin and has x
/// along it; the jib's begins at the tip of the boom.
/// ```
///    knuckle boom             jib                lattice boom         /. head
///            boom  __.--o--.__                        gantry o-----=b/  \\ pendants, bridle b
///        foot o--''  //       o  head                        |\    //    \| falls
///             |_.--''cylinder  |  falls                      | \  // boom  |
///             |column         [h] hook                      _|__o'foot    [h] hook
/// ```
/// **Parts.** Bodies NAME/column, /boom, /hook, scalar bodies NAME/hoist/drum and of a knuckle boom
/// NAME/jib, NAME/luff/stroke, NAME/knuckle/stroke, of a lattice crane NAME/bridle and
/// NAME/luffing/drum. Interactions NAME/slew, NAME/luff and NAME/knuckle are hinges (with /motor,
/// /friction, /limit); lines are routes NAME/hoist and NAME/luffing (route.h), pendants
/// NAME/pendant1 and on. Outputs and inputs find all of them.
///
/// **Cylinders.** The stroke s is a scalar body between a motor of limited force and a strut of
/// rest length l₀ + s: m s̈ = F − N, so that at rest the strut carries what the motor gives, and
/// beyond its limits the rod gives way at constant force, as over a relief valve.
///
/// **Load.** Σ T of the falls at the hook over g, less the hook, follows with the time `filter`.
/// The rated load is linear between points of the curve, constant inside the first and 0 beyond the
/// last. Utilisation = load over rated load; steps of alarm: 1 from `warning`, 2 from `overload`.
///
/// Signals, as "name.signal". Inputs: `slew` [rad/s], `luff`, `knuckle` [m/s of the cylinder; of
/// the bridle], `hoist` [m/s of the hook, up], `take`: number of the load that the hook is to hold
/// (1 the first of `loads`), 0: none. Outputs: `radius` [m], `height` [m] of the hook in the
/// crane's frame, `hang` [m] from head to hook sheaves, `load`, `rated` [kg], `utilisation` [1],
/// `moment` [N m], `alarm` 0 to 2, `held`: number of the load that hangs, `cut` 1: motions are cut
/// out. Events: `alarm`, `alarm_end` of the hook; `join`, `detach` of the load.
///
/// Limits: ropes have no weight; booms are rigid; oil is a spring. Ropes start on their sheaves and
/// stay there. Numbers are those of the time at which the last step began.

#include <hawser/def.h>
#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/math.h>

#include <string>
#include <vector>

namespace hawser {

class World;

/// Where a crane stands.
struct CraneMount {
    BodyId on{};                          ///< Required; not a lump or a scalar body.
    Vec3 point{0.0, 0.0, 0.0};            ///< Slewing bearing, in the frame of the body [m].
    Quat orientation = Quat::Identity();  ///< Of the crane's frame in that of the body.
};

/// What slews, but for booms: column, machinery, counterweight. A solid box of this size, for its
/// inertia and pictures.
struct CraneColumn {
    double mass = 0.0;              ///< [kg]. Required.
    Vec3 centre{0.0, 0.0, 0.0};     ///< Of mass, in its frame [m].
    Vec3 half_size{0.0, 0.0, 0.0};  ///< [m]. Required.
};

/// A boom or jib: as inertia goes a solid box.
struct CraneLink {
    double length = 0.0;       ///< From foot pin to head [m]. Required.
    double mass = 0.0;         ///< [kg]. Required.
    double centre = kDefault;  ///< Of mass, from the foot pin [m]; half the length.
    double width = 0.0;        ///< [m]. Required.
    double height = 0.0;       ///< [m]. Required.
};

/// Motor and brake of the slewing column. The brake is set while the wanted speed is 0.
struct CraneSlew {
    double torque = 0.0;    ///< Largest of the motor [N m]. Required.
    double brake = 0.0;     ///< Torque above which the brake slips [N m]. Required.
    double friction = 0.0;  ///< Of the bearing while it turns [N m].
    double speed = 0.0;     ///< Largest [rad/s]. Required.
    double angle = 0.0;     ///< At the start [rad].
};

/// A hydraulic cylinder between two pins. At the start it has the force that holds the crane with
/// its empty hook.
struct CraneCylinder {
    Vec3 foot{0.0, 0.0, 0.0};  ///< Pin nearer the column, in the frame of that link [m]; y = 0.
    Vec3 head{0.0, 0.0, 0.0};  ///< Pin on the link that it moves, in its frame [m]; y = 0.
    double min_length = 0.0;   ///< Between the pins, rod in [m]. Required.
    double max_length = 0.0;   ///< Rod out [m]. Required.
    double push = 0.0;         ///< Largest force [N]. Required.
    double pull = 0.0;         ///< Largest force the other way [N]. Required.
    double speed = 0.0;        ///< Largest [m/s]. Required.
    double stiffness = 0.0;    ///< Of oil and pins as it stands at the start [N/m]. Required.
    double mass = 0.0;         ///< Of rod and oil that move [kg]. Required.
};

/// Falls between two blocks, and the drum that hauls them. The brake is set while the wanted speed
/// is 0.
struct CraneTackle {
    int falls = 0;                   ///< Parts of line that carry, 1 to 64. Required.
    double EA = 0.0;                 ///< Of the line [N]. Required.
    double efficiency = 1.0;         ///< η of each sheave, (0, 1].
    double sheave_radius = 0.3;      ///< Of hoists [m]; luffing tackles run over eyes.
    double sheave_inertia = 0.0;     ///< Of each sheave at the head of a hoist [kg m²].
    Vec3 drum{0.0, 0.0, 0.0};        ///< Where the line leaves: on the column, of a knuckle boom's
                                     ///< hoist on its boom [m].
    double drum_radius = 0.0;        ///< [m]. Required.
    double drum_inertia = 0.0;       ///< With motor and gear [kg m²]. Required.
    double pull = 0.0;               ///< Line pull of the motor [N]. Required.
    double brake = 0.0;              ///< Line pull above which the brake slips [N]. Required.
    double speed = 0.0;              ///< Largest, of hook or bridle [m/s]. Required.
    double breaking_load = 1e30;     ///< Of the line [N].
    double damping_time = kDefault;  ///< Of the line [s].
};

/// The hook with its block. It hangs below the head; loads hang from its point.
struct CraneHook {
    double mass = 0.0;              ///< With block [kg]. Required.
    double height = 0.0;            ///< Of its point below the axis of its sheaves [m].
                                    ///< Required.
    Vec3 half_size{0.3, 0.3, 0.5};  ///< For its inertia and pictures [m].
    double hang = 0.0;              ///< From head to its sheaves at the start [m]. Required.
    double least_hang = 0.0;        ///< Where hauling is cut out [m].
    double angular_damping = 0.0;   ///< Of its turning [N m s].
};

struct CraneRatedLoad {
    double radius;  ///< [m]
    double mass;    ///< [kg]
};

/// Rated load and what watches it. A curve without points: nothing is rated.
struct CraneRating {
    std::vector<CraneRatedLoad> curve{};  ///< Radii grow, masses do not.
    double warning = 0.9;                 ///< Utilisation of step 1 …
    double overload = 1.0;                ///< … and of step 2 of the alarm.
    double hold = 0.5;                    ///< It lasts so long before the step changes [s].
    double filter = 0.5;                  ///< Time constant of the load that is shown [s].
    bool cut_out = false;                 ///< In step 2 no motion goes on that raises the moment.
};

/// What the hook can take: slings of equal length from its point to eyes.
struct CraneLoad {
    BodyId body{};              ///< Required; a rigid body, or a lump.
    std::vector<Vec3> eyes{};   ///< In its frame [m], 1 to 8.
    double sling_length = 0.0;  ///< Without tension [m]. Required.
    double sling_EA = 0.0;      ///< Of each [N]. Required.
    /// It is taken where no eye is farther from the hook's point than a sling is long, and this
    /// [m]; a sling that would be too short is then as long as the way.
    double reach = 0.0;
    double breaking_load = 1e30;  ///< Of each [N].
};

/// A knuckle-boom crane: two booms and two cylinders.
struct KnuckleCraneDef {
    std::string name{};  ///< Unique among systems. Required.
    CraneMount mount{};
    CraneSlew slew{};
    CraneColumn column{};
    Vec3 boom_foot{0.0, 0.0, 0.0};  ///< Foot pin, in the column's frame [m]; y = 0.
    CraneLink boom{};
    double boom_angle = 0.0;  ///< Above the level at the start [rad].
    CraneCylinder boom_cylinder{};
    CraneLink jib{};
    double jib_angle = 0.0;  ///< Against the boom at the start [rad]; below 0: folded down.
    CraneCylinder jib_cylinder{};
    CraneTackle hoist{};
    CraneHook hook{};
    CraneRating rating{};
    std::vector<CraneLoad> loads{};
    int take = 0;       ///< Load that the hook is to hold from the start; 0: none.
    double ramp = 2.0;  ///< From rest to the largest speed of each motion [s].
};

/// A lattice crane: a boom on pendants, a luffing tackle to a gantry on the column.
struct LatticeCraneDef {
    std::string name{};  ///< Unique among systems. Required.
    CraneMount mount{};
    CraneSlew slew{};
    CraneColumn column{};
    Vec3 boom_foot{0.0, 0.0, 0.0};  ///< Foot pin, in the column's frame [m]; y = 0.
    CraneLink boom{};
    double boom_angle = 0.0;                      ///< Above the level at the start [rad].
    double least_angle = 0.1, most_angle = 1.45;  ///< Back stops of the boom [rad].
    Vec3 gantry{0.0, 0.0, 0.0};                   ///< Its head, in the column's frame [m]; y = 0.
    double bridle_mass = 0.0;                     ///< [kg]. Required.
    double pendant_length = 0.0;          ///< From boom head to bridle at the start [m]. Required.
    double pendant_EA = 0.0;              ///< Of each of the two [N]. Required.
    double pendant_breaking_load = 1e30;  ///< [N]
    CraneTackle luffing{};
    CraneTackle hoist{};
    CraneHook hook{};
    CraneRating rating{};
    std::vector<CraneLoad> loads{};
    int take = 0;       ///< Load that the hook is to hold from the start; 0: none.
    double ramp = 2.0;  ///< From rest to the largest speed of each motion [s].
};

/// A body as a crane meets it.
struct CraneBody {
    Pose pose{};
    Twist velocity{};
    BodyKind kind = BodyKind::fixed;
    double mass = 0.0;  ///< [kg]
};

/// What parts of a crane are added to: a World, or a scene that is none yet.
class CraneSite {
  public:
    virtual BodyId add(const BodyDef& def) = 0;
    virtual InteractionId add(const InteractionDef& def) = 0;
    /// @throws DefError where there is none.
    [[nodiscard]] virtual CraneBody find(BodyId id) const = 0;
    [[nodiscard]] virtual Vec3 gravity() const = 0;  ///< [m/s²]

  protected:
    ~CraneSite() = default;
};

/// Its bodies and interactions, and how they begin. @throws DefError on a definition that is wrong,
/// before anything is added, or where the site refuses a part.
void build_crane(CraneSite& site, const KnuckleCraneDef& def);
void build_crane(CraneSite& site, const LatticeCraneDef& def);
/// Inputs and system, once the parts are in a world. @throws DefError where they are not.
void start_crane(World& world, const KnuckleCraneDef& def);
void start_crane(World& world, const LatticeCraneDef& def);

/// Parts that programs ask for most; all others are found by their names.
struct CraneIds {
    BodyId column{}, boom{}, jib{}, bridle{}, hook{};  ///< Jib, bridle: invalid where it has none.
    std::vector<InteractionId> falls{};                ///< Parts of line that carry the hook.
};

/// What World::add() of these calls: both of the above. All or nothing. @throws DefError.
CraneIds define(World& world, const KnuckleCraneDef& def);
CraneIds define(World& world, const LatticeCraneDef& def);

}  // namespace hawser
