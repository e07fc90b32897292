// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file winch.h
/// Winches: a drum with layers of wire, a motor, a band brake, a clutch, and what commands them.
///
/// ```cpp
/// const hawser::WireId tow = world.add_wire({.name = "tow", .from = ship, .to = barge, …});
/// world.add(hawser::WinchDef{.name = "winch", .wire = tow, .core_radius = 0.6, .width = 2.4,
///                            .wire_diameter = 0.076, .mass_per_length = 25.0, .stored = 1400.0,
///                            .inertia = 4e4, .torque_haul = 2e6, .torque_pay = 2e6,
///                            .brake_static = 4e6, .mode = hawser::WinchMode::brake});
/// world.set_system_signal("winch.mode", 1.0);      // constant tension from now on
/// world.set_system_signal("winch.tension", 4e5);   // [N]
/// ```
/// *Nodes.* The element at the drum grows and shrinks. Where the wire's elements have a mass
/// (WireDef::consistent_mass) the winch puts a node on it when it has half more than `element`, and
/// takes the nearest node away when a quarter is left, so that what runs out has mass, contacts and
/// shape. What lies between the fairlead and the first node loads both with half of its weight,
/// mass and drag: `pull` is the tension at the fairlead, and does not jump where a node comes.
///
/// A winch is a System (system.h). Its drum is a scalar body with the coordinate θ [rad], which
/// grows where wire is paid out; the wire's end becomes an element of rest length
/// l = length + r (θ − drum_zero), r the radius of the layer that the wire comes from. Forces on
/// the drum are torques, so that the pull of motor and brake falls as layers are wound on.
///
/// *Chain* runs over a gypsy (GypsyDef), a wheel whose pockets hold its links, into a locker. Its
/// radius stays. What is on the wheel is a scalar body of its own, "name/chain", on which the
/// wire's end lies; a scalar_clutch, "name/grip", holds it to the wheel up to a load, above which
/// it jumps by whole pockets; the friction "name/bitter_end" is its end in the locker.
///
/// Signals, as "name.signal". Inputs: `mode` (WinchMode as a number), `speed` [m/s], `tension` [N],
/// `brake` 0 to 1, `clutch` 0 or 1. Outputs: `layer`, `wraps`, `wire_left` [m], `radius` [m],
/// `across` [m], `at_drum` [m] (wire of the element at the drum), `pull` [N], `pull_limit` [N],
/// `inertia` [kg m²], `slip` [m], `heat` [J], `state` (WinchState as a number); of a gypsy also
/// `jumps`, `jumped` [m], `grip` and `tail` [N].

#include <hawser/id.h>
#include <hawser/interactions.h>

#include <cstdint>
#include <span>
#include <string>

namespace hawser {

class World;

/// What a winch is told to do.
enum class WinchMode : std::uint8_t {
    speed,    ///< The motor turns the drum so that wire runs out at `speed`; below 0: in.
    tension,  ///< The motor pulls with the torque `tension` × radius, whatever moves.
    render,   ///< It stands between tension − deadband and tension + deadband, gives way above and
              ///< takes in below.
    brake,    ///< The band brake holds, by the share `brake` of its torque; the motor is off.
    free,     ///< Neither motor nor brake act.
    release,  ///< Emergency: after `release_delay` nothing holds but `release_load`.
};

/// Words of the modes, in the order of WinchMode, as scene files and reports have them: "speed",
/// "tension", "render", "brake", "free", "release".
[[nodiscard]] std::span<const char* const> winch_modes() noexcept;

/// What a winch does.
enum class WinchState : std::uint8_t {
    standing,    ///< The drum stands.
    paying,      ///< Wire runs out …
    hauling,     ///< … or in.
    slipping,    ///< The brake slips.
    waiting,     ///< An emergency release is on its way.
    released,    ///< It has taken effect.
    last_wraps,  ///< The motor does not pay out more: dead wraps are left.
    full,        ///< The motor does not haul more: the drum is full, or the wire's end hauled in,
                 ///< which jams at the fairlead whatever the mode.
    empty,       ///< No wire is on the drum; the fastening holds the end.
    parted,      ///< The wire has parted from it.
    jumping,     ///< Its chain is between two pockets of the gypsy.
};

/// A chain wheel, and what lies behind it. Five pockets and links of 4 d are usual; see
/// chain_properties() for chains.
struct GypsyDef {
    int pockets = 0;          ///< Each holds a link that lies flat; 0: it is a drum, no gypsy.
    double pitch = kDefault;  ///< Of a link [m], two of which a pocket takes; 4 diameters.
    double jump_load = 1e30;  ///< Above this difference of tensions outboard and inboard it jumps.
    /// Force with which links that jump rub on the wheel; half of jump_load.
    double jump_friction = kDefault;
    double locker_fall = 0.0;         ///< Chain that hangs from the wheel into the locker [m].
    double locker = 1e30;             ///< The motor hauls no more than this into it [m].
    double wrap = 3.141592653589793;  ///< Angle of the wheel that chain lies on [rad].
};

/// A winch at an end of a wire. A definition: World::add copies it whole. Lengths in m, forces in N
/// on the wire, torques in N m on the drum.
struct WinchDef {
    std::string name{};  ///< Unique among systems. Parts: name/drum, name/motor, name/friction.
    WireId wire{};       ///< Whose end lies on the drum. Required.
    int end = 0;         ///< Which: 0 the first, 1 the last.
    /// A scalar body of the mass `inertia` on which this end lies already (WinchStretch); invalid:
    /// one is made, and the end's element with it (World::wind_up).
    BodyId drum{};

