// SPDX-License-Identifier: Apache-2.0
// Winches: layers, brake, constant tension, release and ends of wire against closed forms.
#include "validate/cases.h"
#include "validate/tools.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace hawser::validate {
namespace {

constexpr double kWinchStep = 1.0 / 240.0;
// A drum of 1.2 m by 2.4 m with wire of 76 mm and 25 kg/m: 31 wraps a layer.
constexpr double kCoreRadius = 0.6, kWidth = 2.4, kWire = 0.076, kMass = 25.0, kStored = 1500.0;
constexpr double kDrumInertia = 4e4;  // Inertia of the drum [kg m²]
constexpr double kWinchEA = 3e8;      // Axial stiffness of the wire [N]
constexpr int kWrapsPerLayer = 31;

WinchDef anchor_winch() {
    return {.name = "winch",
            .core_radius = kCoreRadius,
            .width = kWidth,
            .flange_radius = 1.4,
            .wire_diameter = kWire,
            .mass_per_length = kMass,
            .stored = kStored,
            .inertia = kDrumInertia};
}

/// A winch on a fixed deck, and 40 m of wire with a node in the middle to an end with prescribed
/// motion.
class Deck {
  public:
    World w{WorldDef{.step = kWinchStep, .gravity = Vec3::Zero()}};
    WinchIds ids;

    explicit Deck(WinchDef def) {
        const BodyId deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
        end_ = w.add_body({.name = "end", .kind = BodyKind::kinematic, .position = {40, 0, 0}});
        def.wire = w.wires().add({.name = "wire",
                                  .from = deck,
                                  .to = end_,
                                  .elements = 2,
                                  .EA = kWinchEA,
                                  .mass_per_length = kMass,
                                  .axial_damping = 5.0});
        wire_ = def.wire;
        ids = w.add(def);
    }
    void step(double speed) {
        Twist t;
        t.linear.x() = speed;
        w.set_velocity(end_, t);
        advance(w, 1);
    }
    void run(double seconds, double speed) {
        for (long i = std::lround(seconds / kWinchStep); i > 0; --i) step(speed);
    }
    [[nodiscard]] double get(const char* signal) const {
        return w.system_signal(std::string("winch.") + signal);
    }
    void set(const char* signal, double value) {
        w.set_system_signal(std::string("winch.") + signal, value);
    }
    [[nodiscard]] double pull() const { return tension(w, ids.line); }
    [[nodiscard]] double turned() const { return w.pose(ids.drum).position.x(); }
    [[nodiscard]] double count(EventKind kind) const {
        return static_cast<double>(w.events().extremes(kind).count);
    }

