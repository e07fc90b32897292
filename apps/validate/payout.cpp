// SPDX-License-Identifier: Apache-2.0
// A winch lowers an anchor and hauls it up again. Checked: the tension at the fairlead, also when
// nodes are added and removed, and the account of wire.
#include "validate/payout.h"
#include "validate/wires.h"

#include <hawser/wire.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::validate {
namespace {

using namespace payout;

constexpr double kSpeed = 1.0;  // m/s

/// An anchor on a few elements of wire below a winch.
struct Lowering {
    World w{WorldDef{.step = kStep}};
    WireId wire;
    WinchIds ids;

    Lowering(double element, double damping, int end) {
        constexpr int kElements = 2;
        const BodyId deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
        BodyDef anchor{.name = "anchor", .kind = BodyKind::lump};
        // Nodes carry half of the adjacent elements; the anchor carries half of the last element.
        anchor.mass = kTowAnchorMass + 0.5 * kLineMass * element;
        const double stretched = element * (1.0 + anchor.mass * kGravity / kLineEA);
        anchor.position = Vec3(0, 0, -kElements * stretched);
        WireDef def = trial_line(kElements, element, damping);
        def.to = w.add_body(anchor);
        def.from = deck;
        if (end == 1) std::swap(def.from, def.to);
        wire = w.wires().add(def);
        ids = w.add(trial_winch(wire, end));
    }
    [[nodiscard]] double get(const char* signal) const {
        return w.system_signal(std::string("winch.") + signal);
    }
    /// Return the length of wire paid out [m], from the masses of its elements and from the length
    /// that the winch reports.
    [[nodiscard]] double length_out() const {
        double sum = get("at_drum");
        for (const InteractionId id : w.wires().elements(wire))
            if (id != ids.line) sum += w.interaction_def(id).get("mass") / kLineMass;
        return sum;
    }
};

struct Lowered : Changes {
    double error = 0.0;    ///< Relative error of the tension at the fairlead at constant speed.
    double account = 0.0;  ///< Error of the sum of wire on the drum and off it [m].
    int edits = 0, nodes = 0;
    Grade grade = Grade::good;
};

/// Lower an anchor by `way`, wait, and haul it up again.
Lowered lower_and_haul(double way, double element, double damping, int end) {
    Lowering d(element, damping, end);
    Lowered r;
    const double even = way / kSpeed - kRampSeconds, wait = 5.0,
                 once = even + 2.0 * kRampSeconds + wait;
    const auto speed = [&](double t) { return kSpeed * speed_at(t, even); };
    const double whole = kPayoutStored + d.length_out();
    const long steps = std::lround(2.0 * once / kStep);
    std::vector<double> pull;
    std::vector<std::size_t> edits;
    std::size_t nodes = d.w.wires().nodes(d.wire).size();
    for (long i = 0; i < steps; ++i) {
        const double t = static_cast<double>(i) * kStep;
        d.w.set_system_signal("winch.speed", t < once ? speed(t) : -speed(t - once));
        const double out = d.length_out();
        advance(d.w, 1);
        // The winch's value is that at the beginning of the step.
        const double now = d.get("pull");
        pull.push_back(now);
        if (d.w.wires().nodes(d.wire).size() != nodes) edits.push_back(pull.size());
        nodes = d.w.wires().nodes(d.wire).size();
        r.nodes = std::max(r.nodes, static_cast<int>(nodes));
        r.account = std::max(r.account, std::abs(d.length_out() + d.get("wire_left") - whole));
        const double ramps = std::fmod(t, once);
        const bool steady = ramps > kRampSeconds + 2.0 && ramps < even + kRampSeconds;
        const double weight = kGravity * (kTowAnchorMass + kLineMass * out);
        if (steady) r.error = std::max(r.error, std::abs(now / weight - 1.0));
    }
    r.edits = static_cast<int>(edits.size());
    static_cast<Changes&>(r) = largest_changes(pull, edits);
    r.grade = d.w.verdict().grade;
    return r;
}

void check(Report& report, double way, double element, double damping, int end = 0) {
    const Lowered r = lower_and_haul(way, element, damping, end);
    const std::string what =
        fmt::format("{:g} m, elements of {:g} m, {}{}", way, element,
                    std::isnan(damping) ? "default damping" : fmt::format("damping {:g}", damping),
                    end == 0 ? "" : ", last end");
    report.compare("tension at the fairlead over weight, " + what, {0.0}, {r.error}, 5e-4,
                   "W + rho g L", 1.0);
    report.compare("change a step at nodes, above others [N], " + what, {0.0},
                   {std::max(0.0, r.at_edits - r.elsewhere)}, 1.0, "max(0.1 %, 150 N)",
                   std::max(1e-3 * r.tension, 150.0));
    report.compare("wire on the drum and off it [m], " + what, {0.0}, {r.account}, 1e-9,
                   "an account", 1.0);
    const int expected = 2 * static_cast<int>(std::lround(way / element));
    report.compare("nodes that came and went, " + what, {static_cast<double>(expected)},
                   {static_cast<double>(r.edits)}, 4.0, "one an element", 1.0);
    report.compare("grade, " + what, {static_cast<double>(Grade::good)},
                   {static_cast<double>(r.grade)}, 0.0, "judged good", 1.0);
}

}  // namespace

void case_payout(Report& report) {
    for (const double element : {5.0, 20.0})
        for (const double damping : {0.0, 0.1, 1.0, kDefault})
            check(report, 600.0, element, damping);
    check(report, 600.0, 12.0, 0.5, 1);
    check(report, 1000.0, 20.0, 0.3);
    check_roller(report);
}

}  // namespace hawser::validate
