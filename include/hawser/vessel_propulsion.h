// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file vessel_propulsion.h
/// Propulsors and rudders of a vessel (vessel.h).
///
/// A propulsor is a shaft propeller, an azimuth thruster, a tunnel thruster or a cycloidal
/// propeller. It is ideal, or a propeller from a series.
///
/// *Ideal propulsor.* It has no diameter. Its thrust is T = T_most s |s| with s = n/n_most; astern
/// it is multiplied by `astern`. The revolutions follow the order of s at the rate 1/`ramp`.
///
/// *Propeller.* It has a diameter. Thrust and torque are those of open water at V_a = (1 − w) u_a,
/// in all four quadrants (propeller_force()). Here u_a is the velocity of the water along its axis.
/// The thrust on the ship is (1 − t) T ahead and T astern. Equation of motion of the shaft:
/// ```
///     2π I ṅ = Q_m − Q        Q_m = Q + 2π I (n_order − n)/τ
///     |Q_m| ≤ Q_most          |2π n Q_m| ≤ P_most
/// ```
/// When a limit of torque or power is reached, the body sends the event `saturation` with the power
/// [W].
///
/// *Thrusters.* Azimuth thrusters turn to the ordered angle at a constant rate, in the shorter
/// direction. Tunnel thrusters push to starboard (order > 0) or to port (order < 0). Their thrust
/// decreases linearly with the speed of the ship.
///
/// *Cycloidal propellers.* They are ideal and push in any direction. The vector (s cos α, s sin α)
/// follows its ordered value in a straight line at 2/`ramp`: `ramp` is the time from full ahead to
/// full astern.
///
/// *Losses.* Each loss is a factor of thrust, or of thrust and torque, from the state at the start
/// of the step:
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
/// *Failures.* Values of the input NAME_failed; the event `failure` reports the start of each:
/// - 1: the propulsor stops without torque; a rudder keeps its angle.
/// - 2: the propulsor keeps its order, angle and pitch; a rudder turns hard to starboard.
/// - 3: the propulsor runs full ahead and keeps its angle; a rudder turns hard to port.
///
/// *Rudder.* In the slipstream of a propulsor (momentum theory, as in the MMG method):
/// ```
///     V² = η (u_a + κ (√(u_a² + 8 T/(π ρ D²)) − u_a))² + (1 − η) u_a²
///     F_N = ½ρ A (V² + v²) C_N(α)       C_N = f_α sin α to the stall angle
///     f_α = 6.13 Λ/(Λ + 2.25)           beyond: falls to 1.2 sin α within 10°
/// ```
/// Here α is the angle of attack, v the velocity of the water across the rudder, Λ the aspect ratio
/// and η the fraction of the rudder in the slipstream. In reversed flow the force is half of that
/// at π − α.

#include <hawser/math.h>
#include <hawser/vessel_propeller.h>

#include <cstdint>
#include <string>

namespace hawser {

/// Kind of a propulsor.
enum class PropulsorKind : std::uint8_t { shaft, azimuth, tunnel, cycloidal };

/// Return the factor β of thrust by ventilation [1].
/// @param ratio  Depth of the hub below the water surface over the radius, h/R [1].
[[nodiscard]] double ventilated_thrust(double ratio) noexcept;
/// Return the factor t_φ of thrust in the race of another thruster of equal load [1].
/// @param distance  Distance behind the other thruster over its diameter, x/D ≥ 0 [1].
/// @param angle  Angle φ from the axis of the race [rad].
[[nodiscard]] double race_thrust(double distance, double angle) noexcept;

/// Definition of a propulsor.
struct PropulsorDef {
    std::string name{};  ///< Unique name in the vessel, and prefix of its signals. Required.
    PropulsorKind kind = PropulsorKind::shaft;  ///< Kind of the propulsor.
    Vec3 point{0.0, 0.0, 0.0};  ///< Position from the centre of mass, in the body's frame [m].
    // Ideal propulsor.
    double thrust = 0.0;  ///< Thrust at full order [N]. Required without a propeller.
    double astern = 1.0;  ///< Thrust astern over thrust ahead [1].
    double ramp = 0.0;    ///< Time from order 0 to order 1 [s]; 0: immediate.
    // Propeller.
    PropellerDef propeller{};  ///< Geometry. Diameter > 0: a propeller; 0: an ideal propulsor.
    double most_rps = 0.0;     ///< Revolutions n at full order [1/s]. Required with a propeller.
    double wake = 0.0;         ///< Wake fraction w [1].
    double thrust_deduction = 0.0;  ///< Thrust deduction t [1].
    double shaft_inertia = 0.0;     ///< Inertia I of shaft, gear and entrained water [kg m²]; 0: n
                                    ///< follows the order by `ramp`.
    double response = 1.0;          ///< Time constant τ of the shaft control [s].
    double most_torque = 0.0;       ///< Largest torque Q_most [N m]; 0: no limit.
    double most_power = 0.0;        ///< Largest power P_most [W]; 0: no limit.
    bool controllable = false;      ///< True: the input NAME_pitch sets the pitch.
    double pitch_time = 10.0;       ///< Time from full pitch to zero [s].
    // Azimuth.
    double turn_rate = 0.2;   ///< Rate of the angle [rad/s].
    double most_angle = 0.0;  ///< Largest angle from ahead, to both sides [rad]; 0: turns freely.
    // Tunnel.
    double lost_at = 0.0;  ///< Speed through the water without thrust [m/s]; 0: no loss.
    // Losses.
    /// Diameter of an ideal propulsor with losses [m]; a propeller has its own.
    double diameter = 0.0;
    bool ventilates = false;  ///< True: loses thrust by ventilation; requires a diameter.
    double hull_loss = 0.0;   ///< Factor k of the loss of an azimuth at the hull [1]; 0.03 for the
                              ///< Coanda effect.
};

/// Definition of a rudder.
struct RudderDef {
    std::string name = "rudder";  ///< Unique name in the vessel, and prefix of its signals.
    Vec3 point{0.0, 0.0, 0.0};    ///< Position from the centre of mass, in the body's frame
                                  ///< [m].
    double area = 0.0;            ///< Area A [m²]. Required.
    double aspect = 1.5;          ///< Aspect ratio Λ [1].
    std::string behind{};         ///< Name of the propulsor in whose slipstream it is; "": none.
    double covered = 1.0;         ///< Fraction η of its height in the slipstream [1].
    double slipstream = 0.5;      ///< Factor κ of the slipstream [1].
    double wake = 0.0;            ///< Wake fraction w at the rudder [1].
    double hull_increase = 0.0;   ///< Side force on the hull over that of the rudder, a_H [1].
    double stall = 0.6108652381980153;       ///< Stall angle [rad]; 35°.
    double most_angle = 0.6108652381980153;  ///< Largest rudder angle [rad]; 35°.
    double rate = 0.0404916386;  ///< Rate of the rudder [rad/s]; 2.32°/s: 65° in 28 s (SOLAS
                                 ///< II-1/29).
};

/// Compute the normal force coefficient C_N of a rudder [1].
/// @param attack  Angle of attack α, any value [rad].
[[nodiscard]] double rudder_normal(const RudderDef& rudder, double attack) noexcept;

}  // namespace hawser
