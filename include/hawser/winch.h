// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file winch.h
/// Winches: a drum with layers of wire, a motor, a band brake and a clutch.
///
/// ```cpp
/// const hawser::WireId tow = world.wires().add({.name = "tow", .from = ship, .to = barge, …});
/// world.add(hawser::WinchDef{.name = "winch", .wire = tow, .core_radius = 0.6, .width = 2.4,
///                            .wire_diameter = 0.076, .mass_per_length = 25.0, .stored = 1400.0,
///                            .inertia = 4e4, .torque_haul = 2e6, .torque_pay = 2e6,
///                            .brake_static = 4e6, .mode = hawser::WinchMode::brake});
/// world.set_system_signal("winch.mode", 1.0);      // constant tension from now on
/// world.set_system_signal("winch.tension", 4e5);   // [N]
/// ```
/// *Drum*. A winch is a System (system.h). Its drum is a scalar body with the coordinate θ [rad],
/// which increases when wire is paid out. The rest length of the element at the drum is:
/// ```
///     l = length + r (θ − drum_zero),      r the radius of the outer layer [m]
/// ```
/// Motor and brake apply torques, so that their line pull Q/r decreases when layers are spooled on.
///
/// *Nodes*. The element at the drum changes its length. If the wire's elements have mass
/// (WireDef::consistent_mass), the winch inserts and removes nodes. Wire paid out therefore has
/// mass, contacts and shape. The winch inserts a node when the element reaches 1.5 times the length
/// `element`. It removes the nearest node when 0.25 times that length is left.
///
/// Half of the mass, weight and drag of the element at the drum acts on its node, half on the
/// fairlead. The output `pull` is the tension at the fairlead. It is continuous when a node is
/// inserted or removed.
///
/// *Chain*. A gypsy (GypsyDef) is a wheel with pockets for the links; its radius is constant. Chain
/// runs over it into a locker. The chain on the wheel is a separate scalar body, "name/chain", on
/// which the wire's end lies. The scalar_clutch "name/grip" couples it to the wheel up to
/// `jump_load`; above that load the chain jumps by whole pockets. The friction "name/bitter_end" is
/// the fastening of the chain in the locker.
///
/// *Heave compensation*. In mode heave the motor pays out by the upward motion of a point of the
/// ship. A load below the point keeps its height.
///
/// *Overload protection*. Automatic (AOPS): above `overload_limit` the winch pays out in every
/// mode. Manual (MOPS): the input `mops` reduces its holding force to `overload_retained` at once.
///
/// Inputs, as "name.signal":
/// - `mode`: number of a WinchMode; `speed` [m/s], `tension` [N]: set values of the modes;
/// - `brake`: applied fraction of the brake torque, 0 to 1; `clutch`: 1 engaged, 0 open;
/// - with protection: `aops`, `mops`: 1 active, 0 off.
///
/// Outputs:
/// - `layer`, `wraps`: number of the outer layer, 1 the innermost; turns on the drum;
/// - `wire_left`: wire on the drum [m]; `radius`: radius of the outer layer [m]; `across`: position
/// of
///   the wire across the drum from its middle [m]; `at_drum`: rest length of the element at the
///   drum [m];
/// - `pull`, `pull_limit`: tension at the fairlead, largest pull in the present mode [N];
/// - `inertia`: inertia of the drum with its wire [kg m²];
/// - `slip`, `heat`: wire that slipped through the brake [m], heat of the brake [J];
/// - `state`: number of a WinchState;
/// - of a gypsy: `jumps`, `jumped`: number of jumps and their length [m]; `grip`: force of the
/// wheel on
///   the chain [N]; `tail`: force of the chain inboard of the wheel [N];
/// - with protection or compensation: `wire_out`, `wire_speed`: wire outboard [m] and its speed, >
/// 0
///   out [m/s]; `peak_pull`: largest tension since the start [N]; `overload`: 1 while the
///   protection pays out; `overload_out`: wire that it has paid out [m]; `heave_error`: wire that
///   the compensation lacks [m].
///
/// Limits and derivations: docs/winches.md.

#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/math.h>

#include <cstdint>
#include <span>
#include <string>