    /// A wheel for chain instead of a drum: core_radius, width, flange_radius and layer_pitch are
    /// left out, `stored` is the chain in the locker, `dead_wraps` turns of the wheel that are left
    /// of it, `weak_link` the load of its end there, the bitter end.
    GypsyDef gypsy{};
    /// The scalar body of the chain on the gypsy where `drum` is given: that on which the end lies
    /// already, of the mass gypsy_chain_inertia().
    BodyId chain{};

    double core_radius = 0.0;         ///< Of the bare drum. Required.
    double width = 0.0;               ///< Between the flanges. Required.
    double flange_radius = kDefault;  ///< Wire does not stand above it; as far as `stored` needs.
    double wire_diameter = 0.0;       ///< Of chain the bar's. Required.
    double layer_pitch = kDefault;    ///< Of one layer above the last; the wire's diameter.
    double mass_per_length = 0.0;     ///< Of the wire [kg/m]: what lies on the drum turns with it.
    double element = kDefault;        ///< Length of what it pays out [m]; that of the element at
                                      ///< the drum now; 0: the winch makes no nodes.
    double stored = 0.0;              ///< On the drum at the start. Required.
    double inertia = 0.0;        ///< Of the bare drum and what turns with it [kg m²]. Required.
    double motor_inertia = 0.0;  ///< Of motor and gear, at the drum [kg m²]: by the clutch.

    double torque_haul = 1e30;  ///< Of the motor.
    double torque_pay = 1e30;   ///< Of the motor, the other way.
    double power = 1e30;        ///< Of the motor [W].
    double max_speed = 2.0;     ///< Of the wire where mode tension or render takes it in [m/s].
    double speed = 0.0;         ///< Wanted in mode speed [m/s].
    double tension = 0.0;       ///< Wanted in mode tension and render.
    double deadband = 0.0;      ///< Of mode render, to each side.

    double brake_static = 0.0;        ///< Torque at which the band begins to slip as wire runs out.
    double brake_dynamic = kDefault;  ///< And with which it slips; brake_static.
    double band_friction = 0.0;       ///< μ of the band …
    double band_angle = 0.0;          ///< … and the angle it covers [rad]: it holds e^(−μ angle) of
                                      ///< that as wire runs in.
    double release_delay = 0.0;       ///< Of an emergency release [s].
    double release_load = 0.0;        ///< Tension that is left after it.

    double dead_wraps = 5.0;     ///< The motor pays out no further.
    double wrap_friction = 0.1;  ///< μ of wire on the drum, which relieves its fastening.
    double weak_link = 0.0;      ///< Load of the fastening; 0: it lets go when the drum is empty.
    WinchMode mode = WinchMode::brake;
};

/// What a winch is made of.
struct WinchIds {
    BodyId drum{};
    InteractionId line{};  ///< The element that the drum pays out.
    InteractionId motor{}, brake{};
    BodyId chain{};  ///< Of a gypsy: what the element hangs on, as it does on a drum.
    InteractionId grip{}, bitter_end{};
};

/// r of a gypsy, at which one turn pays out two pitches a pocket: pockets × pitch/π [m].
[[nodiscard]] double gypsy_radius(const WinchDef& def) noexcept;
/// Of the chain that moves with the wheel, on it and in its fall, about its axis [kg m²].
[[nodiscard]] double gypsy_chain_inertia(const WinchDef& def) noexcept;

/// Chain of a bar diameter d by what class societies and Orcina list.
struct ChainProperties {
    double mass_per_length;  ///< In air [kg/m].
    double EA;               ///< [N].
    double link;             ///< Pitch of a link, 4 d [m].
};
/// Studless: 19.9e3 d² kg/m, 0.854e11 d² N; with studs 21.9e3 d² kg/m, 1.01e11 d² N (Orcina,
/// OrcaFlex documentation, "Chain: mechanical properties"). @param diameter  Of the bar [m].
[[nodiscard]] ChainProperties chain_properties(double diameter, bool studs) noexcept;

/// What World::add() of it calls. @throws DefError on what is missing or out of range, a name that
/// is taken, a wire's end that lies on a drum already, elements to be paid out where the wire has
/// none of a mass, a drum that holds less than `stored`, or
/// whose radius is below 2.5 wire diameters, a gypsy of less than 3 pockets or beside a drum's
/// dimensions.
WinchIds define(World& world, const WinchDef& def);

}  // namespace hawser
