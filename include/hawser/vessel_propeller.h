// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file vessel_propeller.h
/// Propellers in open water as functions without state.
///
/// Definitions: advance ratio J = V_a/(n D), thrust T = K_T ρ n² D⁴, torque Q = K_Q ρ n² D⁵, with
/// speed of advance V_a [m/s], revolutions n [1/s], diameter D [m]. In all four quadrants of V_a
/// and n:
/// ```
///     β = atan2(V_a, 0.7 π n D)      V² = V_a² + (0.7 π n D)²
///     T = ½ ρ C_T V² π D²/4          Q = ½ ρ C_Q V² π D³/4
/// ```
/// Sources: Wageningen B-series, Re 2e6: M. W. C. Oosterveld and P. van Oossanen, "Further
/// computer-analyzed data of the Wageningen B-screw series", 1975. Ka-series in nozzle 19A:
/// M. W. C. Oosterveld, *Wake adapted ducted propellers*, 1970. Four quadrants: Fourier series of
/// the B4-70, pitch ratio 1.
///
/// Limits: polynomials hold for J from 0 to the J of zero thrust, see kWageningenB; no cavitation,
/// no ventilation, one Reynolds number.

#include <hawser/math.h>

#include <cstdint>
#include <string_view>

namespace hawser {

/// Coefficients of one operating point.
struct PropellerPoint {
    double thrust = 0.0;  ///< K_T, with that of the nozzle [1].
    double torque = 0.0;  ///< K_Q [1].
    double nozzle = 0.0;  ///< K_TN, part of K_T due to the nozzle [1].
};

/// Published ranges of the Wageningen B polynomials.
struct WageningenRange {
    double least_pitch = 0.5, most_pitch = 1.4;    ///< P/D.
    double least_area = 0.30, most_area = 1.05;    ///< A_E/A_0.
    double least_blades = 2.0, most_blades = 7.0;  ///< Z.
};
inline constexpr WageningenRange kWageningenB{};

/// Return a point of the Wageningen B-series. @param advance  J. @param pitch  P/D. @param area
/// A_E/A_0.
[[nodiscard]] PropellerPoint wageningen_b(double advance, double pitch, double area,
                                          double blades) noexcept;
/// Return a point of Ka4-70 in nozzle 19A.
[[nodiscard]] PropellerPoint ka4_70(double advance, double pitch) noexcept;
/// Return a point of Ka5-75 in nozzle 19A.
[[nodiscard]] PropellerPoint ka5_75(double advance, double pitch) noexcept;

/// Coefficients at an advance angle.
struct QuadrantPoint {
    double thrust = 0.0;  ///< C_T [1].
    double torque = 0.0;  ///< C_Q [1].
};
/// Return a point of B4-70 with pitch ratio 1 in all four quadrants. @param angle  β [rad].
[[nodiscard]] QuadrantPoint four_quadrants_b4_70(double angle) noexcept;

enum class PropellerSeries : std::uint8_t { wageningen_b, ka4_70, ka5_75 };
/// Return the name: "wageningen_b", "ka4_70", "ka5_75".
[[nodiscard]] const char* to_string(PropellerSeries series) noexcept;

/// A propeller by its geometry.
struct PropellerDef {
    PropellerSeries series = PropellerSeries::wageningen_b;
    double diameter = 0.0;  ///< [m]. Required.
    double pitch = 1.0;     ///< P/D [1].
    double area = 0.7;      ///< A_E/A_0 of the B-series [1].
    double blades = 4.0;    ///< Number of blades of the B-series.
};
[[nodiscard]] PropellerPoint open_water(const PropellerDef& propeller, double advance) noexcept;

/// Force and torque of a propeller.
struct PropellerForce {
    double thrust = 0.0;  ///< Ahead [N].
    double torque = 0.0;  ///< On the shaft, positive against revolutions ahead [N m].
};
/// Compute thrust and torque at V_a, n and a pitch ratio of any sign.
///
/// Ahead, the polynomials of the series hold for J from 0 to 0.9 |P/D|. From 1.2 |P/D| on, and in
/// the three other quadrants, the Fourier series of the B4-70 holds with the advance angle of
/// V_a/|P/D|. Its thrust and torque are scaled to agree with the series at J = 0. In between both
/// are blended by a cubic. Below a pitch ratio of 0.5 the thrust is linear in the pitch and the
/// torque that of pitch 0.5 times 0.2 + 0.8 (2 |P/D|)². A negative pitch is the mirror image:
/// thrust with the other sign, V_a reversed.
[[nodiscard]] PropellerForce propeller_force(const PropellerDef& propeller, double pitch,
                                             double rps, double speed, double density) noexcept;

/// Operating point at a delivered power.
struct PowerPoint {
    double rps = 0.0;     ///< n [1/s].
    double thrust = 0.0;  ///< [N].
    double torque = 0.0;  ///< [N m].
};
/// Find the revolutions at which a propeller absorbs a power 2π n Q at a speed of advance ≥ 0, by
/// bisection.
/// @param power  [W], above 0.
[[nodiscard]] PowerPoint at_power(const PropellerDef& propeller, double power, double speed,
                                  double density) noexcept;

}  // namespace hawser
