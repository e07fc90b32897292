// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file dp_capability.h
/// Static DP capability of a ship: DNV-ST-0111, "Assessment of station keeping capability of
/// dynamic positioning vessels", December 2021, Level 1. Pure functions without a world.
///
/// **Frame.** x ahead, y to port, z up, the axes of a body in Hawser. Origin: half of L_pp, on the
/// centre line, at the keel. Directions are those *from* which wind, waves and current come,
/// clockwise from ahead: 0 head-on, π/2 from starboard. Moments N = x F_y − y F_x, positive to
/// port.
///
/// **Method.** A condition of the Beaufort scale gives loads of wind, current and wave drift,
/// summed and multiplied by 1.25. Each thruster has a *capacity star* C_i: forces that it can give
/// after all losses. The **utilisation** is the smallest U with
/// ```
///     Σ B_i f_i = −load,   f_i ∈ U C_i,   Σ_board P_i r_i^1.5 ≤ 0.9 P_board U^1.5
/// ```
/// r_i is the fraction |f_i| of the star's radius in the direction of f_i. The ship holds station
/// if U ≤ 1. Stars are cut into convex sectors (fans). A linear program solves the hulls of chosen
/// fans, and branch and bound chooses them.
///
/// The standard requires |f| ≤ T of an azimuth and leaves the method of allocation open ([3.11.1]).
/// The circle is an inscribed polygon, as in the published solution of the test ship. Vertices lie
/// at multiples of 10°, at the ends of sectors and dips, and at each degree in the dip of a skeg. U
/// is at most 0.4 % larger than with circles (docs/vessels.md).
///
/// **Result.** The number of a heading is the largest Beaufort number n for which U ≤ 1 at 1 to n.
/// `DP capability-L1(A, B, C, D)` has the smallest numbers: A intact within 30° of the bow, B
/// intact all round, C and D both for the worst single failure.
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

enum class DpThrusterKind : std::uint8_t { azimuth, pod, shaft, cycloidal, tunnel };
/// Ducted and contra-rotating propellers have their own thrust factors.
enum class DpPropeller : std::uint8_t { open, ducted, contra_rotating };
/// Shape of a tunnel's inlet.
enum class DpInlet : std::uint8_t { other, broken, rounded };
/// Machinery between motor and propeller.
enum class DpDrive : std::uint8_t { standard, permanent_magnet, rim };
enum class DpRudderProfile : std::uint8_t { naca, hollow, flat, fish_tail, flap, nozzle, mixed };
/// Return the name: "azimuth" and so on.
[[nodiscard]] const char* to_string(DpThrusterKind kind) noexcept;
[[nodiscard]] const char* to_string(DpPropeller propeller) noexcept;
[[nodiscard]] const char* to_string(DpInlet inlet) noexcept;
[[nodiscard]] const char* to_string(DpDrive drive) noexcept;
[[nodiscard]] const char* to_string(DpRudderProfile profile) noexcept;
inline constexpr int kDpThrusterKinds = 5, kDpPropellers = 3, kDpInlets = 3, kDpDrives = 3,
                     kDpRudderProfiles = 7;

/// Rudder behind a shaft line.
struct DpRudder {
    double area = 0.0;  ///< Movable area [m²]; 0: no rudder.
    DpRudderProfile profile = DpRudderProfile::naca;
};

/// Sector of directions, counter-clockwise from `from` to `to` [rad].
struct DpSector {
    double from = 0.0, to = 0.0;
};

struct DpThruster {
    std::string name{};  ///< Unique in the ship. Required.
    DpThrusterKind kind = DpThrusterKind::azimuth;
    DpPropeller propeller = DpPropeller::open;
    DpInlet inlet = DpInlet::other;     ///< Inlet of a tunnel.
    DpDrive drive = DpDrive::standard;  ///< Mechanical efficiency.
    bool controllable = false;          ///< Controllable pitch: thrust astern.
    Vec3 point{0.0, 0.0, 0.0};          ///< Centre of the propeller [m].
    double diameter = 0.0;              ///< D [m]. Required.
    double power = 0.0;                 ///< P_B, brake power [W]. Required.
    DpRudder rudder{};                  ///< Rudder of a shaft line.
    std::vector<DpSector> forbidden{};  ///< Thrust directions from ahead, positive to port.
};

/// Switchboard: 90 % of its power is for thrusters.
struct DpSwitchboard {
    std::string name{};
    double power = 0.0;                    ///< Generated [W].
    std::vector<std::string> thrusters{};  ///< Names.
};

/// Thrusters that one failure stops.
struct DpFailure {
    std::string name{};
    std::vector<std::string> thrusters{};
};

/// Skeg by its aft end, in the plane.
struct DpSkeg {
    double x = 0.0, y = 0.0;  ///< [m].
};

