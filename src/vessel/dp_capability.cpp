// SPDX-License-Identifier: Apache-2.0
/// Numbers and results of DNV-ST-0111 Level 1 (hawser/dp_capability.h).
#include <hawser/dp_capability.h>

#include "base/number.h"
#include "vessel/dp_star.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace hawser {
namespace {

constexpr double kBoardShare = 0.9;  ///< Fraction of a switchboard's power for thrusters.
constexpr double kBowSector = std::numbers::pi / 6.0;

std::string dp_at(const char* list, std::size_t i, const char* field) {
    return std::string(list) + "/" + std::to_string(i) + "/" + field;
}

[[noreturn]] void fail_dp(const std::string& field, const std::string& why) {
    throw DefError("dp_capability: " + field + ": " + why);
}

void dp_positive(const std::string& field, double value, double most) {
    if (!(value > 0.0 && value <= most))
        fail_dp(field, number(value) + "; give a number above 0 and at most " + number(most));
}

void dp_range(const std::string& field, double value, double least, double most) {
    if (!(value >= least && value <= most))
        fail_dp(field,
                number(value) + "; give a number from " + number(least) + " to " + number(most));
}

void check_thruster(const DpShip& ship, std::size_t i) {
    const DpThruster& t = ship.thrusters[i];
    const auto field = [&](const char* name) { return dp_at("thrusters", i, name); };
    if (t.name.empty()) fail_dp(field("name"), "give a name");
    for (std::size_t j = 0; j < i; ++j)
        if (ship.thrusters[j].name == t.name)
            fail_dp(field("name"), "the name '" + t.name + "' is taken");
    dp_positive(field("diameter"), t.diameter, 100.0);
    dp_positive(field("power"), t.power, 1e9);
    dp_range(field("point"), t.point.x(), -1e3, 1e3);
    dp_range(field("point"), t.point.y(), -1e3, 1e3);
    dp_range(field("point"), t.point.z(), -1e3, ship.draught);
    dp_range(field("rudder/area"), t.rudder.area, 0.0, 1e4);
    if (t.rudder.area > 0.0 && t.kind != DpThrusterKind::shaft)
        fail_dp(field("rudder"), "a shaft alone has a rudder");
    if (t.inlet != DpInlet::other && t.kind != DpThrusterKind::tunnel)
        fail_dp(field("inlet"), "a tunnel alone has an inlet");
    if (t.propeller == DpPropeller::ducted &&
        (t.kind == DpThrusterKind::tunnel || t.kind == DpThrusterKind::cycloidal))
        fail_dp(field("propeller"), "its kind has no duct");
    if (t.drive == DpDrive::permanent_magnet && t.kind != DpThrusterKind::cycloidal)
        fail_dp(field("drive"), "the standard has this efficiency for cycloidal thrusters alone");
    if (t.drive == DpDrive::rim &&
        (t.kind == DpThrusterKind::shaft || t.kind == DpThrusterKind::cycloidal))
        fail_dp(field("drive"), "a rim drive turns azimuths, pods and tunnels");
    for (const DpSector& s : t.forbidden)
        if (!(s.to > s.from && s.to - s.from <= 2.0 * std::numbers::pi))
            fail_dp(field("forbidden"), "give sectors from a smaller to a larger angle");
}

void check_thruster_names(const DpShip& ship, const std::vector<std::string>& names,
                          const std::string& field) {
    std::string known;
    for (const DpThruster& t : ship.thrusters) {
        if (!known.empty()) known += ", ";
        known += t.name;
    }
    for (const std::string& name : names) {
        if (std::any_of(ship.thrusters.begin(), ship.thrusters.end(),
                        [&](const DpThruster& t) { return t.name == name; }))
            continue;
        std::string why = "unknown thruster '" + name + "'; the ship has ";
        why += known;
        fail_dp(field, why);
    }
}

std::vector<bool> failed_thrusters(const DpShip& ship, const DpFailure& failure) {
    std::vector<bool> out(ship.thrusters.size(), false);
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = std::find(failure.thrusters.begin(), failure.thrusters.end(),
                           ship.thrusters[i].name) != failure.thrusters.end();
    return out;
}

/// Largest number for which it and all smaller ones are met, with its utilisation and that of the
/// next number.
struct LargestNumber {
    int number = 0;
    double at = 0.0, next = 0.0;
};
LargestNumber largest_number(const DpShip& ship, double from, const std::vector<bool>& failed) {
    LargestNumber out;
    for (int n = 1; n <= kDpNumbers; ++n) {
        const double u = dp_utilisation(ship, n, from, failed).value;
        if (u > 1.0) {
            out.next = u;
            break;
        }
        out.number = n;
        out.at = u;
    }
    return out;
}

DpHeading dp_heading(const DpShip& ship, double from, const std::vector<DpFailure>& failures) {
    DpHeading out;
    out.from = from;
    const LargestNumber intact = largest_number(ship, from, {});
    out.number = intact.number;
    out.utilisation = intact.at;
    out.next = intact.next;
    out.worst_number = intact.number;
    for (std::size_t k = 0; k < failures.size(); ++k) {
        const int n = largest_number(ship, from, failed_thrusters(ship, failures[k])).number;
        if (k == 0 || n < out.worst_number) {
            out.worst_number = n;
            out.worst_failure = k;
        }
        out.failed_numbers.push_back(n);
    }
    return out;
}

}  // namespace

