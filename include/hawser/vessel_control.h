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
/// Each step runs, in this order: observer, mode, feed-forward, allocation, consequence analysis.
///
/// Observer (T. I. Fossen and J. P. Strand, "Passive nonlinear observer design for ships using
/// Lyapunov methods", 1999). Position and heading η, velocities ν, slowly varying force b and a
/// wave motion ξ of each axis:
/// ```
///     ξ̇ = A_w ξ + K_1 ỹ           η̂̇ = R ν̂ + K_2 ỹ         ḃ = K_3 Rᵀ ỹ
///     M ν̂̇ = −D ν̂ + b + τ + K_4 Rᵀ ỹ                        ỹ = η − η̂ − ξ
/// ```
/// Control uses η̂ and ν̂, from which waves about `wave_period` are removed.
///
/// DP in the axes of the ship, with e = η̂ − η_d and the order η_d through a filter of time
/// constant `filter`:
/// ```
///     τ = −K_p Rᵀe − K_d ν̂ − K_i Rᵀ∫e dt − τ_wind − τ_lines
///     K_p = M ω²    K_d = 2 M ζ ω    K_i = `integral` ω K_p
/// ```
/// The integral of an axis stops while the thrust of the axis falls short of τ and the error would
/// raise it (anti-windup).
///
/// Allocation is a quadratic program (src/vessel/allocation.h). It minimises the sum of squares of
/// thrust over capacity, with limits of thrust, rates and angles, and forbidden zones of azimuths.
/// Azimuths turn towards the result at their rates. Thrusts make up for those that still turn.
///
/// A propulsor that failed gets no order; its present thrust counts as a load. On a power bus the
/// capacity of a propulsor is that of the power which the bus can give it; without power it gets no
/// order.
///
/// Consequence analysis allocates τ without the thrusters that failed and without those of one
/// failure more, one failure a step. The output is the largest shortfall over τ.
///
/// Values of the input `mode`:
/// - 0, off: orders of propulsors and rudders are the inputs.
/// - 1, joystick: joystick_x, _y, _n times the largest force of each axis.
/// - 2, auto heading: yaw moment or rudder; speed_order, or joystick_x and _y.
/// - 3, auto position: x_order, y_order, heading_order.
/// - 4, follow: keeps the distance to `target` at the start of the mode; heading_order.
///
/// Input orders `x_order`, `y_order` are those of O in the world [m], `heading_order` is clockwise
/// from the world's x axis seen from above [rad]. A change to mode 2, 3 or 4 sets the orders to the
/// present position and heading, unless they are set in the same step.
///
/// Outputs of the low-frequency motion from its order (footprint): `offset_x` ahead, `offset_y` to
/// starboard [m], `offset_heading` [rad]. Others: `mode_now`; `heading` [rad]; `demand_x`,
/// `demand_y` [N], `demand_n` [N m] and `allocated_x`, `_y`, `_n`; `consequence` [1],
/// `consequence_failure` (index, −1: none).
///
/// Events of the body: `mode_refused` (value: the mode), `position_lost` (value: distance [m]) and
/// `failure_critical` (value: shortfall [1]), each once when it begins.
///
/// Limits: three axes (surge, sway, yaw). The observer measures without noise. Wind and line
/// tensions are known exactly, filtered by `wind_filter`. Losses by waves, ventilation and
/// interaction are not known to the allocation.

#include <hawser/id.h>
#include <hawser/math.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hawser {

enum class ControlMode : std::uint8_t { off, joystick, heading, position, follow };
inline constexpr int kControlModes = 5;
/// Return the name: "off", "joystick", "heading", "position", "follow".
[[nodiscard]] const char* to_string(ControlMode mode) noexcept;

/// Forbidden thrust directions of an azimuth, clockwise from ahead, from `from` to `to` [rad].
struct ControlZone {
    std::string propulsor{};
    double from = 0.0, to = 0.0;
};

/// Propulsors that one failure stops.
struct ControlFailure {
    std::string name{};
    std::vector<std::string> propulsors{};
};

struct VesselControl {
    bool active = false;                      ///< True: the vessel has these signals.
    ControlMode mode = ControlMode::off;      ///< At the start.
    Vec3 bandwidth{0.1, 0.1, 0.1};            ///< ω of surge, sway, yaw [rad/s].
    double damping = 1.0;                     ///< ζ.
    double integral = 0.1;                    ///< K_i over ω K_p.
    double filter = 30.0;                     ///< Time constant of orders [s].
    bool observer = true;                     ///< False: control by the measured motion.
    double wave_period = 8.0;                 ///< Period of the waves that are filtered out [s].
    bool wind = true;                         ///< Wind feed-forward.
    double wind_filter = 5.0;                 ///< Time constant of feed-forward [s].
    std::vector<InteractionId> lines{};       ///< Tension feed-forward of lines at the body.
    BodyId target{};                          ///< Body that the mode follow keeps to.
    bool direct = false;                      ///< τ acts without propulsors, for comparisons.
    double position_alarm = 5.0;              ///< Offset of the event position_lost [m].
    double heading_alarm = 0.17453292519943;  ///< The same of the heading [rad].
    double consequence_alarm = 0.02;          ///< Shortfall of the event failure_critical [1].
    double azimuth_cost = 1.0;                ///< Cost of thrust of azimuths over other ones.
    std::vector<ControlZone> zones{};
    std::vector<ControlFailure> failures{};  ///< Empty: each propulsor alone.
};

}  // namespace hawser
