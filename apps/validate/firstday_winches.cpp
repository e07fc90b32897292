// SPDX-License-Identifier: Apache-2.0
// Winches, bare drums, routes and guides in a beginner's scenes, compared with statics.
#include "validate/firstday.h"
#include "validate/tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace hawser::validate {
namespace {

constexpr double kWinchSteps[] = {1.0 / 60.0, 1.0 / 240.0};

std::string at_step(double step) { return fmt::format(", step 1/{:.0f}", 1.0 / step); }

void run_for(World& w, double seconds) { advance(w, std::lround(seconds / w.settings().step)); }

double event_count(const World& w, EventKind kind) {
    return static_cast<double>(w.events().extremes(kind).count);
}

/// Check a winch with the power P that lifts a load of 20 t on wire of 4 kg/m.
void report_power(Report& report, double step) {
    constexpr double kPower = 1e5, kLoad = 2e4, kLineDensity = 4.0;
    World w(WorldDef{.step = step});
    const BodyId deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
    const BodyId load = w.add_body(
        {.name = "load", .kind = BodyKind::lump, .position = {0, 0, -60}, .mass = kLoad});
    const WireId wire = w.wires().add({.name = "wire",
                                       .from = deck,
                                       .to = load,
                                       .elements = 12,
                                       .EA = 1e8,
                                       .mass_per_length = kLineDensity,
                                       .axial_damping = 0.5,
                                       .consistent_mass = true});
    const WinchIds ids = w.add(WinchDef{.name = "winch",
                                        .wire = wire,
                                        .core_radius = 0.4,
                                        .width = 1.0,
                                        .flange_radius = 0.9,
                                        .wire_diameter = 0.032,
                                        .mass_per_length = kLineDensity,
                                        .stored = 100.0,
                                        .inertia = 300.0,
                                        .torque_haul = 1.5e5,
                                        .torque_pay = 1.5e5,
                                        .power = kPower,
                                        .speed = -2.0,
                                        .brake_static = 2e5,
                                        .mode = WinchMode::speed});
    double most = 0.0;
    for (long i = std::lround(30.0 / step); i > 0; --i) {
        advance(w, 1);
        most = std::max(most, w.force(ids.motor)[0] * w.velocity(ids.drum).linear.x());
    }
    report.compare("torque times speed of a winch over its power, at most 1" + at_step(step), {1.0},
                   {std::max(1.0, most / kPower)}, 1e-5, "tolerance of moving bounds: 1e-6");
    const double hangs = kLoad - kLineDensity * w.pose(load).position.z();
    report.compare("speed at which it lifts [m/s]" + at_step(step), {kPower / (hangs * kGravity)},
                   {w.velocity(load).linear.z()}, 2e-2, "relative; the wire's weight falls");
}

/// Check a bare drum of radius r that feeds a wire of the line density ρ with a load m. The wire is
/// hauled to its stop and paid out again.
void report_drum(Report& report, double step) {
    constexpr double kLineDensity = 23.0, kLoad = 13e3, kRadius = 0.5, kElement = 2.5;
    World w(WorldDef{.step = step});
    const BodyId deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
    const BodyId drum =
        w.add_body({.name = "drum", .kind = BodyKind::scalar, .mass = 4e3, .gravity = false});
    const BodyId load = w.add_body({.name = "load",
                                    .position = {0, 0, -4.0 * kElement},
                                    .mass = kLoad,
                                    .inertia = 5e3 * Mat3::Identity()});
    const WireId wire = w.wires().add({.name = "wire",
                                       .from = deck,
                                       .to = load,
                                       .elements = 4,
                                       .EA = 2.33e8,
                                       .mass_per_length = kLineDensity,
                                       .consistent_mass = true});
    w.wires().spool(wire, 0, drum, kRadius);
    const DrumIds parts =
        w.add(DrumDef{.name = "winch",
                      .drum = drum,
                      .motor = AxisMotor{.speed = 0.0, .force_min = -3e5, .force_max = 3e5}});
    w.add_input({.name = "speed", .interaction = parts.motor, .param = "speed"});
    w.add(DrumFeedDef{.name = "feed", .wire = wire, .mass_per_length = kLineDensity});
    double now = 0.0;
    const auto drive = [&](double seconds, double speed) {
        const double before = now;
        for (long i = 0; i < std::lround(seconds / step); ++i) {
            const double ramp = std::min(1.0, static_cast<double>(i + 1) * step);
            now = before + ramp * (speed - before);
            w.set_input(w.find_input("speed"), now / kRadius);
            advance(w, 1);
        }
    };
    drive(20.0, -1.0);
    const double stops = event_count(w, EventKind::hauled_in);
    const auto left = static_cast<double>(w.wires().elements(wire).size());
    drive(12.0, 1.0);
    drive(40.0, 0.0);
    report.compare(
        "bare drum hauled to its stop and out: events hauled_in, elements left" + at_step(step),
        {1.0, 1.0, 1.0}, {stops, left, event_count(w, EventKind::hauled_in)}, 0.0, "counts");
    const double length = 4.0 * kElement + kRadius * w.pose(drum).position.x();
    const double last = w.interaction_def(w.wires().elements(wire).back()).get("length");
    report.compare("torque of its motor at rest [N m]" + at_step(step),
                   {kRadius * kGravity * (kLoad + kLineDensity * (length - 0.5 * last))},
                   {-w.force(parts.motor)[0]}, 1e-5,
                   "relative; r (m + rho (L - half an element)) g");
}

/// Check that the end of a line over two eyes with the smaller load moves up to its eye and stops
/// there.
void report_eye(Report& report, double step) {
    constexpr double kLight = 12.0, kHeavy = 90.0, kLeft = 3.0, kRight = 2.0;
    World w(WorldDef{.step = step});
    const BodyId top = w.add_body({.kind = BodyKind::fixed});
    const auto lump = [&](double x, double z, double mass) {
        return w.add_body({.kind = BodyKind::lump,
                           .position = {x, 0, -z},
                           .mass = mass,
                           .linear_damping = Vec3::Constant(0.2 * mass)});
    };
    const BodyId a = lump(0.0, kLeft, kLight), b = lump(1.5, kRight, kHeavy);
    const Route r = w.add(RouteDef{.name = "rope",
                                   .EA = 1e6,
                                   .first = {.body = a},
                                   .places = {{.body = top}, {.body = top, .point = {1.5, 0, 0}}},
                                   .last = {.body = b},
                                   .damping_time = 0.05});
    run_for(w, 40.0);
    report.compare("weight that hangs on a line whose end is at its eye [N]" + at_step(step),
                   {kHeavy * kGravity}, {-w.force(r.parts.back())[0]}, 2e-2, "relative");
    report.compare("its speed [m/s]" + at_step(step), {0.0}, {w.velocity(b).linear.norm()}, 1e-3,
                   "absolute; it rests after 40 s", 1.0);
    report.compare("way of the light end from the eye [m]" + at_step(step), {0.0},
                   {w.pose(a).position.norm()}, 0.03 * kLeft,
                   "absolute; 2 % of its part is left, and a step's way", 1.0);
}

/// Check a line with six turns about a bollard, e^{μθ} = 1e7, and 0.8 of the load that it can hold.
void report_bollard(Report& report, double step) {
    constexpr double kLight = 0.5, kRatio = 1e7, kTurns = 6.0, kHeavy = 0.8 * kRatio * kLight;
    World w(WorldDef{.step = step});
    const BodyId post = w.add_body({.kind = BodyKind::fixed});
    const auto lump = [&](double x, double mass) {
        return w.add_body({.kind = BodyKind::lump,
                           .position = {x, 0, -5.0},
                           .mass = mass,
                           .linear_damping = Vec3::Constant(0.3 * mass)});
    };
    const BodyId a = lump(-0.5, kLight), b = lump(0.5, kHeavy);
    w.add(RouteDef{.EA = 200.0 * kHeavy * kGravity,
                   .first = {.body = a},
                   .places = {{.body = post,
                               .radius = 0.5,
                               .friction = std::log(kRatio) / (kPi * (2.0 * kTurns + 1.0)),
                               .turns = static_cast<int>(kTurns)}},
                   .last = {.body = b},
                   .tension = kGravity * kLight,
                   .damping_time = 0.3});
    run_for(w, 15.0);
    const double before = w.pose(b).position.z();
    run_for(w, 15.0);
    report.compare("way of a load on a bollard, e^(mu theta) = 1e7, 15 s [m]" + at_step(step),
                   {0.0}, {w.pose(b).position.z() - before}, 1e-4, "absolute; it is held", 1.0);
}

/// Check a wire that runs horizontally to the top of a wheel at the origin, and down behind it.
/// @return True if a guide of this radius is rejected by a message that names the other side.
bool refuses_side(double radius) {
    World w;
    const BodyId deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
    const BodyId load =
        w.add_body({.kind = BodyKind::lump, .position = {1, 0, -13}, .mass = 1000.0});
    WireDef def{.name = "wire", .from = deck, .from_point = {-12, 0, 1}, .to = load};
    def.elements = 5;
    def.EA = 1e8;
    def.mass_per_length = 10.0;
    def.consistent_mass = true;
    def.path = {Vec3(-7, 0, 1), Vec3(-2, 0, 1), Vec3(1, 0, -3), Vec3(1, 0, -8)};
    const WireId wire = w.wires().add(def);
    try {
        (void)w.add(GuideDef{
            .name = "roller", .wire = wire, .body = deck, .axis = {0, 1, 0}, .radius = radius});
    } catch (const DefError& error) {
        return std::string(error.what()).find("other side") != std::string::npos;
    }
    return false;
}

}  // namespace

void case_first_winches(Report& report) {
    for (const double step : kWinchSteps) {
        report_power(report, step);
        report_drum(report, step);
    }
}

void case_first_routes(Report& report) {
    for (const double step : kWinchSteps) {
        report_eye(report, step);
        report_bollard(report, step);
    }
    report.compare("guides refused: wire on its side, on the other side", {0.0, 1.0},
                   {refuses_side(1.0) ? 1.0 : 0.0, refuses_side(-1.0) ? 1.0 : 0.0}, 0.0, "counts");
}

}  // namespace hawser::validate
