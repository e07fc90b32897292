// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file vessel_hull.h
/// Hull forces of ships that manoeuvre: resistance, cross-flow drag, polynomials, wind.
///
/// *Marine frame.* All coefficients hold in the horizontal frame of the ship: origin O, x ahead
/// in the horizontal projection of the bow, y to starboard, z down. The velocities u, v, r, p are
/// those of O through the water along and about these axes. X, Y, K, N are the forces and moments.
/// Roll φ is positive with starboard down. The rudder angle δ is positive if it turns the ship to
/// starboard.
/// ```
///           bow  ^ x, u
///               /|\          U = √(u² + v²)    drift angle β = atan2(−v, u)
///              | O--> y, v    r' = r L/U        v' = v/U
///              |___|          r > 0: turns to starboard
/// ```
/// *Resistance.* X = −R(u) by a table, mirrored for u < 0, and
/// ```
///     X = σ X_u u + (1 − σ) X_uu |u| u,     σ = 1 − tanh(|u|/u₀)
/// ```
/// *Cross-flow drag.* Strips of the hull at x (S. F. Hoerner, *Fluid-Dynamic Drag*, 1965):
/// ```
///     Y = −½ρ T C_d Σ |v + x r| (v + x r) Δx        N = −½ρ T C_d Σ x |v + x r| (v + x r) Δx
/// ```
/// *Polynomials.* A force is a sum of terms, each a coefficient C times a product of variables, in
/// one of two scales:
/// - `speed`: the sum for X or Y is multiplied by ½ρ A U², that for K or N by ½ρ A L U². Variables
/// are
///   u' = (u − U₀)/U, v', r', p' = p L/U;
/// - `mass`: the sum for X or Y [m/s²] is multiplied by the mass m, that for K or N [1/s²] by m L².
///   Variables are in SI units.
///
/// Letters name the variables of a term, one letter for each power: "vvr" is v² r.
///
/// - u v r p: velocities, as above;
/// - f: roll φ [rad];
/// - d: rudder angle δ × HullPolynomial::rudder_sign [rad];
/// - n: revolutions [1/s], in `mass` alone;
/// - b: atan(v/u) [rad];
/// - V R D N B: magnitudes of v r d n b;
/// - 0: a constant, alone.
///
/// Beyond the published range:
/// - U in the formulas is at least |r| L/r'_most, so that forces stay finite at rest.
/// - u' is limited to −1 to 1.
/// - Astern (u < −0.1 U), terms of velocity alone act on the mirrored ship: u, r, X, N change sign.
///   Terms with the rudder vanish. Between 0.1 U and −0.1 U both laws are blended.
/// - With U₀ > 0 the terms of u alone in X include the propeller and are not mirrored.

#include <hawser/math.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hawser {

/// Force component of a term.
enum class HullAxis : std::uint8_t { x, y, k, n };

/// One term of a polynomial.
struct HullTerm {
    HullAxis axis = HullAxis::x;  ///< Force component.
    std::string of{};             ///< Variables, such as "vvr"; "0": a constant.
    double value = 0.0;           ///< Coefficient C, for angles in rad.
};

/// Scale of polynomials (top of this file).
enum class HullScale : std::uint8_t { speed, mass };

/// Polynomials of a hull.
struct HullPolynomial {
    std::vector<HullTerm> terms{};       ///< Terms; empty: no polynomials.
    HullScale scale = HullScale::speed;  ///< Scale.
    double length = 0.0;                 ///< Length L [m]. Required with terms.
    double area = 0.0;                   ///< Area A of the scale `speed`, such as L d or L² [m²].
    double speed = 0.0;                  ///< Speed U₀ in u' [m/s].
    double most_turn = 1.5;    ///< Largest published turn rate r'_most, scale `speed` [1].
    double rudder_sign = 1.0;  ///< Factor of rudder angles, 1 or −1. −1: the source counts angles
                               ///< to port as positive.
    /// True if the terms include the Coriolis and centripetal forces of the body's own mass.
    bool own_coriolis = false;
};

/// Point of a resistance curve.
struct ResistancePoint {
    double speed = 0.0;       ///< Speed through the water, ascending from 0 [m/s].
    double resistance = 0.0;  ///< Resistance at this speed [N].
};

/// Resistance ahead and astern.
struct HullResistance {
    std::vector<ResistancePoint> curve{};  ///< Curve R(u): linear between points, quadratic beyond
                                           ///< the last.
    double linear = 0.0;                   ///< Linear coefficient −X_u [N s/m].
    double quadratic = 0.0;                ///< Quadratic coefficient −X_uu [N s²/m²].
    double blend = 2.0;                    ///< Speed u₀ of the transition [m/s].
};

