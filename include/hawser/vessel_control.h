// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file vessel_control.h
/// Control of a vessel: joystick, autopilot and dynamic positioning (VesselDef::control).
///
/// ```cpp
/// vessel.control.active = true;
/// vessel.control.failures = {{"port", {"port"}}, {"starboard", {"starboard"}}};
/// world.add(vessel);
/// world.set_system_signal("osv.mode", 3);              // auto position
/// world.set_system_signal("osv.x_order", 120.0);       // of O, in the world [m]
/// ```
/// Each step executes, in this order: observer, mode, feed-forward, allocation, consequence
/// analysis. All axes are surge, sway and yaw; τ is the demanded force of the ship [N, N, N m].
///
/// *Observer* (T. I. Fossen and J. P. Strand, "Passive nonlinear observer design for ships using
/// Lyapunov methods", 1999). It estimates position and heading η, velocities ν, a slowly varying
/// force b and a wave motion ξ of each axis:
/// ```
///     ξ̇ = A_w ξ + K_1 ỹ           η̂̇ = R ν̂ + K_2 ỹ         ḃ = K_3 Rᵀ ỹ
///     M ν̂̇ = −D ν̂ + b + τ + K_4 Rᵀ ỹ                        ỹ = η − η̂ − ξ
/// ```
/// Control uses η̂ and ν̂, which do not contain the motion in waves of about `wave_period`.
///
/// *Position control* uses the error e = η̂ − η_d in the axes of the ship. The target η_d is the
/// ordered position behind a filter of the time constant `filter`:
/// ```
///     τ = −K_p Rᵀe − K_d ν̂ − K_i Rᵀ∫e dt − τ_wind − τ_lines
///     K_p = M ω²    K_d = 2 M ζ ω    K_i = `integral` ω K_p
/// ```
/// The integral of an axis stops while the thrust of the axis falls short of τ and the error would
/// raise it (anti-windup).
///
/// *Allocation* distributes τ to the propulsors by a quadratic program (src/vessel/allocation.h).
/// It minimises the sum of squares of thrust over capacity, with limits of thrust, rates and
/// angles, and forbidden zones of azimuths. Azimuths turn towards the result at their rates.
/// Meanwhile the other thrusts compensate for the azimuths that still turn.
///
/// A failed propulsor gets no order; its present thrust counts as a load. On a power bus the
/// capacity of a propulsor follows from the power that the bus can supply; without power it gets no
/// order.
///
/// Consequence analysis repeats the allocation without the propulsors that have failed, and
/// without those of one further failure. Each step analyses one failure. The result is the largest
/// missing force over τ.
///
/// Values of the input `mode`:
/// - 0, off: the inputs of propulsors and rudders are their orders;
/// - 1, joystick: τ is joystick_x, joystick_y, joystick_n times the largest force of each axis;
/// - 2, auto heading: controls heading_order by yaw moment or rudder, and the speed by speed_order,
/// or
///   by joystick_x and joystick_y;
/// - 3, auto position: controls x_order, y_order, heading_order;
/// - 4, follow: keeps the distance to `target` that exists at the start of the mode, and
/// heading_order.
///
/// The inputs `x_order` and `y_order` are the ordered position of O in the world [m],
/// `heading_order` is clockwise from the world's x axis seen from above [rad]. A change to mode 2,
/// 3 or 4 sets them to the present position and heading, unless they are set in the same step.
///
/// Outputs:
/// - `offset_x` ahead, `offset_y` to starboard [m], `offset_heading` [rad]: deviation of the
/// estimated
///   motion without waves from the order (footprint);
/// - `mode_now`: mode in effect; `heading`: heading [rad];
/// - `demand_x`, `demand_y` [N], `demand_n` [N m]: τ; `allocated_x`, `_y`, `_n`: force of the
/// propulsors
///   by the allocation;
/// - `consequence`: result of the consequence analysis [1]; `consequence_failure`: index of the
/// worst
///   failure, −1: none.
///
/// Events of the body, once when they begin: `mode_refused` (value: the mode), `position_lost`
/// (value: distance [m]) and `failure_critical` (value: missing over demanded force [1]).
///
/// Limits: three axes. The measurements of the observer have no noise. Wind and line tensions are
/// known exactly, filtered by `wind_filter`. The allocation does not consider losses by waves,
/// ventilation and interaction.

#include <hawser/id.h>
#include <hawser/math.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hawser {

/// Control mode: values of the input `mode` (top of this file).
enum class ControlMode : std::uint8_t { off, joystick, heading, position, follow };
inline constexpr int kControlModes = 5;
/// Return the name of a mode, as in its enumerator.
[[nodiscard]] const char* to_string(ControlMode mode) noexcept;

/// Forbidden thrust directions of an azimuth thruster.
struct ControlZone {
    std::string propulsor{};      ///< Name of the propulsor.
    double from = 0.0, to = 0.0;  ///< Limits of the directions, clockwise from ahead [rad].
};

/// Single failure.
struct ControlFailure {
    std::string name{};                     ///< Name.
    std::vector<std::string> propulsors{};  ///< Names of the propulsors that it stops.
};

/// Definition of the control of a vessel, VesselDef::control.
struct VesselControl {
    bool active = false;                  ///< True: the vessel has this control with its signals.
    ControlMode mode = ControlMode::off;  ///< Mode at the start.
    Vec3 bandwidth{0.1, 0.1, 0.1};        ///< Bandwidths ω of surge, sway, yaw [rad/s].
    double damping = 1.0;                 ///< Damping ratio ζ [1].
    double integral = 0.1;                ///< Integral gain K_i over ω K_p [1].
    double filter = 30.0;                 ///< Time constant of the filter of orders [s].
    bool observer = true;                 ///< False: control by the measured motion.
    double wave_period = 8.0;             ///< Period of the waves that the observer removes [s].
    bool wind = true;                     ///< True: feed-forward of the wind load.
    double wind_filter = 5.0;  ///< Time constant of the feed-forward of wind and lines [s].
    std::vector<InteractionId> lines{};  ///< Lines at the body whose tension is fed forward.
    BodyId target{};                     ///< Body to which the mode `follow` keeps the distance.
    bool direct = false;          ///< True: τ acts on the body without propulsors, for comparisons.
    double position_alarm = 5.0;  ///< Offset at which position_lost is sent [m].
    double heading_alarm =
        0.17453292519943;              ///< Heading offset at which position_lost is sent [rad].
    double consequence_alarm = 0.02;   ///< Missing over demanded force at which
                                       ///< failure_critical is sent [1].
    double azimuth_cost = 1.0;         ///< Cost of the thrust of azimuths over that of others
                                       ///< in the allocation [1].
    std::vector<ControlZone> zones{};  ///< Forbidden directions.
    std::vector<ControlFailure> failures{};  ///< Failures of the analysis; empty: each propulsor
                                             ///< alone.
};

}  // namespace hawser