namespace hawser {

class World;

/// Operating mode of a winch.
enum class WinchMode : std::uint8_t {
    speed,    ///< Speed control: the motor drives the wire at `speed`; > 0 pays out, < 0 hauls.
    tension,  ///< Constant tension: the motor applies the torque `tension` × radius at any speed.
    render,   ///< Render and recover: pays out above tension + deadband, hauls below tension −
              ///< deadband, stands between them.
    brake,    ///< The band brake acts with the fraction `brake` of its torque; the motor is off.
    free,     ///< Motor and brake are off.
    release,  ///< Emergency release: after `release_delay` only the tension `release_load` resists.
    heave,    ///< Heave compensation: pays out at `speed` plus the upward speed of heave_point.
};

/// Return the names of the modes in the order of WinchMode: "speed", "tension", "render", "brake",
/// "free", "release", "heave". Scene files and reports use them.
[[nodiscard]] std::span<const char* const> winch_modes() noexcept;

/// Operating state of a winch.
enum class WinchState : std::uint8_t {
    standing,    ///< The drum stands.
    paying,      ///< Wire is paid out.
    hauling,     ///< Wire is hauled in.
    slipping,    ///< The brake slips.
    waiting,     ///< An emergency release is requested, and `release_delay` runs.
    released,    ///< The emergency release is in effect.
    last_wraps,  ///< Only the dead wraps are left; the motor pays out no more.
    full,    ///< The drum is full, or the wire's end is at the fairlead and jams there in any mode.
             ///< The motor hauls no more.
    empty,   ///< The drum is empty; the fastening carries the end.
    parted,  ///< The wire is broken at its fastening.
    jumping,  ///< The chain is between two pockets of the gypsy.
};

/// Gypsy: chain wheel with pockets, and its chain locker. Usual values: five pockets, and links
/// with a pitch of 4 bar diameters. chain_properties() returns the properties of a chain.
struct GypsyDef {
    int pockets = 0;  ///< Number of pockets, one for each flat link; 0: a drum instead of a gypsy.
    double pitch = kDefault;  ///< Pitch of one link [m], two per pocket; default: 4 bar diameters.
    double jump_load = 1e30;  ///< Difference of the tensions outboard and inboard above which the
                              ///< chain jumps [N].
    /// Friction force of jumping links on the wheel [N]; default: jump_load/2.
    double jump_friction = kDefault;
    double locker_fall = 0.0;  ///< Length of chain that hangs from the wheel into the locker [m].
    double locker = 1e30;      ///< Capacity of the locker, at which the motor stops hauling [m].
    double wrap = 3.141592653589793;  ///< Angle of the wheel that is covered with chain [rad].
};

/// Definition of a winch at an end of a wire. World::add() copies it. Forces apply at the wire,
/// torques at the drum.
struct WinchDef {
    std::string name{};  ///< Unique name among systems. Parts: name/drum, name/motor,
                         ///< name/friction.
    WireId wire{};       ///< Wire whose end lies on the drum. Required.
    int end = 0;         ///< End on the drum: 0 the first, 1 the last.
    /// Existing drum: a scalar body with the mass `inertia`, on which a WinchStretch already winds
    /// this end. Invalid: the winch creates the drum and the element at it (WorldWires::spool()).
    BodyId drum{};

    /// Chain wheel instead of a drum, if `pockets` > 0. The members core_radius, width,
    /// flange_radius and layer_pitch are then not used. The length `stored` lies in the locker [m];
    /// `dead_wraps` turns of the wheel stay there. The breaking load of the bitter end is
    /// `weak_link` [N].
    GypsyDef gypsy{};
    /// Scalar body of the chain on the gypsy, with the mass gypsy_chain_inertia(), that already
    /// carries the end. Required with a gypsy if `drum` is set.
    BodyId chain{};

    double core_radius = 0.0;         ///< Radius of the bare drum [m]. Required.
    double width = 0.0;               ///< Distance between the flanges [m]. Required.
    double flange_radius = kDefault;  ///< Largest radius of the wire [m]; default: enough for
                                      ///< `stored`.
    double wire_diameter = 0.0;       ///< Wire diameter, or bar diameter of chain [m]. Required.
    double layer_pitch = kDefault;  ///< Radial distance of two layers [m]; default: wire_diameter.
    double mass_per_length = 0.0;  ///< Mass of the wire per length [kg/m]; wire on the drum adds to
                                   ///< its inertia.
    double element = kDefault;     ///< Length of the elements paid out [m]; default: that of the
                                   ///< element at the drum. 0: no nodes.
    double stored = 0.0;           ///< Length of wire on the drum at the start [m]. Required.
    double inertia = 0.0;          ///< Inertia of the bare drum and the parts fixed to it [kg m²].
                                   ///< Required.
    double motor_inertia = 0.0;    ///< Inertia of motor and gear at the drum, behind the clutch [kg
                                   ///< m²].