/// Cross-flow drag.
struct CrossFlow {
    double length = 0.0;   ///< Length of the ship [m]; 0: no cross-flow drag.
    double beam = 0.0;     ///< Beam [m].
    double draught = 0.0;  ///< Draught [m].
    double drag = 0.0;     ///< Drag coefficient C_d [1]; 0: by Hoerner's curve of beam/(2 draught).
    int strips = 20;       ///< Number of strips of equal length.
    /// True: `strips` + 1 strips, the outer ones centred on the ends, as in MSS' crossFlowDrag.m.
    /// With 20 strips its sway drag is 21/20 of the integral, and its yaw drag 1.21 times the
    /// integral.
    bool end_strips = false;
};
/// Return Hoerner's drag coefficient of a section [1].
/// @param ratio  Beam over twice the draught [1].
[[nodiscard]] double hoerner_drag(double ratio) noexcept;

/// Point of a table of current coefficients.
struct CurrentPoint {
    /// Direction from which the water comes, ascending from 0 (ahead) to π [rad].
    double angle = 0.0;
    double x = 0.0, y = 0.0, n = 0.0;  ///< Coefficients C_X, C_Y, C_N [1].
};
/// Loads of a current at low speed by its direction, as in tables of OCIMF and of model tests:
/// ```
///     X = ½ρ V² C_X L T      Y = ½ρ V² C_Y L T      N = ½ρ V² C_N L² T
/// ```
/// V is the speed of O through the water. Coefficients are linear between points. For water from
/// port, Y and N change sign. This load replaces resistance and cross-flow drag: a vessel with both
/// is rejected. It has no resistance against turning at rest: use VesselDef::damping for this.
struct CurrentLoad {
    std::vector<CurrentPoint> points{};  ///< Points for water from starboard; empty: no load.
    double length = 0.0;                 ///< Length L [m].
    double draught = 0.0;                ///< Draught T [m].
};
/// Return the coefficients for a direction of the water.
/// @param angle  Direction from which the water comes, from ahead, positive from starboard [rad].
[[nodiscard]] CurrentPoint current_coefficients(const CurrentLoad& load, double angle) noexcept;

/// Type of ship with published wind coefficients. Source: W. Blendermann, "Parameter identification
/// of wind loads on ships", 1994.
enum class WindShip : std::uint8_t {
    none,
    car_carrier,
    cargo,
    container,
    diving_support,
    drilling,
    ferry,
    fishing,
    gas_tanker,
    offshore_supply,
    research,
    tanker_loaded,
    tanker_ballast,
    tender
};
/// Return the name of a ship, such as "offshore_supply".
[[nodiscard]] const char* to_string(WindShip ship) noexcept;
inline constexpr int kWindShipCount = 14;

/// Wind load on a ship, by Blendermann's coefficients and the relative wind at `height`.
struct WindLoad {
    WindShip ship = WindShip::none;  ///< Type of the ship; none: no wind load.
    double frontal_area = 0.0;       ///< Frontal projected area A_F [m²].
    double lateral_area = 0.0;       ///< Lateral projected area A_L [m²].
    double length = 0.0;             ///< Length over all L_oa [m].
    double centre = 0.0;             ///< Distance of the centre of A_L ahead of O, s_L [m].
    double height = 0.0;             ///< Height of the centre of A_L above the water, s_H [m].
    double density = 1.225;          ///< Density of the air if the world has no sea [kg/m³].
};
/// Wind coefficients at an angle.
struct WindCoefficients {
    double x = 0.0, y = 0.0, k = 0.0, n = 0.0;  ///< Coefficients C_X, C_Y, C_K, C_N [1].
};
/// Compute the wind coefficients. Signs: X ahead; Y, K, N as in the marine frame.
/// @param angle  Direction from which the wind comes, from ahead, positive from starboard, |angle|
/// ≤ π [rad].
[[nodiscard]] WindCoefficients wind_coefficients(const WindLoad& load, double angle) noexcept;

