// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file vessel_propulsion.h
/// Propulsors and rudders of a vessel (vessel.h).
///
/// **Ideal propulsor** (no diameter): thrust T = T_most s |s| with s = n/n_most, astern times
/// `astern`. The revolutions follow the order s at 1/`ramp`.
///
/// **Propeller** (with a diameter): open-water thrust and torque at V_a = (1 − w) u_a, u_a the
/// velocity of the water along its axis, in all four quadrants (propeller_force()); the ship gets
/// (1 − t) T ahead, T astern. The shaft turns by
/// ```
///     2π I ṅ = Q_m − Q        Q_m = Q + 2π I (n_order − n)/τ,  |Q_m| ≤ Q_most,  |2π n Q_m| ≤
///     P_most
/// ```
/// A limit of torque or power sends the event `saturation` of the body, with the power [W].
///
/// **Azimuth** thrusters turn at a rate to the ordered angle, by the shorter way; **tunnels** push
/// to starboard (order > 0) or port and lose thrust linearly with the speed of the ship.
///
/// **Rudder** in the slipstream of a propulsor (momentum theory, as in the MMG method):
/// ```
///     V² = η (u_a + κ (√(u_a² + 8 T/(π ρ D²)) − u_a))² + (1 − η) u_a²
///     F_N = ½ρ A (V² + v²) C_N(α)       C_N = f_α sin α to the stall angle
///     f_α = 6.13 Λ/(Λ + 2.25)           beyond: falls to 1.2 sin α within 10°
/// ```
/// α the angle of attack; reversed flow has the same law at π − α, half as strong.

#include <hawser/math.h>
#include <hawser/vessel_propeller.h>

#include <cstdint>
#include <string>

namespace hawser {

enum class PropulsorKind : std::uint8_t { shaft, azimuth, tunnel };

struct PropulsorDef {
    std::string name{};  ///< Of its signals; unique in the vessel. Required.
    PropulsorKind kind = PropulsorKind::shaft;
    Vec3 point{0.0, 0.0, 0.0};  ///< From the centre of mass, in the body's frame [m].
    // Ideal.
    double thrust = 0.0;  ///< At full order [N]. Required without a propeller.
    double astern = 1.0;  ///< Thrust astern over ahead [1].
    double ramp = 0.0;    ///< From order 0 to 1 [s]; 0: at once.
    // Propeller.
    PropellerDef propeller{};       ///< Its diameter > 0: a propeller, not ideal.
    double most_rps = 0.0;          ///< n at full order [1/s]. Required with a propeller.
    double wake = 0.0;              ///< w [1].
    double thrust_deduction = 0.0;  ///< t [1].
    double shaft_inertia = 0.0;     ///< I with gear and entrained water [kg m²]; 0: n by `ramp`.
    double response = 1.0;          ///< τ [s].
    double most_torque = 0.0;       ///< Q_most [N m]; 0: no limit.
    double most_power = 0.0;        ///< P_most [W]; 0: no limit.
    bool controllable = false;      ///< Pitch by the input NAME_pitch.
    double pitch_time = 10.0;       ///< From full pitch to none [s].
    // Azimuth.
    double turn_rate = 0.2;   ///< [rad/s].
    double most_angle = 0.0;  ///< From ahead, to both sides [rad]; 0: turns freely.
    // Tunnel.
    double lost_at = 0.0;  ///< Speed through the water without thrust [m/s]; 0: no loss.
};

struct RudderDef {
    std::string name = "rudder";        ///< Of its signals; unique in the vessel.
    Vec3 point{0.0, 0.0, 0.0};          ///< From the centre of mass, in the body's frame [m].
    double area = 0.0;                  ///< A [m²]. Required.
    double aspect = 1.5;                ///< Λ [1].
    std::string behind{};               ///< Propulsor whose slipstream it stands in; "": none.
    double covered = 1.0;               ///< η, share of its height in the slipstream [1].
    double slipstream = 0.5;            ///< κ [1].
    double wake = 0.0;                  ///< w at the rudder [1].
    double hull_increase = 0.0;         ///< a_H: side force on the hull over that of the rudder.
    double stall = 0.6108652381980153;  ///< [rad]; 35°.
    double most_angle = 0.6108652381980153;  ///< [rad].
    double rate = 0.0404916386;              ///< [rad/s]; 2.32°/s: 65° in 28 s (SOLAS II-1/29).
};

/// Normal force coefficient of a rudder at an angle of attack of any size [rad].
[[nodiscard]] double rudder_normal(const RudderDef& rudder, double attack) noexcept;

}  // namespace hawser
