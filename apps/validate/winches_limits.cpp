// SPDX-License-Identifier: Apache-2.0
// Limits of winches and wires with random numbers of a fixed seed: chain that jumps, weak links,
// drums and lockers that become empty.
#include "validate/cases.h"
#include "validate/tools.h"
#include "validate/uniform.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace hawser::validate {
namespace {

constexpr int kRandomCases = 20;
constexpr double kLimitStep = 1.0 / 240.0;

/// A winch at the origin, and a wire down to an end that is drawn away.
class Pull {
  public:
    World w;
    WinchIds ids;
    double length, EA;

    Pull(WinchDef def, double stiffness, double gravity, double step, double below)
        : w(WorldDef{.step = step, .gravity = Vec3(0, 0, -gravity)}),
          length(below),
          EA(stiffness),
          winch_(def.name) {
        const BodyId deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
        end_ = w.add_body({.name = "end", .kind = BodyKind::kinematic, .position = {0, 0, -below}});
        def.wire = w.wires().add({.name = "wire",
                                  .from = deck,
                                  .to = end_,
                                  .elements = 3,
                                  .EA = stiffness,
                                  .mass_per_length = def.mass_per_length,
                                  .axial_damping = 2.0});
        ids = w.add(def);
    }
    void step(double speed) {
        Twist t;
        t.linear.z() = -speed;
        w.set_velocity(end_, t);
        advance(w, 1);
    }
    /// Return the speed of the wire's end at which the tension rises at `rate` [N/s].
    [[nodiscard]] double speed_for(double rate) const { return rate * length / EA; }
    [[nodiscard]] double get(const char* signal) const {
        return w.system_signal(winch_ + "." + signal);
    }
    [[nodiscard]] std::int64_t count(EventKind kind) const {
        return w.events().extremes(kind).count;
    }
    [[nodiscard]] double value(EventKind kind) const {
        return w.events().extremes(kind).first.value;
    }