const char* to_string(DpThrusterKind kind) noexcept {
    constexpr const char* kNames[] = {"azimuth", "pod", "shaft", "cycloidal", "tunnel"};
    return kNames[static_cast<std::size_t>(kind)];
}
const char* to_string(DpPropeller propeller) noexcept {
    constexpr const char* kNames[] = {"open", "ducted", "contra_rotating"};
    return kNames[static_cast<std::size_t>(propeller)];
}
const char* to_string(DpInlet inlet) noexcept {
    constexpr const char* kNames[] = {"other", "broken", "rounded"};
    return kNames[static_cast<std::size_t>(inlet)];
}
const char* to_string(DpDrive drive) noexcept {
    constexpr const char* kNames[] = {"standard", "permanent_magnet", "rim"};
    return kNames[static_cast<std::size_t>(drive)];
}
const char* to_string(DpRudderProfile profile) noexcept {
    constexpr const char* kNames[] = {"naca", "hollow", "flat", "fish_tail",
                                      "flap", "nozzle", "mixed"};
    return kNames[static_cast<std::size_t>(profile)];
}

void check_dp_ship(const DpShip& ship) {
    dp_positive("length", ship.length, 1e3);
    dp_positive("beam", ship.beam, 1e3);
    dp_positive("draught", ship.draught, 1e2);
    dp_range("surface_length", ship.surface_length, 0.0, 1e3);
    dp_range("surface_x", ship.surface_x, -1e3, 1e3);
    dp_range("bow_angle", ship.bow_angle, 0.0, 0.5 * std::numbers::pi);
    dp_positive("aft_waterplane", ship.aft_waterplane, 1e6);
    dp_positive("frontal_area", ship.frontal_area, 1e6);
    dp_positive("lateral_area", ship.lateral_area, 1e6);
    dp_range("lateral_x", ship.lateral_x, -1e3, 1e3);
    dp_positive("submerged_area", ship.submerged_area, 1e6);
    dp_range("submerged_x", ship.submerged_x, -1e3, 1e3);
    if (ship.thrusters.empty()) fail_dp("thrusters", "give one or more");
    if (ship.thrusters.size() > 40) fail_dp("thrusters", "give at most 40");
    for (std::size_t i = 0; i < ship.thrusters.size(); ++i) check_thruster(ship, i);
    for (std::size_t b = 0; b < ship.switchboards.size(); ++b) {
        dp_positive(dp_at("switchboards", b, "power"), ship.switchboards[b].power, 1e10);
        check_thruster_names(ship, ship.switchboards[b].thrusters,
                             dp_at("switchboards", b, "thrusters"));
    }
    for (std::size_t k = 0; k < ship.failures.size(); ++k)
        check_thruster_names(ship, ship.failures[k].thrusters, dp_at("failures", k, "thrusters"));
}

DpUtilisation dp_utilisation(const DpShip& ship, int number, double from,
                             const std::vector<bool>& failed) {
    const DpCondition at = dp_condition(number);
    std::vector<vessel::Star> stars;
    for (std::size_t i = 0; i < ship.thrusters.size(); ++i)
        stars.push_back(vessel::capacity_star(ship, i, at, from, failed));
    std::vector<double> boards;
    for (const DpSwitchboard& b : ship.switchboards) boards.push_back(kBoardShare * b.power);
    return vessel::smallest_utilisation(stars, boards, dp_loads(ship, at, from).total);
}

DpCapability dp_capability(const DpShip& ship, double step) {
    check_dp_ship(ship);
    const double per_sector = kBowSector / step;
    if (!(step > 0.0) || std::abs(per_sector - std::round(per_sector)) > 1e-6)
        throw DefError("dp_capability: step: give a divisor of 30 degrees");
    const long count = std::lround(12.0 * per_sector);
    DpCapability out;
    out.failures = ship.failures;
    if (out.failures.empty())
        for (const DpThruster& t : ship.thrusters) out.failures.push_back({t.name, {t.name}});
    out.bow = out.all = out.failed_bow = out.failed_all = kDpNumbers;
    for (long k = 0; k < count; ++k) {
        const double from =
            static_cast<double>(k) * 2.0 * std::numbers::pi / static_cast<double>(count);
        out.headings.push_back(dp_heading(ship, from, out.failures));
        const DpHeading& h = out.headings.back();
        out.all = std::min(out.all, h.number);
        out.failed_all = std::min(out.failed_all, h.worst_number);
        if (std::abs(std::remainder(from, 2.0 * std::numbers::pi)) > kBowSector + 1e-9) continue;
        out.bow = std::min(out.bow, h.number);
        out.failed_bow = std::min(out.failed_bow, h.worst_number);
    }
    return out;
}

std::string DpCapability::text() const {
    return "DP capability-L1(" + std::to_string(bow) + ", " + std::to_string(all) + ", " +
           std::to_string(failed_bow) + ", " + std::to_string(failed_all) + ")";
}

}  // namespace hawser
