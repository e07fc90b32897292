// SPDX-License-Identifier: Apache-2.0
// The offshore supply vessel of T. I. Fossen (MSS, osv.m) in six degrees of freedom.
#include <hawser/sea.h>
#include <hawser/vessel_ships.h>

#include "validate/tools.h"
#include "validate/vessels.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace hawser::validate {
namespace {

constexpr double kVesselStep = 1.0 / 60.0;
constexpr const char* kFine = "relative; Runge-Kutta of the published equations";

/// Pushes a body at a point along its own axes.
struct Pusher final : System {
    BodyId body{};
    Vec3 point{0.0, 0.0, 0.0}, force{0.0, 0.0, 0.0};
    [[nodiscard]] std::string_view name() const noexcept override { return "pusher"; }
    void prestep(Prestep& now, Loads& loads) noexcept override {
        const Quat turn = now.world.pose(body).orientation;
        const Vec3 f = turn * force;
        loads.add_force(body, f, Vec3((turn * point).cross(f)));
    }
};

struct Supply {
    World world{WorldDef{.step = kVesselStep}};
    PublishedShip ship = osv();

    /// With C_A of velocities over ground, as osv.m has it.
    Supply() { ship.vessel.coriolis = AddedCoriolis::at_rest; }
    void add() {
        ship.vessel.body = world.add_body(ship.body);
        world.add(ship.vessel);
    }
    void run_to(double time) { advance(world, std::lround((time - world.time()) / kVesselStep)); }
    [[nodiscard]] Vec3 place() const {
        return world.world_point(ship.vessel.body, ship.vessel.origin);
    }
    /// Velocity of O at the end of the last step, in the body's frame [m/s].
    [[nodiscard]] Vec3 speed() const {
        const Quat turn = world.pose(ship.vessel.body).orientation;
        const Twist v = world.velocity(ship.vessel.body);
        const Vec3 at = v.linear + v.angular.cross(Vec3(turn * ship.vessel.origin));
        return turn.conjugate() * at;
    }
    [[nodiscard]] Mat3 axes() const {
        return world.pose(ship.vessel.body).orientation.toRotationMatrix();
    }
};

void report_run_up(Report& report) {
    Supply s;
    s.add();
    s.world.set_system_signal("osv.port", 1.0);
    s.world.set_system_signal("osv.starboard", 1.0);
    std::vector<double> u, x;
    for (const double t : {30.0, 60.0, 120.0, 600.0}) {
        s.run_to(t);
        u.push_back(s.speed().x());
        x.push_back(s.place().x());
    }
    x.pop_back();
    constexpr double kSpeed[] = {4.87890, 6.97165, 7.66437, 7.70210};
    constexpr double kWay[] = {79.005, 262.853, 710.813};
    for (std::size_t i = 0; i < u.size(); ++i)
        report.compare(fmt::format("osv, full ahead: speed {} [m/s]",
                                   i < 3 ? fmt::format("after {} s", 30 << i) : "at the end"),
                       {kSpeed[i]}, {u[i]}, 2e-3, kFine);
    for (std::size_t i = 0; i < x.size(); ++i)
        report.compare(fmt::format("osv, full ahead: way after {} s [m]", 30 << i), {kWay[i]},
                       {x[i]}, 2e-3, kFine);
}

void report_drift(Report& report) {
    {
        Supply s;
        s.add();
        auto pusher = std::make_unique<Pusher>();
        pusher->body = s.ship.vessel.body;
        pusher->point = s.ship.vessel.origin;
        pusher->force = {0.0, -200e3, 0.0};
        s.world.add_system(std::move(pusher));
        s.run_to(600.0);
        report.compare("osv, 200 kN to starboard: sway speed after 600 s [m/s]", {0.948313},
                       {-s.speed().y()}, 5e-3, kFine);
        report.compare("osv, 200 kN to starboard: way [m]", {544.97}, {-s.place().y()}, 5e-3,
                       kFine);
    }
    Supply s;
    SeaDef sea{.depth = 200.0};
    sea.current.push_back({.depth = 0.0, .speed = 1.0, .direction = -0.5 * kPi});
    s.world.add(sea);
    s.add();
    s.run_to(300.0);
    report.compare("osv adrift, current of 1 m/s abeam: sway speed after 300 s [m/s]", {0.983486},
                   {-s.speed().y()}, 5e-3, kFine);
    report.compare("osv adrift, current of 1 m/s abeam: way [m]", {248.063}, {-s.place().y()}, 5e-3,
                   kFine);
    report.compare("osv adrift, current of 1 m/s abeam: heading [rad]", {0.00871},
                   {-std::atan2(s.axes()(1, 0), s.axes()(0, 0))}, 5e-3, kFine);
}

/// Return the times of the zero crossings after a release from a displacement in heave, roll or
/// pitch.
std::vector<double> crossings(int motion) {
    Supply s;
    Quat turn = Quat::Identity();
    Vec3 place{0.0, 0.0, 0.0};
    if (motion == 0) place.z() = -1.0;
    if (motion == 1) turn = Quat(Eigen::AngleAxisd(0.1, Vec3::UnitX()));
    if (motion == 2) turn = Quat(Eigen::AngleAxisd(-0.05, Vec3::UnitY()));
    s.ship.body.orientation = turn;
    s.ship.body.position = place - turn * s.ship.vessel.origin;
    s.add();
    std::vector<double> times;
    double before = 1.0;
    while (times.size() < 4 && s.world.time() < 100.0) {
        advance(s.world, 1);
        const Mat3 axes = s.axes();
        const double now = motion == 0   ? -s.place().z()
                           : motion == 1 ? std::atan2(axes(2, 1), axes(2, 2))
                                         : std::asin(axes(2, 0));
        if (before * now < 0.0)
            times.push_back(s.world.time() - kVesselStep * now / (now - before));
        before = now;
    }
    return times;
}

void report_decays(Report& report) {
    // Initial values 1 m, 0.1 rad, 0.05 rad.
    constexpr double kTimes[3][4] = {{1.8703, 5.5175, 9.5787, 13.5467},
                                     {2.8401, 8.0183, 13.1963, 18.3745},
                                     {2.0159, 6.1230, 10.4565, 14.2804}};
    constexpr const char* kMotions[] = {"heave", "roll", "pitch"};
    for (int i = 0; i < 3; ++i) {
        const std::vector<double> times = crossings(i);
        for (std::size_t k = 0; k < 4; ++k)
            report.compare(
                fmt::format("osv, decay of {}: zero crossing {} [s]", kMotions[i], k + 1),
                {kTimes[i][k]}, {k < times.size() ? times[k] : 0.0}, 5e-3, kFine);
    }
}

}  // namespace

void case_vessel_osv(Report& report) {
    report_run_up(report);
    report_drift(report);
    report_decays(report);
}

}  // namespace hawser::validate
