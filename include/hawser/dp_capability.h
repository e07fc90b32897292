// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file dp_capability.h
/// Static DP capability of a ship: the largest wind, waves and current in which its thrusters hold
/// its position. Method: DNV-ST-0111, "Assessment of station keeping capability of dynamic
/// positioning vessels", December 2021, Level 1. The functions need no world.
///
/// **Frame.** x ahead, y to port, z up, the axes of a body in Hawser. Origin: half of L_pp, on the
/// centre line, at the keel. Directions are those *from* which wind, waves and current come,
/// clockwise from ahead: 0 head-on, π/2 from starboard. Moments N = x F_y − y F_x, positive to
/// port.
///
/// **Method.** A condition of the Beaufort scale gives loads of wind, current and wave drift, which
/// are summed and multiplied by 1.25. Each thruster i has a *capacity star* C_i: the set of the
/// forces that it can exert after all losses. B_i is the action of its force f_i on the ship, P_i
/// its brake power. The **utilisation** is the smallest U with
/// ```
///     Σ B_i f_i = −load,   f_i ∈ U C_i,   Σ_board P_i r_i^1.5 ≤ 0.9 P_board U^1.5
/// ```
/// The fraction r_i is |f_i| over the star's radius in the direction of f_i. The second condition
/// limits the power of each switchboard. The ship holds its position if U ≤ 1. Stars are divided
/// into convex sectors (fans). Branch and bound chooses one fan of each thruster, and a linear
/// program solves for the convex hulls of the chosen fans.
///
/// The standard requires |f| ≤ T of an azimuth and leaves the method of allocation open ([3.11.1]).
/// The circle is an inscribed polygon, as in the published solution of the test ship. Vertices lie
/// at multiples of 10°, at the ends of sectors and dips, and at each degree in the dip of a skeg. U
/// is at most 0.4 % larger than with circles (docs/vessels.md).
///
/// **Result.** The number of a heading is the largest Beaufort number n for which U ≤ 1 at all
/// numbers 1 to n. The result `DP capability-L1(A, B, C, D)` has the smallest numbers over
/// headings. The intact ship has A and B, the ship after its worst single failure C and D. Headings
/// within 30° of the bow count for A and C, all headings for B and D.
///
/// Limits: monohulls. Loads are those of the standard, not of the vessel's coefficients. A thruster
/// in line with a skeg has no skeg loss. Sections that Level 1 leaves to the ship's own data (other
/// coefficients, measured thrust) are not covered.

#include <hawser/def.h>
#include <hawser/math.h>

#include <cstdint>
#include <string>
#include <vector>

