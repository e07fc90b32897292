// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file vessel.h
/// Vessels under way. Hull forces (vessel_hull.h), propulsors and rudders (vessel_propulsion.h)
/// of one rigid body, as a system.
///
/// ```cpp
/// hawser::PublishedShip ship = hawser::kvlcc2(hawser::KvlccScale::full);   // vessel_ships.h
/// ship.vessel.body = world.add_body(ship.body);
/// world.add(ship.vessel);
/// world.set_system_signal("kvlcc2.rudder", 0.61);    // 35 degrees to starboard
/// ```
/// Equations of motion in the marine frame at O (T. I. Fossen, *Handbook of Marine Craft
/// Hydrodynamics and Motion Control*, 2021), velocities relative to the current:
/// ```
///     M_RB ν̇ + C_RB(ν) ν + A ν̇_r + C_A(ν_r) ν_r + D ν_r + G η = τ(ν_r, δ, n, …)
/// ```
/// The world has M_RB and C_RB; the vessel adds the rest as loads (Loads): A as mass, G as
/// stiffness, −∂τ/∂ν of each axis as damping, so that the step takes them implicitly. Forces are
/// computed at velocities extrapolated to the start of the step, v + ½(v − v_last): second order in
/// the step. A that is not symmetric acts as its symmetric part M_s, with τ times M_s M⁻¹.
///
/// Current and wind come from the world's sea, at half the draught and at the height of WindLoad.
/// Without a sea both are 0.
///
/// Signals have names of the form "vessel.signal". Inputs:
/// - of a vessel whose coefficient set has them: `rudder` [rad], positive turns to starboard, and
///   `rps` [1/s];
/// - of a propulsor: NAME [−1, 1], NAME_pitch [−1, 1], and NAME_angle [rad] from ahead, positive
///   clockwise from above;
/// - of a rudder: NAME [rad].
///
/// Outputs:
/// `speed` through the water [m/s], `ground_speed` [m/s], `drift` β [rad], `turn_rate` r [rad/s],
/// `rudder_angle`, `shaft_rps`, `surge_force`, `sway_force` [N], `yaw_moment` [N m]; NAME_thrust,
/// NAME_rps, NAME_power, NAME_turned, NAME_set, NAME_loss of propulsors; NAME_at of rudders.
/// Failures: inputs NAME_failed of propulsors and rudders (vessel_propulsion.h), and those of the
/// power bus (vessel_power.h).
///
/// Limits: forces of calm water and mean wind. Wave forces come from a hull in the sea (sea.h) and
/// are added. Coefficients hold for one loading and depth.

#include <hawser/dp_capability.h>
#include <hawser/id.h>
#include <hawser/math.h>
#include <hawser/vessel_control.h>
#include <hawser/vessel_hull.h>
#include <hawser/vessel_power.h>
#include <hawser/vessel_propulsion.h>
#include <hawser/water_hull.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hawser {

class World;
class System;

/// Coriolis and centripetal forces of the added mass.
enum class AddedCoriolis : std::uint8_t {
    none,     ///< In the polynomials, or left out.
    planar,   ///< X = A_22 v r, Y = −A_11 u r; the Munk moment is in the polynomials (MMG).
    full,     ///< Kirchhoff's, with the Munk moment.
    at_rest,  ///< C_A of velocities over ground, as in MSS' osv.m: for comparison alone.
};

/// Steering gear and shaft of a vessel with a coefficient set.
struct SteeringDef {
    double most_angle = 0.6108652381980153;  ///< Largest rudder angle [rad]; 35°.
    double rate = 0.0404916386;              ///< Rate of the rudder [rad/s].
    double lag = 0.0;                        ///< Time constant of the rudder [s].
    double rps = 0.0;                        ///< Revolutions at the start [1/s].
    double most_rps = 0.0;                   ///< Largest revolutions [1/s]; 0: twice `rps`.
    double shaft_lag = 0.0;                  ///< Time constant of the revolutions [s].
};

/// Define a vessel. World::add() copies it.
struct VesselDef {
    std::string name = "vessel";           ///< Unique among the systems of a world.
    BodyId body{};                         ///< Body that it acts on: rigid. Required.
    Vec3 origin{0.0, 0.0, 0.0};            ///< O from the centre of mass, in the body's frame [m].
    double draught = 0.0;                  ///< Draught; the current is taken at half of it [m].
    double density = 1025.0;               ///< Density of the water if the world has no sea
                                           ///< [kg/m³].
    Matrix6 added_mass = Matrix6::Zero();  ///< A at O, marine frame [kg, kg m, kg m²].
    AddedCoriolis coriolis = AddedCoriolis::full;
    Matrix6 damping = Matrix6::Zero();  ///< D at O, marine frame.
    /// G at O, marine frame: heave from z = 0 or the sea's still water, roll and pitch. Symmetric
    /// and positive semi-definite. Rows and columns of x, y, yaw are 0.
    Matrix6 restoring = Matrix6::Zero();
    HullResistance resistance{};
    CrossFlow cross_flow{};
    CurrentLoad current{};
    HullPolynomial polynomial{};
    MmgStern mmg{};
    SonNomotoStern son_nomoto{};
    SteeringDef steering{};
    WindLoad wind{};
    std::vector<PropulsorDef> propulsors{};
    std::vector<RudderDef> rudders{};
    PowerDef power{};
    bool thruster_losses = false;  ///< Thrusters lose in the race of others; need diameters.
    VesselControl control{};
    std::optional<DpShip> dp_capability{};  ///< Data for dp_capability(); does not act.
};

/// Return a sentence for each non-dimensional value outside the range of published ships. Such
/// values come from coefficients of another scale or unit, from a weight without support, or from a
/// weight supported twice. Empty if there are none.
[[nodiscard]] std::vector<std::string> unusual_values(const World& world, const VesselDef& def);

/// Create the system of a vessel for World::add(), which owns it. @throws DefError "vessel NAME:
/// field: reason".
System* define(World& world, const VesselDef& def);

/// Return the definitions of the vessels of a world, in the order in which they act.
[[nodiscard]] std::vector<const VesselDef*> vessels_of(const World& world);
/// Find the definition of the vessel of a body. Null if it has none.
[[nodiscard]] const VesselDef* find_vessel(const World& world, BodyId body) noexcept;

}  // namespace hawser
