// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file vessel_propeller.h
/// Thrust and torque of propellers in open water, as functions without state.
///
/// Definitions, with speed of advance V_a [m/s], revolutions n [1/s], diameter D [m]:
/// ```
///     J = V_a/(n D)      T = K_T ρ n² D⁴      Q = K_Q ρ n² D⁵
/// ```
/// J is the advance ratio, T the thrust, Q the torque. K_T and K_Q are not defined at n = 0. In all
/// four quadrants, that is signs of V_a and n, the advance angle β replaces J:
/// ```
///     β = atan2(V_a, 0.7 π n D)      V² = V_a² + (0.7 π n D)²
///     T = ½ ρ C_T V² π D²/4          Q = ½ ρ C_Q V² π D³/4
/// ```
/// Sources: Wageningen B-series, Re 2e6: M. W. C. Oosterveld and P. van Oossanen, "Further
/// computer-analyzed data of the Wageningen B-screw series", 1975. Ka-series in nozzle 19A:
/// M. W. C. Oosterveld, *Wake adapted ducted propellers*, 1970. Four quadrants: Fourier series of
/// the B4-70, pitch ratio 1.
///
/// Limits: the polynomials are valid for J from 0 to the J of zero thrust, within kWageningenB, and
/// for one Reynolds number. They do not include cavitation and ventilation.

#include <hawser/math.h>

#include <cstdint>
#include <string_view>

namespace hawser {

/// Coefficients of one operating point.
struct PropellerPoint {
    double thrust = 0.0;  ///< Thrust coefficient K_T, including the nozzle [1].
    double torque = 0.0;  ///< Torque coefficient K_Q [1].
    double nozzle = 0.0;  ///< Part of K_T from the nozzle, K_TN [1].
};

/// Published ranges of the Wageningen B polynomials.
struct WageningenRange {
    double least_pitch = 0.5, most_pitch = 1.4;    ///< Pitch ratio P/D [1].
    double least_area = 0.30, most_area = 1.05;    ///< Blade area ratio A_E/A_0 [1].
    double least_blades = 2.0, most_blades = 7.0;  ///< Number of blades Z.
};
inline constexpr WageningenRange kWageningenB{};

/// Evaluate the Wageningen B-series.
/// @param advance  Advance ratio J [1].
/// @param pitch  Pitch ratio P/D [1].
/// @param area  Blade area ratio A_E/A_0 [1].
/// @param blades  Number of blades Z.
[[nodiscard]] PropellerPoint wageningen_b(double advance, double pitch, double area,
                                          double blades) noexcept;
/// Evaluate the propeller Ka4-70 in nozzle 19A. Parameters as wageningen_b().
[[nodiscard]] PropellerPoint ka4_70(double advance, double pitch) noexcept;
/// Evaluate the propeller Ka5-75 in nozzle 19A. Parameters as wageningen_b().
[[nodiscard]] PropellerPoint ka5_75(double advance, double pitch) noexcept;

/// Coefficients at an advance angle.
struct QuadrantPoint {
    double thrust = 0.0;  ///< Thrust coefficient C_T [1].
    double torque = 0.0;  ///< Torque coefficient C_Q [1].
};
/// Evaluate the propeller B4-70 with pitch ratio 1 in all four quadrants.
/// @param angle  Advance angle β [rad].
[[nodiscard]] QuadrantPoint four_quadrants_b4_70(double angle) noexcept;

/// Series of propellers.
enum class PropellerSeries : std::uint8_t { wageningen_b, ka4_70, ka5_75 };
/// Return the name of a series, as in its enumerator.
[[nodiscard]] const char* to_string(PropellerSeries series) noexcept;

/// Geometry of a propeller.
struct PropellerDef {
    PropellerSeries series = PropellerSeries::wageningen_b;  ///< Series.
    double diameter = 0.0;                                   ///< Diameter D [m]. Required.
    double pitch = 1.0;                                      ///< Pitch ratio P/D [1].
    double area = 0.7;    ///< Blade area ratio A_E/A_0 of the B-series [1].
    double blades = 4.0;  ///< Number of blades Z of the B-series.
};
/// Evaluate the series of a propeller.
/// @param advance  Advance ratio J [1].
[[nodiscard]] PropellerPoint open_water(const PropellerDef& propeller, double advance) noexcept;

/// Force and torque of a propeller.
struct PropellerForce {
    double thrust = 0.0;  ///< Thrust ahead [N].
    double torque = 0.0;  ///< Torque on the shaft, positive against revolutions ahead [N m].
};
/// Compute thrust and torque at any V_a, n and pitch ratio, each of either sign.
///
/// Ahead, for J from 0 to 0.9 |P/D|: polynomials of the series. For J ≥ 1.2 |P/D|, and in the three
/// other quadrants: Fourier series of the B4-70 at the advance angle of V_a/|P/D|, with thrust and
/// torque scaled to agree with the polynomials at J = 0. Between both ranges of J: a cubic blend.
///
/// Below |P/D| = 0.5 the thrust is linear in the pitch. The torque is that of pitch ratio 0.5,
/// times 0.2 + 0.8 (2 |P/D|)². A negative pitch mirrors the propeller: V_a and the thrust change
/// sign.
/// @param pitch  Pitch ratio P/D [1].
/// @param rps  Revolutions n [1/s].
/// @param speed  Speed of advance V_a [m/s].
/// @param density  Density of the water [kg/m³].
[[nodiscard]] PropellerForce propeller_force(const PropellerDef& propeller, double pitch,
                                             double rps, double speed, double density) noexcept;

/// Operating point at a delivered power.
struct PowerPoint {
    double rps = 0.0;     ///< Revolutions n [1/s].
    double thrust = 0.0;  ///< Thrust [N].
    double torque = 0.0;  ///< Torque [N m].
};
/// Find the revolutions at which a propeller absorbs the power 2π n Q, by bisection.
/// @param power  Power, above 0 [W].
/// @param speed  Speed of advance, ≥ 0 [m/s].
/// @param density  Density of the water [kg/m³].
[[nodiscard]] PowerPoint at_power(const PropellerDef& propeller, double power, double speed,
                                  double density) noexcept;

}  // namespace hawser
