// SPDX-License-Identifier: Apache-2.0
// DNV-ST-0111 Level 1 of a published test ship: loads, utilisations, failures and result.
#include <hawser/dp_capability.h>

#include "validate/tools.h"
#include "validate/vessels.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace hawser::validate {
namespace {

constexpr double kCapabilityDegree = kPi / 180.0;
constexpr const char* kTestShip = "test ship of the standard, solved apart";

/// Make an offshore ship of 80 m with two ducted azimuths and two bow tunnels.
DpShip test_ship() {
    DpShip s;
    s.length = 80.0;
    s.beam = 18.0;
    s.draught = 6.0;
    s.surface_length = 86.0;
    s.surface_x = -1.0;
    s.bow_angle = std::atan(0.45);
    s.aft_waterplane = 648.0;
    s.frontal_area = 280.0;
    s.lateral_area = 700.0;
    s.lateral_x = 12.0;
    s.submerged_area = 490.0;
    s.submerged_x = -1.5;
    s.skegs = {{-36.0, 0.0}};
    for (const double side : {1.0, -1.0}) {
        DpThruster t;
        t.name = side > 0.0 ? "AZ1" : "AZ2";
        t.propeller = DpPropeller::ducted;
        t.point = {-40.0, 5.5 * side, 1.8};
        t.diameter = 3.0;
        t.power = 2e6;
        s.thrusters.push_back(t);
    }
    for (const bool first : {true, false}) {
        DpThruster t;
        t.name = first ? "BT1" : "BT2";
        t.kind = DpThrusterKind::tunnel;
        t.inlet = first ? DpInlet::rounded : DpInlet::broken;
        t.point = {first ? 31.0 : 28.0, 0.0, 2.5};
        t.diameter = 2.0;
        t.power = 9e5;
        s.thrusters.push_back(t);
    }
    s.failures = {{"AZ1 and BT1", {"AZ1", "BT1"}}, {"AZ2 and BT2", {"AZ2", "BT2"}}};
    return s;
}

void report_thrust(Report& report, const DpShip& ship) {
    const auto kilonewtons = [&](std::size_t i, bool astern) {
        return 1e-3 * dp_nominal_thrust(ship.thrusters[i], astern);
    };
    report.compare(
        "DP test ship: thrust of AZ, AZ astern, BT1, BT2 [kN]",
        {377.518, 264.262, 135.768, 126.886},
        {kilonewtons(0, false), kilonewtons(0, true), kilonewtons(2, false), kilonewtons(3, false)},
        2e-6, "printed digits");
    const double abeam = 0.5 * kPi;
    for (const auto& [number, factors] :
         {std::pair<int, std::vector<double>>{6, {0.98491, 0.99885, 0.99920}},
          {11, {0.72475, 0.86106, 0.88337}}}) {
        std::vector<double> ours;
        for (const std::size_t i : {0, 2, 3})
            ours.push_back(
                dp_ventilation(ship, ship.thrusters[i], dp_condition(number), abeam, false));
        report.compare(fmt::format("DP test ship: ventilation at number {} abeam [1]", number),
                       factors, ours, 2e-5, "printed digits");
    }
}

void report_loads(Report& report, const DpShip& ship) {
    struct Row {
        int number;
        double from;
        std::vector<double> load;
    };
    const Row rows[] = {
        {6, 0.0, {-62.07, 0.0, 0.0}},           {6, 30.0, {-54.39, 178.98, 2371.44}},
        {6, 90.0, {-5.54, 357.95, 508.99}},     {6, 135.0, {43.66, 253.11, -1960.43}},
        {11, 90.0, {-35.31, 1570.42, 3409.70}}, {8, 330.0, {-120.48, -332.11, -4104.00}}};
    for (const Row& r : rows) {
        const DpLoad l = dp_loads(ship, dp_condition(r.number), r.from * kCapabilityDegree).total;
        const double worst =
            std::max({std::abs(1e-3 * l.x - r.load[0]), std::abs(1e-3 * l.y - r.load[1]),
                      std::abs(1e-3 * l.n - r.load[2])});
        report.compare(fmt::format("DP test ship: load at number {} from {} deg, off by [kN, kN m]",
                                   r.number, r.from),
                       {0.0}, {worst}, 0.0051, "printed digits", 1.0);
    }
}

void report_utilisations(Report& report, const DpCapability& c) {
    struct Row {
        int number;
        double at, next;
    };
    constexpr Row kRows[] = {
        {11, .628, 0},    {11, .892, 0},     {9, .885, 1.150}, {8, .904, 1.242}, {7, .839, 1.119},
        {7, .962, 1.285}, {6, .750, 1.045},  {6, .779, 1.091}, {6, .782, 1.099}, {6, .759, 1.071},
        {6, .714, 1.011}, {7, .924, 1.250},  {7, .815, 1.105}, {8, .937, 1.320}, {8, .760, 1.070},
        {9, .813, 1.064}, {10, .723, 1.048}, {11, .747, 0},    {11, .650, 0}};
    for (std::size_t k = 0; k < 36; ++k) {
        const DpHeading& h = c.headings[k];
        const Row& r = kRows[k <= 18 ? k : 36 - k];
        report.compare(fmt::format("DP test ship: number from {} deg", 10 * k),
                       {static_cast<double>(r.number)}, {static_cast<double>(h.number)}, 0.0,
                       kTestShip, 1.0);
        report.compare(fmt::format("DP test ship: utilisation from {} deg", 10 * k), {r.at},
                       {h.utilisation}, 5e-4, "absolute; printed digits", 1.0);
        report.compare(fmt::format("DP test ship: utilisation at the next number, {} deg", 10 * k),
                       {r.next}, {h.next}, 5e-4, "absolute; printed digits", 1.0);
    }
}

void report_failures(Report& report, const DpCapability& c) {
    constexpr int kFailed[2][36] = {{10, 8,  6, 5, 4, 4, 3, 3, 3, 4, 4, 4, 5, 5, 6, 7, 8, 8,
                                     10, 10, 7, 6, 6, 5, 4, 4, 4, 4, 3, 3, 3, 4, 4, 5, 6, 9},
                                    {10, 9, 6, 5, 5, 4, 4, 4, 4, 4, 4, 4, 5, 5, 6, 7, 8, 10,
                                     10, 8, 8, 7, 6, 5, 5, 4, 4, 4, 4, 4, 4, 4, 4, 5, 6, 8}};
    for (std::size_t f = 0; f < 2; ++f) {
        std::vector<double> expected, ours;
        for (std::size_t k = 0; k < 36; ++k) {
            expected.push_back(kFailed[f][k]);
            ours.push_back(c.headings[k].failed_numbers[f]);
        }
        report.compare("DP test ship: numbers without " + c.failures[f].name, expected, ours, 0.0,
                       kTestShip, 1.0);
    }
    report.compare("DP test ship: DP capability-L1", {8, 6, 5, 3},
                   {static_cast<double>(c.bow), static_cast<double>(c.all),
                    static_cast<double>(c.failed_bow), static_cast<double>(c.failed_all)},
                   0.0, kTestShip, 1.0);
}

}  // namespace

void case_vessel_capability(Report& report) {
    const DpShip ship = test_ship();
    report_thrust(report, ship);
    report_loads(report, ship);
    const DpCapability c = dp_capability(ship);
    report_utilisations(report, c);
    report_failures(report, c);
}

}  // namespace hawser::validate
