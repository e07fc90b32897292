// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file vessel_propeller.h
/// Propellers in open water as functions without state.
///
/// Definitions, with speed of advance V_a [m/s], revolutions n [1/s], diameter D [m]:
/// ```
///     J = V_a/(n D)      T = K_T ρ n² D⁴      Q = K_Q ρ n² D⁵
/// ```
/// J is the advance ratio, T the thrust, Q the torque. In all four quadrants of V_a and n:
/// ```
///     β = atan2(V_a, 0.7 π n D)      V² = V_a² + (0.7 π n D)²
///     T = ½ ρ C_T V² π D²/4          Q = ½ ρ C_Q V² π D³/4
/// ```
/// Sources: Wageningen B-series, Re 2e6: M. W. C. Oosterveld and P. van Oossanen, "Further
/// computer-analyzed data of the Wageningen B-screw series", 1975. Ka-series in nozzle 19A:
/// M. W. C. Oosterveld, *Wake adapted ducted propellers*, 1970. Four quadrants: Fourier series of
/// the B4-70, pitch ratio 1.
///
/// Limits: the polynomials hold for J from 0 to the J of zero thrust, see kWageningenB. They
/// contain no cavitation and no ventilation, and hold for one Reynolds number.

#include <hawser/math.h>

#include <cstdint>
#include <string_view>

namespace hawser {

/// Coefficients of one operating point.
struct PropellerPoint {
    double thrust = 0.0;  ///< K_T, including the nozzle [1].
    double torque = 0.0;  ///< K_Q [1].
    double nozzle = 0.0;  ///< K_TN: part of K_T from the nozzle [1].
};

/// Published ranges of the Wageningen B polynomials.
struct WageningenRange {
    double least_pitch = 0.5, most_pitch = 1.4;    ///< P/D.
    double least_area = 0.30, most_area = 1.05;    ///< A_E/A_0.
    double least_blades = 2.0, most_blades = 7.0;  ///< Z.
};
inline constexpr WageningenRange kWageningenB{};

/// Evaluate the Wageningen B-series. @param advance  J. @param pitch  P/D. @param area  A_E/A_0.
[[nodiscard]] PropellerPoint wageningen_b(double advance, double pitch, double area,
                                          double blades) noexcept;
/// Evaluate Ka4-70 in nozzle 19A.
[[nodiscard]] PropellerPoint ka4_70(double advance, double pitch) noexcept;
/// Evaluate Ka5-75 in nozzle 19A.
[[nodiscard]] PropellerPoint ka5_75(double advance, double pitch) noexcept;

/// Coefficients at an advance angle.
struct QuadrantPoint {
    double thrust = 0.0;  ///< C_T [1].
    double torque = 0.0;  ///< C_Q [1].
};
/// Evaluate B4-70 with pitch ratio 1 in all four quadrants. @param angle  β [rad].
[[nodiscard]] QuadrantPoint four_quadrants_b4_70(double angle) noexcept;

enum class PropellerSeries : std::uint8_t { wageningen_b, ka4_70, ka5_75 };
/// Return "wageningen_b", "ka4_70" or "ka5_75".
[[nodiscard]] const char* to_string(PropellerSeries series) noexcept;

/// Geometry of a propeller.
struct PropellerDef {
    PropellerSeries series = PropellerSeries::wageningen_b;
    double diameter = 0.0;  ///< Diameter D [m]. Required.
    double pitch = 1.0;     ///< P/D [1].
    double area = 0.7;      ///< A_E/A_0 of the B-series [1].
    double blades = 4.0;    ///< Z of the B-series [1].
};
[[nodiscard]] PropellerPoint open_water(const PropellerDef& propeller, double advance) noexcept;

/// Force and torque of a propeller.
struct PropellerForce {
    double thrust = 0.0;  ///< Ahead [N].
    double torque = 0.0;  ///< On the shaft, positive against revolutions ahead [N m].
};
/// Compute thrust and torque at any V_a, n and pitch ratio, each of either sign.
///
/// Ahead, J from 0 to 0.9 |P/D|: polynomials of the series. J ≥ 1.2 |P/D| and the three other
/// quadrants: Fourier series of the B4-70 at the advance angle of V_a/|P/D|. Its thrust and torque
/// are scaled to agree with the polynomials at J = 0. Between both ranges of J: a cubic blend.
///
/// P/D| < 0.5: the thrust is linear in the pitch, and the torque is the one of pitch 0.5 times 0.2
/// + 0.8 (2 |P/D|)². A negative pitch mirrors: V_a and the thrust change sign.
[[nodiscard]] PropellerForce propeller_force(const PropellerDef& propeller, double pitch,
                                             double rps, double speed, double density) noexcept;

/// Operating point at a delivered power.
struct PowerPoint {
    double rps = 0.0;     ///< n [1/s].
    double thrust = 0.0;  ///< Thrust [N].
    double torque = 0.0;  ///< Torque [N m].
};
/// Find the revolutions at which a propeller absorbs a power 2π n Q, by bisection. The speed of
/// advance is ≥ 0. @param power  [W], above 0.
[[nodiscard]] PowerPoint at_power(const PropellerDef& propeller, double power, double speed,
                                  double density) noexcept;

}  // namespace hawser
