// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file vessel.h
/// Vessels under way. A vessel is a system that applies hull forces (vessel_hull.h) and the forces
/// of propulsors and rudders (vessel_propulsion.h) to a rigid body.
///
/// ```cpp
/// hawser::PublishedShip ship = hawser::kvlcc2(hawser::KvlccScale::full);   // vessel_ships.h
/// ship.vessel.body = world.add_body(ship.body);
/// world.add(ship.vessel);
/// world.set_system_signal("kvlcc2.rudder", 0.61);    // 35 degrees to starboard
/// ```
/// Equations of motion in the marine frame (vessel_hull.h) at the origin O of the vessel (T. I.
/// Fossen, *Handbook of Marine Craft Hydrodynamics and Motion Control*, 2021). ν_r is the velocity
/// relative to the current:
/// ```
///     M_RB ν̇ + C_RB(ν) ν + A ν̇_r + C_A(ν_r) ν_r + D ν_r + G η = τ(ν_r, δ, n, …)
/// ```
/// The step itself has the mass and Coriolis forces M_RB and C_RB of the body. The vessel adds the
/// other terms as loads (Loads): A as mass, G as stiffness, −∂τ/∂ν of each axis as damping, so that
/// the step treats them implicitly. Forces are computed at velocities extrapolated to the start of
/// the step, v + ½(v − v_last): second order in the step. If A is not symmetric, the mass M of body
/// and water acts by its symmetric part M_s, and τ is multiplied by M_s M⁻¹.
///
/// Current and wind come from the world's sea, at half the draught and at the height of WindLoad.
/// Without a sea both are 0.
///
/// Signals have names of the form "vessel.signal". Inputs:
/// - of a vessel whose coefficient set has them: `rudder` [rad], positive turns to starboard, and
///   `rps` [1/s];
/// - of a propulsor: NAME, order from −1 to 1; NAME_pitch, pitch order from −1 to 1; NAME_angle,
/// ordered
///   angle from ahead, positive clockwise from above [rad];
/// - of a rudder: NAME, ordered angle [rad];
/// - failures: NAME_failed of propulsors and rudders (vessel_propulsion.h), and those of the power
/// bus
///   (vessel_power.h).
///
/// Outputs:
/// - `speed` through the water, `ground_speed` [m/s]; `drift` β [rad]; `turn_rate` r [rad/s];
/// - `rudder_angle` [rad], `shaft_rps` [1/s] of a coefficient set;
/// - `surge_force`, `sway_force` [N], `yaw_moment` [N m];
/// - of propulsors: NAME_thrust, NAME_rps, NAME_power, NAME_turned, NAME_set, NAME_loss;
/// - of rudders: NAME_at.
///
/// Limits: forces of calm water and mean wind only; a hull in the sea (sea.h) adds wave forces.
/// Coefficients are valid for one loading and depth of water.

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

/// Treatment of the Coriolis and centripetal forces of the added mass.
enum class AddedCoriolis : std::uint8_t {
    none,     ///< No force: the polynomials contain it, or it is neglected.
    planar,   ///< X = A_22 v r, Y = −A_11 u r; the Munk moment is in the polynomials (MMG).
    full,     ///< Kirchhoff's equations, with the Munk moment.
    at_rest,  ///< C_A of the velocities over ground, as in MSS' osv.m; only for comparison.
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

/// Definition of a vessel. World::add() copies it.
struct VesselDef {
    std::string name = "vessel";           ///< Unique name among systems.
    BodyId body{};                         ///< Rigid body of the vessel. Required.
    Vec3 origin{0.0, 0.0, 0.0};            ///< O from the centre of mass, in the body's frame [m].
    double draught = 0.0;                  ///< Draught [m]; the current is that at half of it.
    double density = 1025.0;               ///< Density of the water if the world has no sea
                                           ///< [kg/m³].
    Matrix6 added_mass = Matrix6::Zero();  ///< A at O, marine frame [kg, kg m, kg m²].
    AddedCoriolis coriolis = AddedCoriolis::full;  ///< Coriolis forces of the added mass.
    Matrix6 damping = Matrix6::Zero();             ///< D at O, marine frame [N s/m, N s, N m s].
    /// G at O, marine frame [N/m, N, N m]: heave from z = 0 or the sea's still water, roll and
    /// pitch. Symmetric and positive semi-definite. Rows and columns of x, y, yaw are 0.
    Matrix6 restoring = Matrix6::Zero();
    HullResistance resistance{};             ///< Resistance ahead and astern.
    CrossFlow cross_flow{};                  ///< Cross-flow drag.
    CurrentLoad current{};                   ///< Current coefficients, instead of both above.
    HullPolynomial polynomial{};             ///< Polynomials of a coefficient set.
    MmgStern mmg{};                          ///< Propeller and rudder of the MMG method.
    SonNomotoStern son_nomoto{};             ///< Propeller and rudder of Son and Nomoto.
    SteeringDef steering{};                  ///< Steering gear and shaft of a coefficient set.
    WindLoad wind{};                         ///< Wind loads.
    std::vector<PropulsorDef> propulsors{};  ///< Propulsors.
    std::vector<RudderDef> rudders{};        ///< Rudders in the slipstream of propulsors.
    PowerDef power{};                        ///< Power bus.
    /// True: a thruster loses thrust in the race of another one. Requires diameters.
    bool thruster_losses = false;
    VesselControl control{};  ///< Joystick, autopilot and dynamic positioning.
    std::optional<DpShip>
        dp_capability{};  ///< Data for dp_capability(), without effect on the motion.
};

/// Check the non-dimensional values of a vessel against the range of published ships. Values
/// outside it indicate coefficients of another scale or unit, or a weight that has no support or
/// two.
/// @return a sentence for each value outside the range.
[[nodiscard]] std::vector<std::string> unusual_values(const World& world, const VesselDef& def);

/// Add the system of a vessel; World::add() calls it.
/// @return the system, owned by the world.
/// @throws DefError "vessel NAME: field: reason".
System* define(World& world, const VesselDef& def);

/// Return the definitions of the vessels of a world, in the order in which they act.
[[nodiscard]] std::vector<const VesselDef*> vessels_of(const World& world);
/// Return the definition of the vessel of a body; null: none.
[[nodiscard]] const VesselDef* find_vessel(const World& world, BodyId body) noexcept;

}  // namespace hawser