/// Propeller and rudder of the MMG standard method (H. Yasukawa and Y. Yoshimura, "Introduction of
/// MMG standard method for ship maneuvering predictions", 2015; the symbols are theirs).
/// ```
///     β_P = β − x_P' r'        1 − w_P = (1 − w_P0)(1 + (1 − e^(−2|β_P|))(C − 1))
///     T = ρ n² D⁴ K_T(J)       J = u (1 − w_P)/(n D)
///     u_R = ε u_P √(η (1 + κ (√(1 + 8 K_T/(π J²)) − 1))² + 1 − η),  u_P = u (1 − w_P)
///     v_R = U γ_R (β − l_R' r')
///     F_N = ½ρ A_R (u_R² + v_R²) f_α sin(δ − atan2(v_R, u_R))
///     X = (1 − t_P) T − (1 − t_R) F_N sin δ      Y = −(1 + a_H) F_N cos δ
///     N = −(x_R + a_H x_H) F_N cos δ
/// ```
struct MmgStern {
    double diameter = 0.0;                    ///< Propeller diameter D [m]; 0: no such stern.
    double k0 = 0.0, k1 = 0.0, k2 = 0.0;      ///< Thrust coefficient K_T = k0 + k1 J + k2 J² [1].
    double thrust_deduction = 0.0;            ///< Thrust deduction t_P [1].
    double wake = 0.0;                        ///< Wake fraction w_P0 [1].
    double wake_port = 1.0, wake_star = 1.0;  ///< Wake factor C for β_P > 0 and for β_P < 0 [1].
    double propeller_x = 0.0;             ///< Position of the propeller over the length x_P' [1].
    double rudder_area = 0.0;             ///< Area of the rudder A_R [m²].
    double height_share = 1.0;            ///< Propeller diameter over rudder height η = D/H_R [1].
    double steering_deduction = 0.0;      ///< Steering resistance deduction t_R [1].
    double hull_increase = 0.0;           ///< Increase of the side force on the hull a_H [1].
    double hull_x = 0.0, rudder_x = 0.0;  ///< Positions x_H' and x_R' over the length [1].
    double wake_ratio = 1.0;              ///< Ratio of wake fractions ε [1].
    double slipstream = 0.0;              ///< Factor of the slipstream κ [1].
    double lift_slope = 0.0;              ///< Lift gradient f_α [1].
    double inflow_x = 0.0;                ///< Effective position of the inflow l_R' [1].
    double straight_port = 1.0, straight_star = 1.0;  ///< Flow straightening γ_R for β_R < 0 and
                                                      ///< for β_R > 0 [1].
    double length = 0.0;                              ///< Length L [m].
};

/// Propeller and rudder of K. H. Son and K. Nomoto, "On the coupled motion of steering and rolling
/// of a high-speed container ship", 1981. Lengths over L, velocities over U.
/// ```
///     v_R' = γ v' + c_r r' + c_rrr r'³ + c_rrv r'² v'      u_P' = u'((1 − w) + τ (v' + x_P r')²)
///     u_R' = ε u_P' √(1 + 8 k K_T/(π J²))                   K_T = k0 + k1 J
///     F_N' = −6.13 Λ/(Λ + 2.25) A_R/L² (u_R'² + v_R'²) sin(δ + atan(v_R'/u_R'))
///     X' = (1 − t) T' + c_RX F_N' sin δ                     Y' = (1 + a_H) F_N' cos δ
///     K' = −(1 + a_H) z_R F_N' cos δ                        N' = (x_R + a_H x_H) F_N' cos δ
/// ```
struct SonNomotoStern {
    double diameter = 0.0;      ///< Propeller diameter D [m]; 0: no such stern.
    double length = 0.0;        ///< Length L [m].
    double k0 = 0.0, k1 = 0.0;  ///< Thrust coefficient K_T = k0 + k1 J [1].
    /// Thrust deduction t, wake fraction w, factor τ of the wake in a turn, position x_P [1].
    double thrust_deduction = 0.0, wake = 0.0, wake_turn = 0.0, propeller_x = 0.0;
    double rudder_area = 0.0,
           aspect = 1.0;  ///< Area A_R [m²] and aspect ratio Λ [1] of the rudder.
    double wake_ratio = 1.0, slipstream = 0.0;  ///< Factors ε and k of the rudder's inflow [1].
    double gamma = 0.0, c_r = 0.0, c_rrr = 0.0, c_rrv = 0.0;  ///< Coefficients of v_R' [1].
    double drag_share = 1.0;  ///< Factor c_RX of the rudder's drag [1].
    /// Increase a_H of the side force on the hull, positions x_R, z_R and x_H over the length [1].
    double hull_increase = 0.0, rudder_x = 0.0, rudder_z = 0.0, hull_x = 0.0;
};

}  // namespace hawser