/// Data of a ship.
struct DpShip {
    double length = 0.0;          ///< L_pp [m].
    double beam = 0.0;            ///< B, at the waterline [m].
    double draught = 0.0;         ///< T [m].
    double surface_length = 0.0;  ///< L_os, of the underwater body [m]; 0: length.
    double surface_x = 0.0;       ///< x_Los, centre of it [m].
    double bow_angle = 0.0;       ///< Between waterline at the bow and centre line [rad].
    double aft_waterplane = 0.0;  ///< Waterplane area aft of L_pp/2 [m²].
    double frontal_area = 0.0;    ///< A_F above the water [m²].
    double lateral_area = 0.0;    ///< A_L above the water [m²].
    double lateral_x = 0.0;       ///< Centre of A_L [m].
    double submerged_area = 0.0;  ///< A_L below the water [m²].
    double submerged_x = 0.0;     ///< Its centre [m].
    std::vector<DpSkeg> skegs{};
    std::vector<DpThruster> thrusters{};  ///< Required.
    std::vector<DpSwitchboard> switchboards{};
    std::vector<DpFailure> failures{};  ///< Single failures; empty: each thruster alone.
};

/// Check the data. @throws DefError "dp_capability: field: reason".
void check_dp_ship(const DpShip& ship);

/// Wind, sea and current of a number.
struct DpCondition {
    double wind = 0.0;     ///< [m/s].
    double height = 0.0;   ///< Hs [m].
    double period = 0.0;   ///< Peak period Tp [s].
    double current = 0.0;  ///< [m/s].
};
inline constexpr int kDpNumbers = 11;
/// Return the condition of a number. @param number  From 1 to 11; beyond: clamped.
[[nodiscard]] DpCondition dp_condition(int number) noexcept;

/// Horizontal load at the origin.
struct DpLoad {
    double x = 0.0;  ///< [N], ahead.
    double y = 0.0;  ///< [N], to port.
    double n = 0.0;  ///< [N m].
};
/// Parts of a load and their sum times 1.25.
struct DpLoads {
    DpLoad wind{}, current{}, waves{}, total{};
};
/// Compute the loads of a condition. @param from  Direction [rad].
[[nodiscard]] DpLoads dp_loads(const DpShip& ship, const DpCondition& at, double from) noexcept;

/// Compute the nominal thrust without losses [N]. @param astern  True: reversed propeller.
[[nodiscard]] double dp_nominal_thrust(const DpThruster& thruster, bool astern) noexcept;
/// Compute the factor of ventilation. @param astern  True: by the thrust astern.
[[nodiscard]] double dp_ventilation(const DpShip& ship, const DpThruster& thruster,
                                    const DpCondition& at, double from, bool astern) noexcept;
/// Compute the propeller load factor [1].
[[nodiscard]] double dp_load_factor(const DpThruster& thruster, bool astern) noexcept;

/// Compute the radius of a star over its circle by the skegs. @param direction  Direction of the
/// thrust, from ahead, positive to port [rad].
[[nodiscard]] double dp_skeg_factor(const DpShip& ship, const DpThruster& thruster,
                                    double direction) noexcept;
/// Return the sectors in which the wash of a thruster meets working ones. @param failed  By index;
/// empty: none.
[[nodiscard]] std::vector<DpSector> dp_forbidden_zones(const DpShip& ship, std::size_t thruster,
                                                       const std::vector<bool>& failed);
/// Force of a shaft line with rudder over its thrust ahead. @param angle  Rudder angle [rad].
struct DpRudderForce {
    double x = 1.0, y = 0.0;
};
[[nodiscard]] DpRudderForce dp_rudder_force(const DpThruster& thruster, double angle) noexcept;

/// Force of one thruster in a solution.
struct DpThrust {
    double x = 0.0, y = 0.0;  ///< [N].
    double fraction = 0.0;    ///< Fraction of the capacity in this direction [1].
};
/// Utilisation and the forces that reach it.
struct DpUtilisation {
    double value = 0.0;  ///< U; infinite: no forces balance the load.
    std::vector<DpThrust> thrusts{};
};
/// Compute the smallest utilisation. @param failed  By index of the thruster; empty: intact.
[[nodiscard]] DpUtilisation dp_utilisation(const DpShip& ship, int number, double from,
                                           const std::vector<bool>& failed = {});

/// Result of a heading.
struct DpHeading {
    double from = 0.0;                  ///< [rad].
    int number = 0;                     ///< Intact.
    double utilisation = 0.0;           ///< At `number`; 0 if that is 0.
    double next = 0.0;                  ///< At `number` + 1; 0 if `number` is 11.
    std::vector<int> failed_numbers{};  ///< By failure.
    int worst_number = 0;               ///< Smallest of those.
    std::size_t worst_failure = 0;      ///< Its index.
};
struct DpCapability {
    std::vector<DpHeading> headings{};
    std::vector<DpFailure> failures{};  ///< As in the ship, or each thruster.
    int bow = 0, all = 0, failed_bow = 0, failed_all = 0;
    /// Return the result as "DP capability-L1(8, 6, 5, 3)".
    [[nodiscard]] std::string text() const;
};
/// Compute numbers and result. @param step  Between headings, a divisor of 30° [rad].
[[nodiscard]] DpCapability dp_capability(const DpShip& ship, double step = 0.17453292519943295);

}  // namespace hawser
