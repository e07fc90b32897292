// SPDX-License-Identifier: Apache-2.0
// Heave compensation and overload protection of winches.
#include "validate/tools.h"
#include "validate/vessels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace hawser::validate {
namespace {

constexpr double kAidStep = 1.0 / 60.0;

WinchDef aided_winch(WireId wire) {
    return {.name = "winch",
            .wire = wire,
            .core_radius = 0.6,
            .width = 2.0,
            .wire_diameter = 0.05,
            .mass_per_length = 10.0,
            .element = 0.0,
            .stored = 600.0,
            .inertia = 2e4,
            .motor_inertia = 2e4,
            .brake_static = 5e6};
}

/// Return the heave amplitude of a load of 20 t below a ship that heaves by 1.5 m.
double load_heave(double frequency, WinchMode mode, double max_speed) {
    constexpr double kHeave = 1.5, kHigh = 60.0;
    World w{WorldDef{.step = kAidStep}};
    constexpr double kHoistShipMass = 5e6, kHungLoad = 20e3;
    const BodyId ship = w.add_body({.name = "ship",
                                    .position = {0, 0, kHigh},
                                    .mass = kHoistShipMass,
                                    .inertia = 1e9 * Mat3::Identity(),
                                    .gravity = false});
    const BodyId load = w.add_body(
        {.name = "load", .kind = BodyKind::lump, .position = {0, 0, 0}, .mass = kHungLoad});
    const WireId wire = w.wires().add({.name = "wire",
                                       .from = ship,
                                       .to = load,
                                       .elements = 1,
                                       .length = kHigh / (1.0 + kHungLoad * kGravity / 2e8),
                                       .EA = 2e8,
                                       .mass_per_length = 10.0});
    WinchDef def = aided_winch(wire);
    def.mode = mode;
    def.heave_speed = max_speed;
    w.add(def);
    double low = 1e300, high = -1e300;
    for (int i = 0; i < 120 * 60; ++i) {
        // Heave of s(t) A sin(ωt) with s from 0 to 1 in 20 s, whole periods, as a force on
        // the ship's mass.
        const double omega = 2.0 * kPi * frequency, t = w.time(), in = std::min(t / 20.0, 1.0);
        const double rate = t < 20.0 ? 1.0 / 20.0 : 0.0;
        const double acceleration = kHeave * (2.0 * rate * omega * std::cos(omega * t) -
                                              in * omega * omega * std::sin(omega * t));
        w.set_force(ship, {0, 0, kHoistShipMass * acceleration + kHungLoad * kGravity},
                    Vec3::Zero());
        advance(w, 1);
        if (w.time() < 60.0) continue;
        low = std::min(low, w.pose(load).position.z());
        high = std::max(high, w.pose(load).position.z());
    }
    return 0.5 * (high - low) / kHeave;
}

void report_heave(Report& report) {
    for (const double frequency : {0.05, 0.1, 0.2})
        report.compare(
            fmt::format("heave compensation, {:g} Hz: residual heave of the load [1]", frequency),
            {0.0}, {load_heave(frequency, WinchMode::heave, 4.0)}, frequency > 0.1 ? 0.1 : 0.02,
            "of the ship's heave", 1.0);
    const double held = load_heave(0.1, WinchMode::brake, 4.0);
    report.compare("brake, 0.1 Hz: heave of the load [1]", {1.0}, {held}, 0.1,
                   "it follows the ship");
    // 1.5 m at 0.1 Hz needs 0.94 m/s.
    const double slow = load_heave(0.1, WinchMode::heave, 0.3);
    report.compare("heave compensation limited to 0.3 m/s: residual heave is larger", {1.0},
                   {slow > 0.4 ? 1.0 : 0.0}, 0.0, "it lacks two thirds of the speed", 1.0);
}

/// A winch ashore holds a ship that surges and drifts off. @param slack  Initial slack of the wire
/// [m].
struct Overloaded {
    double worst = 0.0, out = 0.0, peak = 0.0;  ///< |T/limit − 1| while it pays out; [m], [N].
    bool parted = false;
};

Overloaded overload(WinchMode mode, double limit, double surge, double drift, double far = 300.0,
                    double slack = 0.0) {
    constexpr double kBreakingLoad = 1.3e6;
    World w{WorldDef{.step = kAidStep}};
    const BodyId shore = w.add_body({.name = "shore", .kind = BodyKind::fixed});
    constexpr double kHoistShipMass = 1e9;  // hardly moved by the wire [kg]
    const BodyId ship = w.add_body({.name = "ship",
                                    .position = {far, 0, 0},
                                    .velocity = {drift, 0, 0},
                                    .mass = kHoistShipMass,
                                    .inertia = 1e12 * Mat3::Identity(),
                                    .gravity = false});
    const WireId wire = w.wires().add({.name = "wire",
                                       .from = shore,
                                       .to = ship,
                                       .elements = 1,
                                       .length = far + slack,
                                       .EA = 1e8,
                                       .mass_per_length = 10.0,
                                       .breaking_load = kBreakingLoad});
    WinchDef def = aided_winch(wire);
    def.mode = mode;
    def.overload_limit = limit;
    w.add(def);
    Overloaded out;
    for (int i = 0; i < 100 * 60; ++i) {
        const double omega = 2.0 * kPi * 0.12;
        const double acceleration = surge * omega * omega * std::cos(omega * w.time());
        w.set_force(ship, {kHoistShipMass * acceleration, 0, 0}, Vec3::Zero());
        advance(w, 1);
        out.parted = out.parted || !w.intact(w.wires().elements(wire).front());
        const double pull = tension(w, w.wires().elements(wire).front());
        out.peak = std::max(out.peak, pull);
        if (limit > 0.0 && w.system_signal("winch.overload") > 0.5 &&
            w.system_signal("winch.wire_speed") > 0.02)
            out.worst = std::max(out.worst, std::abs(w.system_signal("winch.pull") / limit - 1.0));
    }
    if (limit > 0.0) out.out = w.system_signal("winch.overload_out");
    return out;
}

void report_overload(Report& report) {
    const Overloaded bare = overload(WinchMode::brake, 0.0, 2.0, 0.5);
    report.compare("no protection: the wire parts", {1.0}, {bare.parted ? 1.0 : 0.0}, 0.0,
                   "it does", 1.0);
    for (const WinchMode mode : {WinchMode::brake, WinchMode::speed})
        for (const double surge : {0.0, 2.0, 4.0}) {
            constexpr double kLimit = 1e6;
            const Overloaded held = overload(mode, kLimit, surge, 0.5);
            const std::string what =
                fmt::format("protection, mode {}, surge {:g} m",
                            winch_modes()[static_cast<std::size_t>(mode)], surge);
            report.compare(what + ": tension while it pays out over the limit, less 1", {0.0},
                           {held.worst}, 0.01, "of the limit", 1.0);
            report.compare(what + ": largest tension over the limit", {1.0}, {held.peak / kLimit},
                           0.01, "of the limit");
            report.compare(what + ": the wire parts", {0.0}, {held.parted ? 1.0 : 0.0}, 0.0, "no",
                           1.0);
            report.compare(what + ": it pays out", {1.0}, {held.out > 10.0 ? 1.0 : 0.0}, 0.0,
                           "what the ship moves", 1.0);
        }
}

/// Check a short wire that becomes taut at 4 m/s. Its tension rises by a tenth of the limit per
/// step.
void report_snatch(Report& report) {
    const Overloaded held = overload(WinchMode::brake, 1e6, 0.0, 4.0, 80.0, 3.0);
    report.compare("protection, a wire of 80 m comes taut at 4 m/s: it parts", {0.0},
                   {held.parted ? 1.0 : 0.0}, 0.0, "no", 1.0);
    report.compare("protection, a wire of 80 m comes taut at 4 m/s: largest tension over the limit",
                   {1.0}, {held.peak / 1e6}, 0.01, "of the limit");
}

}  // namespace

void case_vessel_winches(Report& report) {
    report_heave(report);
    report_overload(report);
    report_snatch(report);
}

}  // namespace hawser::validate
