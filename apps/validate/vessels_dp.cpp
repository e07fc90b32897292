// SPDX-License-Identifier: Apache-2.0
// Dynamic positioning of the supply vessel in a current: PID without actuators (MSS, SIMosv.m).
#include <hawser/sea.h>
#include <hawser/vessel_ships.h>

#include "validate/tools.h"
#include "validate/vessels.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace hawser::validate {

void case_vessel_dp(Report& report) {
    World world(WorldDef{.step = 1.0 / 60.0});
    PublishedShip ship = osv();
    // The reference has C_A of velocities over ground.
    ship.vessel.coriolis = AddedCoriolis::at_rest;
    ship.vessel.control.active = true;
    ship.vessel.control.direct = true;
    ship.vessel.control.observer = false;
    ship.vessel.control.mode = ControlMode::position;
    ship.vessel.control.bandwidth = {0.1, 0.1, 0.3};
    ship.body.position = -ship.vessel.origin;
    ship.vessel.body = world.add_body(ship.body);
    // Towards −140 degrees of the frame with y to starboard.
    SeaDef sea{.depth = 200.0};
    sea.current.push_back({.depth = 0.0, .speed = 0.5, .direction = 140.0 * kPi / 180.0});
    world.add(sea);
    world.add(ship.vessel);
    double max_x = 0.0, max_y = 0.0;
    for (int k = 0; k < 36000; ++k) {
        advance(world, 1);
        const Vec3 at = world.world_point(ship.vessel.body, ship.vessel.origin);
        max_x = std::max(max_x, std::abs(at.x()));
        max_y = std::max(max_y, std::abs(at.y()));
    }
    constexpr const char* kReason = "relative; Runge-Kutta of the published equations";
    const Vec3 end = world.world_point(ship.vessel.body, ship.vessel.origin);
    report.compare("osv, DP in a current: largest offsets x, y [m]", {0.2620, 0.4372},
                   {max_x, max_y}, 5e-3, kReason);
    report.compare("osv, DP in a current: offsets x, y after 600 s [m]", {-0.00019, -0.00025},
                   {end.x(), -end.y()}, 2e-5, "absolute; printed digits and the step", 1.0);
    const auto force = [&](const char* name) {
        return 1e-3 * world.system_signal("osv." + std::string(name));
    };
    report.compare("osv, DP in a current: forces X, Y after 600 s [kN]", {17.696, 37.796},
                   {force("demand_x"), force("demand_y")}, 2e-3, kReason);
    report.compare("osv, DP in a current: moment N after 600 s [kN m]", {0.0}, {force("demand_n")},
                   1.0, "absolute; of 43 kN and 40 m", 1.0);
}

}  // namespace hawser::validate