    double torque_haul = 1e30;  ///< Largest torque of the motor while hauling [N m].
    double torque_pay = 1e30;   ///< Largest torque of the motor while paying out [N m].
    double power = 1e30;        ///< Largest power of the motor [W].
    double max_speed = 2.0;     ///< Largest hauling speed in the modes tension and render [m/s].
    double speed = 0.0;         ///< Set speed of mode speed [m/s], > 0 pays out.
    double tension = 0.0;       ///< Set tension of the modes tension and render [N].
    double deadband = 0.0;      ///< Half width of the deadband of mode render [N].

    double brake_static = 0.0;  ///< Torque at which the band starts to slip when wire runs out [N
                                ///< m].
    double brake_dynamic = kDefault;  ///< Torque while the band slips [N m]; default: brake_static.
    double band_friction = 0.0;       ///< Friction coefficient μ of the band [1].
    double band_angle = 0.0;     ///< Wrap angle of the band [rad]. The torque when wire runs in is
                                 ///< e^(−μ band_angle) times that when it runs out.
    double release_delay = 0.0;  ///< Delay of an emergency release [s].
    double release_load = 0.0;   ///< Tension that resists after an emergency release [N].

    double dead_wraps = 5.0;     ///< Turns on the drum at which the motor stops paying out [1].
    double wrap_friction = 0.1;  ///< Friction coefficient μ of the wire on the drum, which unloads
                                 ///< the fastening [1].
    double weak_link = 0.0;  ///< Breaking load of the fastening [N]; 0: the end comes free when the
                             ///< drum is empty.

    double overload_limit = 0.0;     ///< Tension at which AOPS pays out [N]; 0: no protection. The
                                     ///< drive then balances the inertia of the drum.
    double overload_retained = 0.0;  ///< Tension that remains while `mops` is 1 [N].
    double heave_speed = 0.0;  ///< Largest speed of the compensation [m/s]; 0: no compensation.
    double heave_acceleration = 1e30;  ///< Largest acceleration of the compensation [m/s²].
    double heave_falls = 1.0;  ///< Wire paid out per height of the point [1]; falls of a tackle.
    BodyId heave_body{};       ///< Body of the compensated point; invalid: that of the fairlead.
    Vec3 heave_point{0.0, 0.0, 0.0};    ///< Point, in the frame of heave_body [m]; not used if that
                                        ///< is invalid.
    WinchMode mode = WinchMode::brake;  ///< Mode at the start.
};

/// Parts of a winch.
struct WinchIds {
    BodyId drum{};                   ///< Scalar body of the drum.
    InteractionId line{};            ///< Element at the drum.
    InteractionId motor{}, brake{};  ///< Motor and brake.
    BodyId chain{};  ///< Scalar body of the chain on a gypsy, which carries the element.
    /// Gypsy: coupling of the chain to the wheel, and its fastening in the locker.
    InteractionId grip{}, bitter_end{};
};

/// Return the mass of the scalar body of a drum [kg m²]. It is `inertia`, or with an overload_limit
/// 1e-4 of it: the winch then adds the rest as a load, except while the protection pays out.
[[nodiscard]] double drum_mass(const WinchDef& def) noexcept;
/// Return the radius of a gypsy, at which one turn pays out two pitches per pocket: pockets ×
/// pitch/π [m].
[[nodiscard]] double gypsy_radius(const WinchDef& def) noexcept;
/// Return the inertia about the wheel's axis of the chain on the wheel and in its fall, ρ (wrap r +
/// locker_fall) r² [kg m²].
[[nodiscard]] double gypsy_chain_inertia(const WinchDef& def) noexcept;

/// Properties of chain, from its bar diameter d.
struct ChainProperties {
    double mass_per_length;  ///< Mass per length in air [kg/m].
    double EA;               ///< Axial stiffness [N].
    double link;             ///< Pitch of a link, 4 d [m].
};
/// Return the properties of chain: studless 19.9e3 d² kg/m and 0.854e11 d² N, with studs 21.9e3 d²
/// kg/m and 1.01e11 d² N. Source: Orcina, OrcaFlex documentation, "Chain: mechanical properties".
/// @param diameter  Bar diameter d [m].
[[nodiscard]] ChainProperties chain_properties(double diameter, bool studs) noexcept;

/// Add a winch; World::add() calls it.
/// @throws DefError if a required field is missing or a value is out of range
/// @throws DefError if the name is already used, or the wire's end already lies on a drum
/// @throws DefError if nodes are required but the wire's elements have no mass
/// @throws DefError if the drum stores less than `stored`, or its core radius is below 2.5 wire
/// diameters
/// @throws DefError if the gypsy has fewer than 3 pockets, or drum dimensions are given with it
WinchIds define(World& world, const WinchDef& def);

}  // namespace hawser
