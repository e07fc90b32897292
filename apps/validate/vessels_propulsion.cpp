// SPDX-License-Identifier: Apache-2.0
// Propellers on a shaft: pull at constant power, and the energy of a crash stop.
#include <hawser/vessel.h>

#include "validate/tools.h"
#include "validate/vessels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace hawser::validate {
namespace {

constexpr double kShaftStep = 1.0 / 60.0;

/// Check the bollard pull of a Ka4-70 propeller in nozzle 19A at 5 MW, with D = 4 m, density 1025
/// and free revolutions.
void report_pull(Report& report) {
    constexpr double kBollardPulls[2][8] = {
        {919.2, 824.0, 744.6, 676.1, 614.2, 555.1, 495.8, 433.9},
        {916.8, 824.3, 745.0, 674.4, 608.5, 544.0, 478.3, 409.2}};
    constexpr double kPitchRatios[2] = {1.2, 1.0};
    for (int i = 0; i < 2; ++i)
        for (int speed = 0; speed < 8; ++speed) {
            PropellerDef p{.series = PropellerSeries::ka4_70, .diameter = 4.0};
            p.pitch = kPitchRatios[i];
            report.compare(
                fmt::format("Ka4-70, P/D {:g}, 5 MW: pull at {} m/s [kN]", p.pitch, speed),
                {kBollardPulls[i][speed]}, {at_power(p, 5e6, speed, 1025.0).thrust * 1e-3}, 5e-3,
                "relative; polynomials of Oosterveld 1970");
        }
}

/// A ship with one shaft: B4-70 of 4 m, 3.8 MW, 25 t m^2 (O. N. Smogeli 2006).
struct CrashStop {
    World world{WorldDef{.step = kShaftStep}};
    VesselDef def;

    CrashStop(double speed, double inertia) {
        BodyDef body{.name = "hull", .mass = 5e6, .inertia = 1e9 * Mat3::Identity()};
        body.gravity = false;
        body.velocity = {speed, 0.0, 0.0};
        def.name = "ship";
        def.body = world.add_body(body);
        def.resistance.quadratic = 6e3;
        PropulsorDef p;
        p.name = "main";
        p.propeller = {.diameter = 4.0, .pitch = 1.0, .area = 0.7, .blades = 4.0};
        p.most_rps = 2.05;
        p.shaft_inertia = inertia;
        p.most_power = 3.8e6;
        p.most_torque = 3.72e5;
        p.wake = 0.2;
        p.thrust_deduction = 0.1;
        def.propulsors.push_back(p);
        world.add(def);
    }
    [[nodiscard]] double get(const char* name) const {
        return world.system_signal(std::string("ship.") + name);
    }
    [[nodiscard]] double speed() const { return world.velocity(def.body).linear.x(); }
    /// Power of the water on the shaft at the present revolutions and speed, by the series [W].
    [[nodiscard]] double water_power() const {
        const PropulsorDef& p = def.propulsors[0];
        const double n = get("main_rps"), va = (1.0 - p.wake) * speed();
        return 2.0 * kPi * n *
               propeller_force(p.propeller, p.propeller.pitch, n, va, def.density).torque;
    }
    [[nodiscard]] double kinetic() const {
        const double omega = 2.0 * kPi * get("main_rps");
        return 0.5 * def.propulsors[0].shaft_inertia * omega * omega;
    }
};

/// Check the energy of the shaft from full ahead until the ship stops. The work of the motor must
/// equal the work on the water plus the change of kinetic energy. The work on the water is a sum
/// over samples of the propeller series, independent of the shaft's solver.
void report_crash_stop(Report& report, double speed, double inertia) {
    CrashStop s(speed, inertia);
    s.world.set_system_signal("ship.main", 1.0);
    advance(s.world, steps_to(s.world, 120.0));
    s.world.set_system_signal("ship.main", -1.0);
    const double kinetic = s.kinetic();
    double motor = 0.0, water = 0.0, through = 0.0, last = s.water_power();
    bool quadrants[4] = {};
    double stopped = 0.0;
    while (s.world.time() < 600.0 && s.speed() > -1.0) {
        advance(s.world, 1);
        const double now = s.water_power(), given = s.get("main_power");
        motor += given * kShaftStep;
        water += 0.5 * (last + now) * kShaftStep;
        through += 0.5 * (std::abs(given) + std::abs(now)) * kShaftStep;
        last = now;
        const double n = s.get("main_rps");
        quadrants[(s.speed() < 0.0 ? 2 : 0) + (n < 0.0 ? 1 : 0)] = true;
        if (stopped == 0.0 && s.speed() < 0.0) stopped = s.world.time() - 120.0;
        if (stopped > 0.0 && s.speed() < -0.5) s.world.set_system_signal("ship.main", 1.0);
        if (quadrants[2] && s.speed() > -0.4) break;
    }
    const std::string name =
        fmt::format("crash stop from {:g} m/s, {:g} t m^2: ", speed, inertia / 1e3);
    report.compare(
        name + fmt::format("stopped after {:.1f} s; quadrants of speed and revolutions", stopped),
        {4.0}, {static_cast<double>(std::count(quadrants, quadrants + 4, true))}, 0.0, "all four",
        1.0);
    report.compare(name + "energy of the shaft without account", {0.0},
                   {(motor - water - (s.kinetic() - kinetic)) / through}, 1e-3,
                   "of the work exchanged", 1.0);
}

}  // namespace

void case_vessel_propulsion(Report& report) {
    report_pull(report);
    report_crash_stop(report, 6.0, 25e3);
    report_crash_stop(report, 8.0, 5e3);
    report_crash_stop(report, 5.0, 1e5);
}

}  // namespace hawser::validate