  private:
    BodyId end_;
    std::string winch_;
};

WinchDef random_windlass(Uniform& random, ChainProperties& chain) {
    const double bar = random(0.03, 0.15);
    chain = chain_properties(bar, random(0.0, 1.0) < 0.5);
    WinchDef def{.name = "windlass"};
    // Chain of grade R3 breaks at about 8.5e8 d².
    def.gypsy = {.pockets = random.whole(4, 8),
                 .jump_load = random(0.05, 0.5) * 8.5e8 * bar * bar,
                 .locker_fall = random(0.0, 30.0)};
    def.wire_diameter = bar;
    def.mass_per_length = chain.mass_per_length;
    def.stored = random(50.0, 300.0);
    def.inertia = random(1e3, 1e5);
    def.brake_static = 10.0 * def.gypsy.jump_load * gypsy_radius(def);
    return def;
}

void report_jumps(Report& report) {
    Uniform random(1);
    double worst = 0.0, whole = 0.0, early = 0.0, jumped = 0.0;
    for (int i = 0; i < kRandomCases; ++i) {
        ChainProperties chain{};
        const WinchDef def = random_windlass(random, chain);
        const double load = def.gypsy.jump_load;
        Pull p(def, chain.EA, kGravity, i % 2 == 0 ? kLimitStep : 4.0 * kLimitStep,
               random(20.0, 200.0));
        const double slow = p.speed_for(0.1 * load);  // over ten seconds
        double most = 0.0;
        while (p.count(EventKind::chain_jump) == 0 && p.w.time() < 30.0) {
            most = std::max(most, p.get("pull") - p.get("tail"));
            p.step(slow);
        }
        worst = std::max(worst, std::abs(most / load - 1.0));
        early += most < 0.99 * load ? 1.0 : 0.0;
        jumped += p.count(EventKind::chain_jump) > 0 ? 1.0 : 0.0;
        // Let the chain jump over some pockets until it is held again.
        const double pocket = 8.0 * def.wire_diameter;
        for (long n = 0; n < 200'000 && p.get("jumped") < 2.5 * pocket; ++n) p.step(slow);
        for (long n = 0; n < 200'000 && p.get("state") == 10.0; ++n) p.step(slow);
        const double pockets = p.get("jumped") / pocket;
        whole = std::max(whole, std::abs(pockets - std::round(pockets)));
    }
    report.compare("load at which chain jumps over jump_load, 20 random gypsies, worst", {0.0},
                   {worst}, 1e-2, "relative; load sweep of 0.1 jump_load/s", 1.0);
    report.compare("jumps, and jumps below 0.99 of the load", {kRandomCases, 0.0}, {jumped, early},
                   0.0, "counts");
    report.compare("pockets jumped by, away from a whole number", {0.0}, {whole}, 1e-4,
                   "of a pocket", 1.0);
}

WinchDef random_winch(Uniform& random) {
    WinchDef def{.name = "winch",
                 .core_radius = random(0.3, 0.8),
                 .width = 1.5,
                 .wire_diameter = random(0.03, 0.08)};
    def.mass_per_length = 4000.0 * def.wire_diameter * def.wire_diameter;
    def.inertia = random(1e3, 4e4);
    def.brake_static = 1e8;
    return def;
}

/// Check the holding force of the fastening of a wire. At the wire it is the strength of the weak
/// link times e^(2πμn) behind n wraps.
void report_weak_links(Report& report) {
    Uniform random(2);
    double worst = 0.0, links = 0.0, parted = 0.0;
    for (int i = 0; i < kRandomCases; ++i) {
        WinchDef def = random_winch(random);
        const double wraps = random(0.05, 1.5);
        def.wrap_friction = random(0.05, 0.2);
        def.weak_link = random(5e4, 3e5);
        def.stored = wraps * 2.0 * kPi * (def.core_radius + 0.5 * def.wire_diameter);
        const double expected = def.weak_link * std::exp(2.0 * kPi * def.wrap_friction * wraps);
        Pull p(def, 3e8, 0.0, kLimitStep, random(20.0, 100.0));
        const double slow = p.speed_for(0.1 * expected);
        double most = 0.0;
        while (p.count(EventKind::weak_link) == 0 && p.w.time() < 30.0) {
            p.step(slow);
            most = std::max(most, tension(p.w, p.ids.line));
        }
        worst = std::max(worst, std::abs(most / expected - 1.0));
        for (int n = 0; n < 960; ++n) p.step(slow);
        links += static_cast<double>(p.count(EventKind::weak_link));
        parted += static_cast<double>(p.count(EventKind::line_break));
    }
    report.compare("tension at which a weak link parts over link e^(2 pi mu n), 20 random, worst",
                   {0.0}, {worst}, 1e-2, "relative; found after the step", 1.0);
    report.compare("weak links and lines broke, of 20", {kRandomCases, kRandomCases},
                   {links, parted}, 0.0, "counts: once each");
}

/// Results of a drum that becomes empty.
struct Emptied {
    double empty = 0.0, links = 0.0, intact = 0.0;  ///< Counts.
    double value = 0.0;                             ///< Tension at which the fastening broke [N].
    double crept = 0.0;                             ///< Beyond the end [m].
};

Emptied run_empty(const WinchDef& def, double EA, double up_to) {
    Pull p(def, EA, 0.0, kLimitStep, 40.0);
    // Run slowly at the end: a rotating drum meets the end with v sqrt(k J)/r, which would exceed
    // the load sweep.
    const double slow = p.speed_for(1e5);
    while (p.count(EventKind::drum_empty) == 0 && p.w.time() < 400.0) {
        const double left = p.get("wire_left");
        p.step(left > 0.5 ? 0.1 : left > 0.01 ? 0.01 : 0.001);
    }
    double most = 0.0;
    for (long n = 0; n < 20'000 && most < up_to && p.w.intact(p.ids.line); ++n) {
        p.step(slow);
        most = std::max(most, tension(p.w, p.ids.line));
    }
    return {static_cast<double>(p.count(EventKind::drum_empty)),
            static_cast<double>(p.count(EventKind::weak_link)), p.w.intact(p.ids.line) ? 1.0 : 0.0,
            p.value(EventKind::weak_link), std::max(0.0, -p.get("wire_left"))};
}

void report_empty(Report& report, bool gypsy) {
    Uniform random(gypsy ? 4 : 3);
    Emptied none, strong, weak;
    double worst = 0.0, crept = 0.0;
    constexpr int kCasesOfKind = kRandomCases / 2;
    for (int i = 0; i < kCasesOfKind; ++i) {
        ChainProperties chain{};
        WinchDef def = gypsy ? random_windlass(random, chain) : random_winch(random);
        const double EA = gypsy ? chain.EA : 3e8;
        def.stored = random(2.0, 8.0);
        def.brake_static = 1e4;  // it slips, and stops the drum
        def.gypsy.locker_fall = gypsy ? random(0.5, 5.0) : 0.0;
        const double link = random(1e5, gypsy ? 0.8 * def.gypsy.jump_load + 1e5 : 6e5);
        if (gypsy) def.gypsy.jump_load = 2.0 * link + 1e6;
        const auto add = [&](Emptied& to, double load, double up_to) {
            def.weak_link = load;
            const Emptied e = run_empty(def, EA, up_to);
            to.empty += e.empty;
            to.links += e.links;
            to.intact += e.intact;
            return e;
        };
        (void)add(none, 0.0, link);
        // Chain stretches between the wheel and its end.
        const double moves = gypsy ? def.gypsy.wrap * gypsy_radius(def) + def.gypsy.locker_fall : 0;
        const double beyond = add(strong, link, 0.95 * link).crept;
        crept = std::max(crept, std::abs(beyond - 0.95 * link * moves / EA));
        // The brake carries a part of the load in addition to the bitter end.
        worst = std::max(worst, std::abs(add(weak, link, 1.1 * link + 2e5).value / link - 1.0));
    }
    const char* what = gypsy ? "lockers" : "drums";
    const auto reported = [&](const char* how) {
        return fmt::format("{} {}: empty, weak link, wire held; of 10", what, how);
    };
    report.compare(reported("without a weak link"), {kCasesOfKind, 0.0, 0.0},
                   {none.empty, none.links, none.intact}, 0.0, "counts: lets go");
    report.compare(reported("below its load"), {kCasesOfKind, 0.0, kCasesOfKind},
                   {strong.empty, strong.links, strong.intact}, 0.0, "counts: holds");
    report.compare(reported("above its load"), {kCasesOfKind, kCasesOfKind, 0.0},
                   {weak.empty, weak.links, weak.intact}, 0.0, "counts: parts once");
    report.compare(fmt::format("load at which the fastening of {} parts, worst", what), {0.0},
                   {worst}, 1e-2, "relative; found after the step", 1.0);
    report.compare(fmt::format("way past the end of {} less its stretch [m], worst", what), {0.0},
                   {crept}, 1e-3, "of 2 to 8 m; the brake has a share", 1.0);
}

}  // namespace

void report_winch_limits(Report& report) {
    report_jumps(report);
    report_weak_links(report);
    report_empty(report, false);
    report_empty(report, true);
    report_joined_wires(report);
}

}  // namespace hawser::validate
