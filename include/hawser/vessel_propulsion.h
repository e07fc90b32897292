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
/// Cycloidal propellers (ideal) push in any direction. Their vector (s cos α, s sin α) follows
/// that of the orders at 2/`ramp`, without a turn: `ramp` is the time from full ahead to full
/// astern.
///
/// Losses multiply thrust and torque of a propulsor at the begin of each step:
/// - Ventilation (`ventilates`; K. J. Minsaas et al. 1987): β = 1 − 0.675 (1 − 0.769 h/R)^1.258 for
///   −0.48 ≤ h/R ≤ 1.3, 0 above the water, 1 below. h is the depth of the hub below the water,
///   waves included, R the radius. Torque falls with β^0.85.
/// - Race of another thruster j (VesselDef::thruster_losses; J. Dang and H. Laheij 2004):
///   t = 1 − 0.75^((x/D_j)^(2/3)), t_φ = t + (1 − t) φ³/(130/t³ + φ³) at x behind it and φ [deg]
///   from its axis. The loss 1 − t_φ is multiplied by √(|T_j|/T_j,most). Thrust alone.
/// - Hull (`hull_loss` k): the race of an azimuth that runs inboard under the hull clings to it.
///   Factor 1 − k max(0, cos ψ), ψ from the race to the centreline. Thrust alone.
///
/// Failures come by the input NAME_failed, with the event `failure`:
/// - 1: A propulsor stops, without torque. A rudder keeps its angle.
/// - 2: A propulsor keeps its order, angle and pitch. A rudder goes hard to starboard.
/// - 3: A propulsor goes full ahead and keeps its angle. A rudder goes hard to port.
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

enum class PropulsorKind : std::uint8_t { shaft, azimuth, tunnel, cycloidal };

/// Return thrust over that of a deeply immersed propeller [1].
/// @param ratio  Depth of the hub below the water over the radius.
[[nodiscard]] double ventilated_thrust(double ratio) noexcept;
/// Return thrust in the race of another thruster over that without it, both at equal load [1].
/// @param distance  Distance behind it, over its diameter, ≥ 0. @param angle  Angle from the axis
/// of the race [rad].
[[nodiscard]] double race_thrust(double distance, double angle) noexcept;

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
    // Losses.
    double diameter = 0.0;    ///< Ideal propulsor with losses: of its race [m].
    bool ventilates = false;  ///< Loses thrust near the surface; needs a diameter.
    double hull_loss = 0.0;   ///< k of an azimuth, 0.03 for Coanda's effect [1].
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
