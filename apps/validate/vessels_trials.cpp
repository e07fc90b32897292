// SPDX-License-Identifier: Apache-2.0
// Turning circles and zig-zags of ships with published coefficients.
#include <hawser/vessel_ships.h>
#include <hawser/vessel_trials.h>

#include "validate/tools.h"
#include "validate/vessels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <vector>

namespace hawser::validate {
namespace {

constexpr double kTrialDegree = kPi / 180.0;
constexpr const char* kOfTrials = "relative; Runge-Kutta of the published equations";

/// A turning circle; lengths over the ship's. NaN: not compared.
struct TurningRow {
    double rudder;                            ///< Positive to starboard [deg].
    double duration;                          ///< [s].
    double advance, transfer, tactical;       ///< [L].
    double speed = kDefault;                  ///< U/U0 at the end.
    double turn_rate = kDefault;              ///< r at the end [deg/s].
    double roll = kDefault, most = kDefault;  ///< At the end, largest [deg].
};

struct ZigZagRow {
    double angle;                              ///< δ = ψ, negative first to port [deg].
    std::vector<double> executes, overshoots;  ///< [s], [deg].
    double roll = kDefault;                    ///< Largest [deg].
};

struct Trial {
    World world{WorldDef{.step = 1.0 / 60.0}};
    PublishedShip ship;
    explicit Trial(const PublishedShip& of) : ship(of) {
        ship.vessel.body = world.add_body(ship.body);
        world.add(ship.vessel);
    }
};

void compare_if(Report& report, const std::string& what, double reference, double ours,
                double tolerance) {
    if (!std::isnan(reference)) report.compare(what, {reference}, {ours}, tolerance, kOfTrials);
}

TurningCircle report_turning(Report& report, const PublishedShip& ship, const std::string& name,
                             const TurningRow& row) {
    Trial trial(ship);
    const TurningCircle t =
        turning_circle(trial.world, trial.ship.vessel, row.rudder * kTrialDegree, row.duration);
    const std::string of = fmt::format("{}, rudder {:+g} deg: ", name, row.rudder);
    compare_if(report, of + "advance [L]", row.advance, t.advance / ship.length, 5e-3);
    compare_if(report, of + "transfer [L]", row.transfer, t.transfer / ship.length, 5e-3);
    compare_if(report, of + "tactical diameter [L]", row.tactical, t.tactical / ship.length, 5e-3);
    compare_if(report, of + "speed over approach speed", row.speed, t.speed / ship.speed, 5e-3);
    compare_if(report, of + "rate of turn [deg/s]", row.turn_rate,
               std::abs(t.turn_rate) / kTrialDegree, 5e-3);
    compare_if(report, of + "steady heel [deg]", row.roll, std::abs(t.roll) / kTrialDegree, 5e-3);
    compare_if(report, of + "largest heel [deg]", row.most, t.most_roll / kTrialDegree, 5e-3);
    return t;
}

ZigZagTrial report_zig_zag(Report& report, const PublishedShip& ship, const std::string& name,
                           const ZigZagRow& row) {
    Trial trial(ship);
    const double angle = row.angle * kTrialDegree;
    const ZigZagTrial z = zig_zag(trial.world, trial.ship.vessel, angle, std::abs(angle),
                                  static_cast<int>(row.overshoots.size()));
    const std::string of = fmt::format("{}, zig-zag {:+g}: ", name, row.angle);
    for (std::size_t i = 0; i < row.executes.size(); ++i)
        report.compare(of + fmt::format("execute {} [s]", i + 2), {row.executes[i]},
                       {i < z.executes.size() ? z.executes[i] : 0.0}, 1e-2, kOfTrials);
    for (std::size_t i = 0; i < row.overshoots.size(); ++i) {
        const double ours = i < z.overshoots.size() ? z.overshoots[i] / kTrialDegree : 0.0;
        // Over the larger of 1 % and 0.1 deg.
        const double scale = std::max(0.1, 0.01 * row.overshoots[i]);
        report.compare(of + fmt::format("overshoot {} [deg]", i + 1), {row.overshoots[i]}, {ours},
                       1.0, "of 1 % or 0.1 deg", scale);
    }
    compare_if(report, of + "largest heel [deg]", row.roll, z.most_roll / kTrialDegree, 5e-3);
    return z;
}

/// Check the criteria of IMO: a criterion is met if the figures of the reference meet it.
void report_imo(Report& report, const PublishedShip& ship, const std::string& name,
                const TurningCircle& turn, const ZigZagTrial& small, const ZigZagTrial& large,
                const std::vector<double>& met) {
    const auto all = imo_criteria(ship.length, ship.speed, turn, small, large);
    for (std::size_t i = 0; i < all.size(); ++i)
        report.compare(fmt::format("{}, IMO: {} {:.2f} {}, at most {:.1f}: met", name, all[i].what,
                                   all[i].value, all[i].unit, all[i].limit),
                       {i < met.size() ? met[i] : -1.0}, {all[i].met() ? 1.0 : 0.0}, 0.0,
                       "as the reference", 1.0);
}

struct ShipRows {
    std::string name;
    std::vector<TurningRow> turns;
    std::vector<ZigZagRow> zig_zags;
    std::vector<double> imo;  ///< Met: advance, tactical diameter, overshoots.
};

/// Compare the trials of a ship with its published figures. @param small, large  Indices of the
/// 10/10 and 20/20 zigzags among the rows; −1: none.
void report_ship(Report& report, const PublishedShip& ship, const ShipRows& rows,
                 std::size_t full_rudder, int small, int large) {
    TurningCircle turn;
    for (std::size_t i = 0; i < rows.turns.size(); ++i) {
        const TurningCircle t = report_turning(report, ship, rows.name, rows.turns[i]);
        if (i == full_rudder) turn = t;
    }
    ZigZagTrial ten, twenty;
    for (std::size_t i = 0; i < rows.zig_zags.size(); ++i) {
        const ZigZagTrial z = report_zig_zag(report, ship, rows.name, rows.zig_zags[i]);
        if (static_cast<int>(i) == small) ten = z;
        if (static_cast<int>(i) == large) twenty = z;
    }
    report_imo(report, ship, rows.name, turn, ten, twenty, rows.imo);
}

}  // namespace

void case_vessel_kvlcc2(Report& report) {
    report_ship(
        report, kvlcc2(KvlccScale::l7),
        {"kvlcc2 L7",
         {{35.0, 200.0, 3.078, 1.332, 3.118, 0.383, 0.861 * 0.3830 * 1.179 / 7.0 / kTrialDegree},
          {-35.0, 100.0, 3.089, 1.332, 3.105}},
         {{10.0, {10.59, 36.77, 75.23}, {4.93, 13.56, 9.35}},
          {-10.0, {}, {7.00, 8.77, 14.18}},
          {20.0, {11.16, 40.06, 75.34}, {10.49, 15.62, 10.90}},
          {-20.0, {}, {13.66, 11.66, 14.31}}},
         {1, 1, 1, 1, 1}},
        0, 0, 2);
    report_ship(report, kvlcc2(KvlccScale::l3),
                {"kvlcc2 L3",
                 {{35.0, 60.0, 3.086, 1.328, 3.119}, {-35.0, 60.0, 3.098, 1.328, 3.105}},
                 {{10.0, {}, {5.03, 14.14, 9.68}}, {20.0, {}, {10.64, 15.95, 11.00}}},
                 {1, 1, 1, 1, 1}},
                0, 0, 1);
    report_ship(report, kvlcc2(KvlccScale::full),
                {"kvlcc2",
                 {{35.0, 600.0, 2.975, 1.271, 3.004}, {-35.0, 600.0, 3.000, 1.282, 3.013}},
                 {{10.0, {68.83, 238.94, 487.42}, {4.89, 13.15, 8.98}},
                  {-10.0, {66.19, 263.01}, {6.93, 8.50, 13.64}},
                  {20.0, {72.55, 261.12, 490.73}, {10.47, 15.32, 10.73}},
                  {-20.0, {71.20, 282.21}, {13.57, 11.46, 14.05}}},
                 {1, 1, 1, 1, 1}},
                0, 0, 2);
}

void case_vessel_mariner(Report& report) {
    const double l = 160.93;
    // The source's positive rudder turns to port. Rate of turn: U/R with R = 575.67 m.
    report_ship(report, mariner(),
                {"mariner",
                 {{-35.0, 1500.0, 596.71 / l, 439.64 / l, 1070.34 / l, 6.0396 / 7.7175,
                   6.0396 / 575.67 / kTrialDegree}},
                 {{-10.0, {34.85, 107.18}, {3.43, 6.19, 4.46}},
                  {-20.0, {37.01, 128.34, 241.07}, {6.71, 7.27, 6.23}}},
                 {1, 0, 1, 1, 1}},
                0, 0, 1);
}

/// Compare the S175 with the published equations. MSS integrates ψ̇ = r cos φ without a pitch rate.
/// Hawser's r is the rate of the heading, as in the horizontal axes of the source. Steady figures
/// agree; tracks differ by 0.5 %. References use ψ̇ = r. With r cos φ the same integration gives
/// 5.618, 8.199 L at 10 degrees and 3.251, 1.814, 4.094 L at 35 degrees.
void case_vessel_s175(Report& report) {
    report_ship(report, s175(),
                {"s175",
                 {{10.0, 1500.0, 5.5984, 3.7121, 8.1615, 0.7952, 0.54904, 5.036, 6.719},
                  {35.0, 1500.0, 3.2315, 1.8014, 4.0791, 0.4525, 0.72504, 3.08, 11.79}},
                 {{10.0, {33.00, 112.67, 200.37}, {3.751, 5.078, 5.026}, 7.356},
                  {20.0, {}, {6.852, 6.424, 6.027}, 9.050}},
                 {1, 1, 1, 1, 1}},
                1, 0, 1);
}

void case_vessel_esso(Report& report) {
    report_ship(
        report, esso_190k(1000.0),
        {"esso, 1000 m",
         {{35.0, 2000.0, 3.238, 1.359, 3.127, 0.2907, 0.45810},
          {-35.0, 800.0, 3.182, 1.322, 3.041}},
         {{10.0, {75.35, 268.05}, {6.259, 14.725}}, {20.0, {78.35, 278.95}, {12.309, 15.945}}},
         {1, 1, 1, 1, 1}},
        0, 0, 1);
    report_ship(report, esso_190k(30.0),
                {"esso, 30 m",
                 {{35.0, 800.0, 3.116, 1.562, 3.222}},
                 {{10.0, {}, {3.837, 7.250}}},
                 {1, 1, 1, 1}},
                0, 0, -1);
    report_ship(report, esso_190k(23.0),
                {"esso, 23 m",
                 {{35.0, 1000.0, 3.364, 2.139, 3.877}},
                 {{10.0, {}, {1.491, 2.009}}, {20.0, {}, {4.102, 5.151}}},
                 {1, 1, 1, 1, 1}},
                0, 0, 1);
    // Approach speeds of 80 rpm.
    constexpr double kSpeeds[3][2] = {{1000.0, 8.2123}, {30.0, 7.5860}, {23.0, 6.8544}};
    for (const auto& [depth, speed] : kSpeeds)
        report.compare(fmt::format("esso, {:g} m: approach speed [m/s]", depth), {speed},
                       {esso_190k(depth).speed}, 1e-3, "relative");
}

std::span<const Case> vessel_cases() {
    static constexpr Case kCases[] = {
        {"V.1", "vessel_osv", "supply vessel: run-up, drift, decays", case_vessel_osv},
        {"V.2", "vessel_kvlcc2", "KVLCC2 by the MMG method at three scales", case_vessel_kvlcc2},
        {"V.3", "vessel_mariner", "Mariner, polynomials", case_vessel_mariner},
        {"V.4", "vessel_s175", "S175 container ship with roll", case_vessel_s175},
        {"V.5", "vessel_esso", "Esso 190k tanker in water of 1000, 30, 23 m", case_vessel_esso},
        {"V.6", "vessel_propulsion", "propellers: pull against speed, crash stop",
         case_vessel_propulsion},
        {"V.10", "vessel_anchors", "drag-embedment anchors", case_vessel_anchors},
        {"V.11", "vessel_stability", "static heel by a wire, and the stability gauge",
         case_vessel_stability},
        {"V.12", "vessel_winches", "heave compensation and overload protection",
         case_vessel_winches},
        {"V.7", "vessel_capability", "DNV-ST-0111 Level 1 of a test ship", case_vessel_capability},
        {"V.8", "vessel_dp", "dynamic positioning of the supply vessel", case_vessel_dp},
    };
    return kCases;
}

}  // namespace hawser::validate
