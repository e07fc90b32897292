// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file vessel_propulsion.h
/// Propulsors and rudders of a vessel (vessel.h).
///
/// *Ideal propulsor.* No diameter: thrust T = T_most s |s| with s = n/n_most; astern it is
/// multiplied by `astern`. The revolutions follow the order s at the rate 1/`ramp`.
///
/// *Propeller.* With a diameter: open-water thrust and torque at V_a = (1 − w) u_a, in all four
/// quadrants (propeller_force()). u_a is the velocity of the water along its axis. The thrust on
/// the ship is (1 − t) T ahead and T astern. Equation of motion of the shaft:
/// ```
///     2π I ṅ = Q_m − Q        Q_m = Q + 2π I (n_order − n)/τ,  |Q_m| ≤ Q_most,  |2π n Q_m| ≤
///     P_most
/// ```
/// A limit of torque or power sends the event `saturation` of the body, with the power [W].
///
/// *Thrusters.* Azimuth thrusters turn to the ordered angle at a fixed rate, in the shorter
/// direction. Tunnel thrusters push to starboard (order > 0) or port. Their thrust decreases
/// linearly with the speed of the ship.
///
/// *Cycloidal propellers.* They are ideal and push in any direction. The vector (s cos α, s sin α)
/// follows its ordered value in a straight line at 2/`ramp`: `ramp` is the time from full ahead to
/// full astern.
///
/// *Losses.* Factors of thrust and torque of a propulsor, at the start of each step:
/// - Ventilation (`ventilates`, K. J. Minsaas et al. 1987), with h the depth of the hub below the
///   water surface, waves included, and R the radius: β = 1 − 0.675 (1 − 0.769 h/R)^1.258 for
///   −0.48 ≤ h/R ≤ 1.3, 0 above the water, 1 below. The torque is multiplied by β^0.85.
/// - Race of another thruster j (VesselDef::thruster_losses; J. Dang and H. Laheij 2004), x behind
///   it, at φ [deg] from its axis: t = 1 − 0.75^((x/D_j)^(2/3)),
///   t_φ = t + (1 − t) φ³/(130/t³ + φ³). The loss is (1 − t_φ) √(|T_j|/T_j,most), for the thrust
///   only.
/// - Hull (`hull_loss` k): the race of an azimuth that points inboard attaches to the hull:
///   1 − k max(0, cos ψ), with ψ from the race to the centreline, for the thrust only.
///
/// *Failure.* By the input NAME_failed. 1: stopped, without torque; 2: keeps its order, angle and
/// pitch; 3: full ahead, keeping its angle. Rudders: 1: keeps its angle; 2: hard to starboard; 3:
/// hard to port. The event `failure` reports the start.
///
/// *Rudder.* In the slipstream of a propulsor (momentum theory, as in the MMG method):
/// ```
///     V² = η (u_a + κ (√(u_a² + 8 T/(π ρ D²)) − u_a))² + (1 − η) u_a²
///     F_N = ½ρ A (V² + v²) C_N(α)       C_N = f_α sin α to the stall angle
///     f_α = 6.13 Λ/(Λ + 2.25)           beyond: falls to 1.2 sin α within 10°
/// ```
/// α is the angle of attack. Reversed flow: half the force at π − α.

#include <hawser/math.h>
#include <hawser/vessel_propeller.h>

#include <cstdint>
#include <string>

namespace hawser {

enum class PropulsorKind : std::uint8_t { shaft, azimuth, tunnel, cycloidal };

/// Return the thrust over that of a deeply immersed propeller [1].
/// @param ratio  Depth of the hub below the water surface over the radius.
[[nodiscard]] double ventilated_thrust(double ratio) noexcept;
/// Return the thrust in the race of another thruster over that without it, both at equal load [1].
/// @param distance  Distance behind it over its diameter, ≥ 0. @param angle  Angle from the axis of
/// the race [rad].
[[nodiscard]] double race_thrust(double distance, double angle) noexcept;

struct PropulsorDef {
    std::string name{};  ///< Prefix of its signals; unique in the vessel. Required.
    PropulsorKind kind = PropulsorKind::shaft;
    Vec3 point{0.0, 0.0, 0.0};  ///< Position from the centre of mass, in the body's frame [m].
    // Ideal propulsor.
    double thrust = 0.0;  ///< Thrust at full order [N]. Required without a propeller.
    double astern = 1.0;  ///< Thrust astern over ahead [1].
    double ramp = 0.0;    ///< Time from order 0 to 1 [s]; 0: at once.
    // Propeller.
    PropellerDef propeller{};       ///< Geometry. Diameter > 0: a propeller; 0: an ideal propulsor.
    double most_rps = 0.0;          ///< n at full order [1/s]. Required with a propeller.
    double wake = 0.0;              ///< w [1].
    double thrust_deduction = 0.0;  ///< t [1].
    double shaft_inertia = 0.0;     ///< I with gear and entrained water [kg m²]; 0: n by `ramp`.
    double response = 1.0;          ///< τ [s].
    double most_torque = 0.0;       ///< Q_most [N m]; 0: no limit.
    double most_power = 0.0;        ///< P_most [W]; 0: no limit.
    bool controllable = false;      ///< True if the input NAME_pitch sets the pitch.
    double pitch_time = 10.0;       ///< Time from full pitch to zero [s].
    // Azimuth.
    double turn_rate = 0.2;   ///< Rate of the angle [rad/s].
    double most_angle = 0.0;  ///< Largest angle from ahead, to both sides [rad]; 0: turns freely.
    // Tunnel.
    double lost_at = 0.0;  ///< Speed through the water without thrust [m/s]; 0: no loss.
    // Losses.
    double diameter =
        0.0;  ///< Diameter of an ideal propulsor with losses [m]; propellers have their own.
    bool ventilates = false;  ///< Loses thrust near the surface; needs a diameter.
    double hull_loss = 0.0;   ///< k of an azimuth, 0.03 for Coanda's effect [1].
};

struct RudderDef {
    std::string name = "rudder";        ///< Prefix of its signals; unique in the vessel.
    Vec3 point{0.0, 0.0, 0.0};          ///< Position from the centre of mass, in the body's frame
                                        ///< [m].
    double area = 0.0;                  ///< A [m²]. Required.
    double aspect = 1.5;                ///< Λ [1].
    std::string behind{};               ///< Propulsor in whose slipstream it stands; "": none.
    double covered = 1.0;               ///< η: fraction of its height in the slipstream [1].
    double slipstream = 0.5;            ///< κ [1].
    double wake = 0.0;                  ///< w at the rudder [1].
    double hull_increase = 0.0;         ///< a_H: side force on the hull over side force of the
                                        ///< rudder.
    double stall = 0.6108652381980153;  ///< Stall angle [rad]; 35°.
    double most_angle = 0.6108652381980153;  ///< Largest angle [rad].
    double rate = 0.0404916386;              ///< [rad/s]; 2.32°/s: 65° in 28 s (SOLAS II-1/29).
};

/// Compute the normal force coefficient of a rudder at any angle of attack [rad].
[[nodiscard]] double rudder_normal(const RudderDef& rudder, double attack) noexcept;

}  // namespace hawser