  private:
    BodyId end_;
    WireId wire_;
};

/// Return the radius of layer k, 1 is the innermost.
double layer_radius(int k) { return kCoreRadius + kWire / 2.0 + kWire * (k - 1); }

void report_layers(Report& report) {
    // Sums in closed form: Σ k = 36, Σ r, Σ r³ over the eight full layers.
    double full = 0.0, inertia = 0.0;
    const double torus = 0.75 * kWire * kWire / 4.0;
    for (int k = 1; k <= 8; ++k) {
        const double turns = 2.0 * kPi * kWrapsPerLayer * layer_radius(k);
        full += turns;
        inertia += kMass * turns * (layer_radius(k) * layer_radius(k) + torus);
    }
    const double rest = kStored - full, r9 = layer_radius(9);
    inertia += kMass * rest * (r9 * r9 + torus) + kDrumInertia;
    const double wraps = 8.0 * kWrapsPerLayer + rest / (2.0 * kPi * r9);
    WinchDef def = anchor_winch();
    def.mode = WinchMode::tension;
    def.tension = 1e5;
    Deck d(def);
    d.step(0.0);
    report.compare("layers of 1,500 m", {9.0}, {d.get("layer")}, 0.0, "a count");
    report.compare("wraps on the drum", {wraps}, {d.get("wraps")}, 1e-6, "relative; closed sums");
    report.compare("inertia of drum and wire [kg m^2]", {inertia}, {d.get("inertia")}, 1e-6,
                   "relative; rings of round wire");
    // 100 m off: to the eighth layer.
    d.run(50.0, 2.0);
    const double off = kStored - d.get("wire_left");
    report.compare("turns by which the wire came off [rad]",
                   {rest / r9 + (off - rest) / layer_radius(8)},
                   {d.turned() - d.w.velocity(d.ids.drum).linear.x() * kWinchStep}, 1e-4,
                   "relative; a layer ends within a step");
}

void report_winch_pull(Report& report) {
    std::vector<double> expected, measured;
    for (int k : {1, 5, 9}) {
        WinchDef def = anchor_winch();
        double below = 0.0;
        for (int i = 1; i < k; ++i) below += 2.0 * kPi * kWrapsPerLayer * layer_radius(i);
        def.stored = below + 80.0;
        def.mode = WinchMode::speed;
        def.speed = -0.1;
        def.torque_haul = 5e5;
        Deck d(def);
        d.run(40.0, 0.0);
        measured.push_back(d.pull());
        expected.push_back(measured.front() * layer_radius(1) / layer_radius(k));
    }
    report.compare("stall pull in layers 1, 5 and 9 [N]", expected, measured, 1e-4,
                   "relative; torque over radius: r1/rk");
    report.compare("stall torque [N m]", {5e5}, {measured.front() * layer_radius(1)}, 1e-4,
                   "relative");
}

void report_brake(Report& report) {
    constexpr double kFriction = 0.3, kAngle = 4.0;
    WinchDef def = anchor_winch();
    def.brake_static = 1.2e6;
    def.brake_dynamic = 1.0e6;
    def.band_friction = kFriction;
    def.band_angle = kAngle;
    Deck d(def);
    double work = 0.0, held = 0.0;
    for (long i = 0; i < std::lround(20.0 / kWinchStep); ++i) {
        const double angle = d.turned();
        d.step(0.5);
        work += d.pull() * d.get("radius") * (d.turned() - angle);
        held = std::max(held, std::abs(d.w.force(d.ids.brake)[0]));
    }
    const double out = std::abs(d.w.force(d.ids.brake)[0]), pull = d.pull();
    const double omega = d.w.velocity(d.ids.drum).linear.x();
    const double kept = 0.5 * d.get("inertia") * omega * omega;
    d.step(0.0);  // the account includes the previous step
    report.compare("torque at which the brake slips [N m]", {1.2e6}, {held}, 1e-9, "relative");
    // Wire of the unstretched length 40 m + slip reaches over 50 m.
    report.compare("way that slipped over 10 m [m]", {50.0 / (1.0 + pull / kWinchEA) - 40.0},
                   {d.get("slip")}, 1e-3, "relative; less the stretch");
    report.compare("heat [J]", {work - kept}, {d.get("heat")}, 1e-3,
                   "relative; work of the wire on the drum less J/2 omega^2");
    // Wire that is slack, and an engine that turns the drum in against the brake.
    d.run(4.0, -5.0);
    d.w.set_force(d.ids.drum, {-2e6, 0, 0}, Vec3::Zero());
    d.run(1.0, -5.0);
    report.compare("torque out over torque in", {std::exp(kFriction * kAngle)},
                   {out / std::abs(d.w.force(d.ids.brake)[0])}, 1e-9, "relative; e^(mu angle)");
}

void report_constant_tension(Report& report) {
    constexpr double kSet = 4e5, kHeave = 2.0, kRate = 2.0 * kPi / 8.0;
    WinchDef def = anchor_winch();
    def.mode = WinchMode::tension;
    def.tension = kSet;
    def.max_speed = 4.0;
    Deck d(def);
    double worst = 0.0;
    for (long i = 0; i < std::lround(32.0 / kWinchStep); ++i) {
        // The velocity of a step is that of its middle.
        const double middle = d.w.time() + 0.5 * kWinchStep;
        d.step(kHeave * kRate * std::sin(kRate * middle));
        if (d.w.time() < 8.0) continue;
        const double r = d.get("radius");
        const double a = kHeave * kRate * kRate * std::cos(kRate * (d.w.time() - kWinchStep));
        const double expected = kSet + d.get("inertia") / (r * r) * a;
        worst = std::max(worst, std::abs(d.pull() - expected) / expected);
    }
    report.compare("tension less T + J/r^2 a, heave 2 m in 8 s, worst", {0.0}, {worst}, 1e-2,
                   "relative", 1.0);
}

void report_release(Report& report) {
    WinchDef def = anchor_winch();
    def.brake_static = 5e6;
    def.release_delay = 2.0;
    def.release_load = 2e4;
    Deck d(def);
    d.run(3.0, 0.1);
    d.run(2.0, 0.0);
    const double design = d.pull(), asked = d.w.time();
    d.set("mode", static_cast<double>(WinchMode::release));
    d.run(1.99, 0.0);
    report.compare("tension just before the release [N]", {design}, {d.pull()}, 1e-3, "relative");
    while (d.pull() > 0.05 * design && d.w.time() < asked + 10.0) d.step(0.0);
    const double release_time = d.w.time() - asked;
    report.compare("release at design load after 2 to 3 s [s]", {2.5}, {release_time}, 0.5,
                   "LR Rules for Ships, Pt 7 Ch 16, 3.2: within 3 s", 1.0);
    d.run(30.0, 0.5);
    double mean = 0.0;
    for (int i = 0; i < 2400; ++i) {
        d.step(0.5);
        mean += d.pull() / 2400.0;
    }
    report.compare("tension that is left [N]", {2e4}, {mean}, 1e-2, "relative");
}

void report_ends(Report& report) {
    for (const double link : {0.0, 3e5}) {
        WinchDef def = anchor_winch();
        def.stored = 6.0;
        def.mode = WinchMode::free;
        def.weak_link = link;
        Deck d(def);
        d.run(90.0, 0.1);
        report.compare(link > 0.0 ? "empty, weak link, lines broke: events with a weak link"
                                  : "empty, weak link, lines broke: events without",
                       {1.0, link > 0.0 ? 1.0 : 0.0, 1.0},
                       {d.count(EventKind::drum_empty), d.count(EventKind::weak_link),
                        d.count(EventKind::line_break)},
                       0.0, "counts");
    }
}

}  // namespace

void case_winches(Report& report) {
    report_layers(report);
    report_winch_pull(report);
    report_brake(report);
    report_constant_tension(report);
    report_release(report);
    report_ends(report);
    report_winch_limits(report);
}

}  // namespace hawser::validate
