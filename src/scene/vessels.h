// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file vessels.h
/// The numbers of a vessel in a scene (hawser/vessel.h). One table serves the format and the
/// reader. Keys that end in _deg are in degrees here and in radians in definitions.

#include <hawser/fields.h>
#include <hawser/vessel.h>

#include "scene/description.h"

namespace hawser::scene {

inline constexpr double kMaxVesselLength = 1e4, kMaxVesselForce = 1e15, kMaxVesselNumber = 1e6;

/// Table of one part of a definition.
template <class T>
struct VesselTable;

template <>
struct VesselTable<HullResistance> {
    static constexpr FieldInfo<HullResistance> kNumbers[] = {
        {"linear", &HullResistance::linear, "N s/m", "0",
         "Linear coefficient of the resistance, -X_u at rest.", 0.0, kMaxVesselForce},
        {"quadratic", &HullResistance::quadratic, "N s^2/m^2", "0",
         "Quadratic coefficient of the resistance, -X_uu.", 0.0, kMaxVesselForce},
        {"blend", &HullResistance::blend, "m/s", "2",
         "Speed of tanh(u/blend) between both; above 0.", 0.0, 1e3}};
};

template <>
struct VesselTable<CrossFlow> {
    static constexpr FieldInfo<CrossFlow> kNumbers[] = {
        {"length", &CrossFlow::length, "m", "", "Length of the waterline.", 0.0, kMaxVesselLength},
        {"beam", &CrossFlow::beam, "m", "", "Beam.", 0.0, kMaxVesselLength},
        {"draught", &CrossFlow::draught, "m", "", "Draught.", 0.0, kMaxVesselLength},
        {"drag", &CrossFlow::drag, "1", "Hoerner's curve", "Drag coefficient of a section.", 0.0,
         10.0}};
};

template <>
struct VesselTable<HullPolynomial> {
    static constexpr FieldInfo<HullPolynomial> kNumbers[] = {
        {"length", &HullPolynomial::length, "m", "", "L of the scales.", 0.0, kMaxVesselLength},
        {"area", &HullPolynomial::area, "m^2", "0",
         "Reference area A of the scale, for example L d or L^2.", 0.0, 1e8},
        {"speed", &HullPolynomial::speed, "m/s", "0", "U0 of u' = (u - U0)/U.", 0.0, 1e3},
        {"most_turn", &HullPolynomial::most_turn, "1", "1.5",
         "r' up to which the terms hold; beyond, forces grow with r^2.", 0.1, 100.0}};
};

template <>
struct VesselTable<MmgStern> {
    static constexpr FieldInfo<MmgStern> kNumbers[] = {
        {"diameter", &MmgStern::diameter, "m", "", "Diameter of the propeller.", 0.0, 100.0},
        {"length", &MmgStern::length, "m", "", "L of x' and r'.", 0.0, kMaxVesselLength},
        {"k0", &MmgStern::k0, "1", "", "K_T at J = 0.", 0.0, 10.0},
        {"k1", &MmgStern::k1, "1", "0", "Coefficient of K_T with J.", -10.0, 10.0},
        {"k2", &MmgStern::k2, "1", "0", "K_T of J^2.", -10.0, 10.0},
        {"thrust_deduction", &MmgStern::thrust_deduction, "1", "0", "t_P.", 0.0, 0.9},
        {"wake", &MmgStern::wake, "1", "0", "w_P0.", 0.0, 0.9},
        {"wake_port", &MmgStern::wake_port, "1", "1", "C of the wake, drift angle above 0.", 0.0,
         10.0},
        {"wake_star", &MmgStern::wake_star, "1", "1", "C of the wake, drift angle below 0.", 0.0,
         10.0},
        {"propeller_x", &MmgStern::propeller_x, "1", "0", "x_P' over the length.", -1.0, 1.0},
        {"rudder_area", &MmgStern::rudder_area, "m^2", "", "A_R.", 0.0, 1e5},
        {"height_share", &MmgStern::height_share, "1", "1", "Diameter over rudder height.", 0.0,
         1.0},
        {"steering_deduction", &MmgStern::steering_deduction, "1", "0", "t_R.", -1.0, 1.0},
        {"hull_increase", &MmgStern::hull_increase, "1", "0", "a_H.", -1.0, 2.0},
        {"hull_x", &MmgStern::hull_x, "1", "0", "x_H' over the length.", -1.0, 1.0},
        {"rudder_x", &MmgStern::rudder_x, "1", "0", "x_R' over the length.", -1.0, 1.0},
        {"wake_ratio", &MmgStern::wake_ratio, "1", "1", "Epsilon.", 0.0, 10.0},
        {"slipstream", &MmgStern::slipstream, "1", "0", "Kappa.", 0.0, 2.0},
        {"lift_slope", &MmgStern::lift_slope, "1", "", "f_alpha.", 0.0, 10.0},
        {"inflow_x", &MmgStern::inflow_x, "1", "0", "l_R'.", -2.0, 2.0},
        {"straight_port", &MmgStern::straight_port, "1", "1", "gamma_R, inflow angle below 0.", 0.0,
         2.0},
        {"straight_star", &MmgStern::straight_star, "1", "1", "gamma_R, inflow angle above 0.", 0.0,
         2.0}};
};

template <>
struct VesselTable<SteeringDef> {
    static constexpr FieldInfo<SteeringDef> kNumbers[] = {
        {"most_angle_deg", &SteeringDef::most_angle, "deg", "35", "Largest angle of the rudder.",
         1.0, 90.0},
        {"rate_deg", &SteeringDef::rate, "deg/s", "2.32",
         "Rate at which the steering gear turns the rudder; above 0.", 0.0, 500.0},
        {"lag", &SteeringDef::lag, "s", "0", "Time constant of the steering gear.", 0.0, 1e4},
        {"rps", &SteeringDef::rps, "1/s", "0", "Revolutions at the start.", 0.0, 1e3},
        {"most_rps", &SteeringDef::most_rps, "1/s", "twice rps", "Range of the input rps.", 0.0,
         1e3},
        {"shaft_lag", &SteeringDef::shaft_lag, "s", "0", "Time constant of the revolutions.", 0.0,
         1e5}};
};

template <>
struct VesselTable<WindLoad> {
    static constexpr FieldInfo<WindLoad> kNumbers[] = {
        {"frontal_area", &WindLoad::frontal_area, "m^2", "", "A_F above the water.", 0.0, 1e6},
        {"lateral_area", &WindLoad::lateral_area, "m^2", "", "A_L above the water.", 0.0, 1e6},
        {"length", &WindLoad::length, "m", "", "Length over all.", 0.0, kMaxVesselLength},
        {"centre", &WindLoad::centre, "m", "0",
         "Position of the centre of A_L ahead of the origin.", -kMaxVesselLength, kMaxVesselLength},
        {"height", &WindLoad::height, "m", "0", "Height of the centre of A_L above the water.", 0.0,
         kMaxVesselLength}};
};

template <>
struct VesselTable<PropellerDef> {
    static constexpr FieldInfo<PropellerDef> kNumbers[] = {
        {"diameter", &PropellerDef::diameter, "m", "", "Diameter.", 0.0, 100.0},
        {"pitch", &PropellerDef::pitch, "1", "1", "P/D.", 0.1, 3.0},
        {"area", &PropellerDef::area, "1", "0.7", "A_E/A_0 of the B-series.", 0.1, 2.0},
        {"blades", &PropellerDef::blades, "1", "4", "Number of blades of the B-series.", 2.0,
         10.0}};
};

template <>
struct VesselTable<PropulsorDef> {
    static constexpr FieldInfo<PropulsorDef> kNumbers[] = {
        {"thrust", &PropulsorDef::thrust, "N", "with a propeller none",
         "Thrust of an ideal propulsor at full order.", 0.0, kMaxVesselForce},
        {"astern", &PropulsorDef::astern, "1", "1", "Thrust astern over ahead.", 0.0, 1.0},
        {"ramp", &PropulsorDef::ramp, "s", "0",
         "Time in which the output goes from order 0 to order 1.", 0.0, 1e4},
        {"most_rps", &PropulsorDef::most_rps, "1/s", "ideal: none", "Revolutions at full order.",
         0.0, 1e3},
        {"wake", &PropulsorDef::wake, "1", "0", "Wake fraction w.", 0.0, 0.9},
        {"thrust_deduction", &PropulsorDef::thrust_deduction, "1", "0", "t, ahead.", 0.0, 0.9},
        {"shaft_inertia", &PropulsorDef::shaft_inertia, "kg m^2", "0: n follows ramp",
         "Moment of inertia of the shaft with gear and entrained water.", 0.0, 1e18},
        {"response", &PropulsorDef::response, "s", "1",
         "Time constant of the revolutions within the limits; above 0.", 0.0, 1e4},
        {"most_torque", &PropulsorDef::most_torque, "N m", "none",
         "Largest torque of the motor at the shaft.", 0.0, kMaxVesselForce},
        {"most_power", &PropulsorDef::most_power, "W", "none", "Largest power of the motor.", 0.0,
         kMaxVesselForce},
        {"pitch_time", &PropulsorDef::pitch_time, "s", "10",
         "Time in which the pitch goes from full to none.", 0.0, 1e4},
        {"turn_rate_deg", &PropulsorDef::turn_rate, "deg/s", "11.5",
         "Rate at which an azimuth thruster turns; above 0.", 0.0, 5000.0},
        {"most_angle_deg", &PropulsorDef::most_angle, "deg", "turns freely",
         "Largest angle of an azimuth thruster from ahead, to both sides.", 0.0, 180.0},
        {"lost_at", &PropulsorDef::lost_at, "m/s", "no loss",
         "Speed ahead at which a tunnel has no thrust.", 0.0, 1e3},
        {"diameter", &PropulsorDef::diameter, "m", "that of the propeller",
         "Diameter of an ideal propulsor with losses.", 0.0, 100.0},
        {"hull_loss", &PropulsorDef::hull_loss, "1", "0",
         "Fraction of thrust lost if the race flows under the hull; 0.03 for the Coanda effect.",
         0.0, 1.0}};
};

template <>
struct VesselTable<RudderDef> {
    static constexpr FieldInfo<RudderDef> kNumbers[] = {
        {"area", &RudderDef::area, "m^2", "", "Area.", 0.0, 1e5},
        {"aspect", &RudderDef::aspect, "1", "1.5", "Height over chord; above 0.", 0.0, 100.0},
        {"covered", &RudderDef::covered, "1", "1", "Fraction of its height in the slipstream.", 0.0,
         1.0},
        {"slipstream", &RudderDef::slipstream, "1", "0.5",
         "Fraction of the slipstream's final velocity that is reached at the rudder.", 0.0, 1.0},
        {"wake", &RudderDef::wake, "1", "0", "Wake fraction at the rudder.", 0.0, 0.9},
        {"hull_increase", &RudderDef::hull_increase, "1", "0",
         "Side force on the hull over that of the rudder.", 0.0, 2.0},
        {"stall_deg", &RudderDef::stall, "deg", "35", "Angle of attack at which it stalls.", 1.0,
         85.0},
        {"most_angle_deg", &RudderDef::most_angle, "deg", "35", "Largest angle to both sides.", 1.0,
         90.0},
        {"rate_deg", &RudderDef::rate, "deg/s", "2.32",
         "Rate at which the steering gear turns the rudder; above 0.", 0.0, 500.0}};
};

template <>
struct VesselTable<CurrentLoad> {
    static constexpr FieldInfo<CurrentLoad> kNumbers[] = {
        {"length", &CurrentLoad::length, "m", "", "L.", 0.0, kMaxVesselLength},
        {"draught", &CurrentLoad::draught, "m", "", "T.", 0.0, kMaxVesselLength}};
};

template <>
struct VesselTable<GeneratorDef> {
    static constexpr FieldInfo<GeneratorDef> kNumbers[] = {
        {"power", &GeneratorDef::power, "W", "", "Rated power.", 0.0, 1e12}};
};

template <>
struct VesselTable<ConsumerDef> {
    static constexpr FieldInfo<ConsumerDef> kNumbers[] = {
        {"power", &ConsumerDef::power, "W", "0",
         "Ideal propulsor: at full order; load: at the start.", 0.0, 1e12},
        {"efficiency", &ConsumerDef::efficiency, "1", "0.9",
         "Efficiency from the switchboard to the shaft; above 0.", 0.0, 1.0}};
};

template <>
struct VesselTable<PowerDef> {
    static constexpr FieldInfo<PowerDef> kNumbers[] = {
        {"share", &PowerDef::share, "1", "0.9",
         "Fraction of the generators' power for consumers; above 0.", 0.0, 1.0}};
};

/// Read the vessels of one scope. All bodies must have been read (vessels.cpp).
void expand_vessels(Description& out, const Scope& scope);
/// Add the vessels after the sea. @throws SceneError if the world rejects some.
void add_vessels(World& world, const Description& from);

}  // namespace hawser::scene