namespace hawser {

/// Kind of a thruster.
enum class DpThrusterKind : std::uint8_t { azimuth, pod, shaft, cycloidal, tunnel };
/// Kind of a propeller, which determines its thrust factor.
enum class DpPropeller : std::uint8_t { open, ducted, contra_rotating };
/// Shape of a tunnel's inlet, which determines its loss.
enum class DpInlet : std::uint8_t { other, broken, rounded };
/// Machinery between motor and propeller, which determines the mechanical efficiency.
enum class DpDrive : std::uint8_t { standard, permanent_magnet, rim };
/// Profile of a rudder, which determines its lift.
enum class DpRudderProfile : std::uint8_t { naca, hollow, flat, fish_tail, flap, nozzle, mixed };
/// Return the name of an enumerator, such as "azimuth".
[[nodiscard]] const char* to_string(DpThrusterKind kind) noexcept;
[[nodiscard]] const char* to_string(DpPropeller propeller) noexcept;
[[nodiscard]] const char* to_string(DpInlet inlet) noexcept;
[[nodiscard]] const char* to_string(DpDrive drive) noexcept;
[[nodiscard]] const char* to_string(DpRudderProfile profile) noexcept;
inline constexpr int kDpThrusterKinds = 5, kDpPropellers = 3, kDpInlets = 3, kDpDrives = 3,
                     kDpRudderProfiles = 7;

/// Rudder behind a shaft line.
struct DpRudder {
    double area = 0.0;                                ///< Movable area [m²]; 0: no rudder.
    DpRudderProfile profile = DpRudderProfile::naca;  ///< Profile.
};

/// Sector of directions, counter-clockwise from `from` to `to` [rad].
struct DpSector {
    double from = 0.0, to = 0.0;
};

/// Thruster of a ship.
struct DpThruster {
    std::string name{};                             ///< Unique name in the ship. Required.
    DpThrusterKind kind = DpThrusterKind::azimuth;  ///< Kind of the thruster.
    DpPropeller propeller = DpPropeller::open;      ///< Kind of the propeller.
    DpInlet inlet = DpInlet::other;                 ///< Inlet of a tunnel.
    DpDrive drive = DpDrive::standard;              ///< Machinery.
    bool controllable = false;  ///< True: controllable pitch, which increases the thrust astern.
    Vec3 point{0.0, 0.0, 0.0};  ///< Centre of the propeller [m].
    double diameter = 0.0;      ///< Diameter D of the propeller [m]. Required.
    double power = 0.0;         ///< Brake power P_B [W]. Required.
    DpRudder rudder{};          ///< Rudder of a shaft line.
    std::vector<DpSector>
        forbidden{};  ///< Forbidden thrust directions, from ahead, positive to port.
};

/// Switchboard. 90 % of its power is available to thrusters.
struct DpSwitchboard {
    std::string name{};                    ///< Name.
    double power = 0.0;                    ///< Generated power [W].
    std::vector<std::string> thrusters{};  ///< Names of the thrusters that it supplies.
};

/// Single failure.
struct DpFailure {
    std::string name{};                    ///< Name.
    std::vector<std::string> thrusters{};  ///< Names of the thrusters that it stops.
};

/// Skeg of a hull, given by its aft end in the horizontal plane.
struct DpSkeg {
    double x = 0.0, y = 0.0;  ///< Position of the aft end [m].
};

/// Data of a ship.
struct DpShip {
    double length = 0.0;          ///< Length between perpendiculars L_pp [m].
    double beam = 0.0;            ///< Beam B at the waterline [m].
    double draught = 0.0;         ///< Draught T [m].
    double surface_length = 0.0;  ///< Length of the underwater body L_os [m]; 0: `length`.
    double surface_x = 0.0;       ///< Position of the centre of L_os, x_Los [m].
    double bow_angle = 0.0;  ///< Angle between the waterline at the bow and the centre line [rad].
    double aft_waterplane = 0.0;          ///< Waterplane area aft of L_pp/2 [m²].
    double frontal_area = 0.0;            ///< Frontal projected area above the water A_F [m²].
    double lateral_area = 0.0;            ///< Lateral projected area above the water A_L [m²].
    double lateral_x = 0.0;               ///< Position x of the centre of A_L [m].
    double submerged_area = 0.0;          ///< Lateral projected area below the water [m²].
    double submerged_x = 0.0;             ///< Position x of the centre of this area [m].
    std::vector<DpSkeg> skegs{};          ///< Skegs.
    std::vector<DpThruster> thrusters{};  ///< Thrusters. Required.
    std::vector<DpSwitchboard> switchboards{};  ///< Switchboards. Thrusters that none of them
                                                ///< supplies have no common limit of power.
    std::vector<DpFailure> failures{};          ///< Single failures; empty: each thruster alone.
};

/// Check the data of a ship.
/// @throws DefError "dp_capability: field: reason".
void check_dp_ship(const DpShip& ship);

/// Wind, sea and current of a Beaufort number.
struct DpCondition {
    double wind = 0.0;     ///< Wind speed [m/s].
    double height = 0.0;   ///< Significant wave height Hs [m].
    double period = 0.0;   ///< Peak period Tp [s].
    double current = 0.0;  ///< Current speed [m/s].
};
inline constexpr int kDpNumbers = 11;
/// Return wind, waves and current of a Beaufort number by DNV-ST-0111.
/// @param number  1 to 11; other values are clamped.
[[nodiscard]] DpCondition dp_condition(int number) noexcept;

/// Horizontal load at the origin.
struct DpLoad {
    double x = 0.0;  ///< Force ahead [N].
    double y = 0.0;  ///< Force to port [N].
    double n = 0.0;  ///< Moment, positive to port [N m].
};
/// Loads of wind, current and waves, and their sum times 1.25 (`total`).
struct DpLoads {
    DpLoad wind{}, current{}, waves{}, total{};
};
/// Compute the loads of a condition on a ship.
/// @param from  Direction from which wind, waves and current come [rad].
[[nodiscard]] DpLoads dp_loads(const DpShip& ship, const DpCondition& at, double from) noexcept;

/// Compute the nominal thrust of a thruster without losses [N].
/// @param astern  True: thrust of the reversed propeller.
[[nodiscard]] double dp_nominal_thrust(const DpThruster& thruster, bool astern) noexcept;
/// Compute the thrust with ventilation over the nominal thrust [1].
/// @param from  Direction from which the waves come [rad].
/// @param astern  True: for the thrust astern.
[[nodiscard]] double dp_ventilation(const DpShip& ship, const DpThruster& thruster,
                                    const DpCondition& at, double from, bool astern) noexcept;
/// Compute the propeller load factor of the standard [1].
[[nodiscard]] double dp_load_factor(const DpThruster& thruster, bool astern) noexcept;

/// Compute the thrust with the loss at skegs over the thrust without it [1].
/// @param direction  Direction of the thrust, from ahead, positive to port [rad].
[[nodiscard]] double dp_skeg_factor(const DpShip& ship, const DpThruster& thruster,
                                    double direction) noexcept;
/// Return the thrust directions in which the wash of a thruster meets another working thruster.
/// @param thruster  Index of the thruster.
/// @param failed  True for failed thrusters, by index; empty: none failed.
[[nodiscard]] std::vector<DpSector> dp_forbidden_zones(const DpShip& ship, std::size_t thruster,
                                                       const std::vector<bool>& failed);
/// Force of a shaft line with rudder, over its thrust ahead.
struct DpRudderForce {
    double x = 1.0, y = 0.0;  ///< Components ahead and to port [1].
};
/// Compute the force of a shaft line with rudder.
/// @param angle  Rudder angle [rad].
[[nodiscard]] DpRudderForce dp_rudder_force(const DpThruster& thruster, double angle) noexcept;

/// Force of one thruster in a solution.
struct DpThrust {
    double x = 0.0, y = 0.0;  ///< Components ahead and to port [N].
    double fraction = 0.0;    ///< Force over the capacity in its direction [1].
};
/// Smallest utilisation, and the forces with which it is reached.
struct DpUtilisation {
    double value = 0.0;               ///< Utilisation U [1]; infinite: no forces balance the load.
    std::vector<DpThrust> thrusts{};  ///< Force of each thruster.
};
/// Compute the smallest utilisation of a ship in a condition.
/// @param number  Beaufort number, 1 to 11.
/// @param from  Direction from which wind, waves and current come [rad].
/// @param failed  True for failed thrusters, by index; empty: the ship is intact.
[[nodiscard]] DpUtilisation dp_utilisation(const DpShip& ship, int number, double from,
                                           const std::vector<bool>& failed = {});

/// Result for one heading.
struct DpHeading {
    double from = 0.0;         ///< Direction from which wind, waves and current come [rad].
    int number = 0;            ///< Number of the intact ship; 0: none.
    double utilisation = 0.0;  ///< Utilisation at `number` [1]; 0 if `number` is 0.
    double next = 0.0;         ///< Utilisation at `number` + 1 [1]; 0 if `number` is 11.
    std::vector<int> failed_numbers{};  ///< Number after each failure.
    int worst_number = 0;               ///< Smallest of `failed_numbers`.
    std::size_t worst_failure = 0;      ///< Index of the failure with `worst_number`.
};
/// Capability of a ship.
struct DpCapability {
    std::vector<DpHeading> headings{};  ///< Result of each heading.
    std::vector<DpFailure> failures{};  ///< Failures of the ship, or each thruster alone.
    /// Results A, B, C and D (top of this file).
    int bow = 0, all = 0, failed_bow = 0, failed_all = 0;
    /// Return the result as "DP capability-L1(8, 6, 5, 3)".
    [[nodiscard]] std::string text() const;
};
/// Compute the capability of a ship for all headings.
/// @param step  Difference of successive headings, a divisor of 30° [rad].
[[nodiscard]] DpCapability dp_capability(const DpShip& ship, double step = 0.17453292519943295);

}  // namespace hawser
