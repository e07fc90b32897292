// SPDX-License-Identifier: Apache-2.0
// A winch lowers an anchor over a roller and hauls it up again. Checked: the ratio of the tensions
// at the roller, their changes when nodes pass, and the account of wire.
#include "validate/payout.h"
#include "validate/wires.h"

#include <hawser/guide.h>
#include <hawser/wire.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace hawser::validate {
namespace {

using namespace payout;

constexpr double kRollerRadius = 1.0, kFriction = 0.2;  // m, 1
constexpr double kDeckLength = 40.0;                    // From the winch to the roller, about [m].

/// Wire from a winch along a deck, over a roller and down to an anchor.
struct OverRoller {
    World w{WorldDef{.step = kStep}};
    WireId wire;
    Guide roller;

    OverRoller(double element, double damping) {
        const BodyId deck = w.add_body({.name = "deck", .kind = BodyKind::fixed});
        // The element that passes the roller has two fifths of itself on the deck. All have the
        // tension of the anchor's weight.
        const double stretched = element * (1.0 + kTowAnchorMass * kGravity / kLineEA);
        const double over = 0.4 * element;
        std::vector<Vec3> path;
        for (long k = std::lround(kDeckLength / element); k >= 0; --k)
            path.push_back({-over - static_cast<double>(k) * stretched, 0, kRollerRadius});
        const double first = stretched - over - 0.5 * kPi * kRollerRadius;
        for (int k = 0; k < 3; ++k) path.push_back({kRollerRadius, 0, -first - k * stretched});
        BodyDef anchor{.name = "anchor", .kind = BodyKind::lump, .position = path.back()};
        anchor.mass = kTowAnchorMass + 0.5 * kLineMass * element;
        WireDef def = trial_line(static_cast<int>(path.size()) - 1, element, damping);
        def.from = deck;
        def.from_point = path.front();
        def.to = w.add_body(anchor);
        def.path.assign(path.begin() + 1, path.end() - 1);
        wire = w.wires().add(def);
        roller = w.add(GuideDef{.name = "roller",
                                .wire = wire,
                                .body = deck,
                                .radius = kRollerRadius,
                                .friction = kFriction});
        (void)w.add(trial_winch(wire));
    }
    [[nodiscard]] double get(const std::string& signal) const { return w.system_signal(signal); }
    /// Return the length of wire paid out [m], from the masses of its nodes and from the lengths
    /// that winch and guide report.
    [[nodiscard]] double length_out() const {
        double sum = get("winch.at_drum") + get("roller.wire_before") + get("roller.wire_behind");
        for (const BodyId id : w.wires().nodes(wire))
            if (w.body_def(id).kind == BodyKind::lump) sum += w.body_def(id).mass / kLineMass;
        return sum;
    }
};

struct RollerRun : Changes {
    double ratio = 0.0;    ///< Error of the ratio of tensions at even speed, relative.
    double account = 0.0;  ///< Error of the sum of wire on the drum and off it [m].
    Grade grade = Grade::good;
};

/// Lower an anchor by `way` at `speed`, wait, and haul it up again.
RollerRun lower_over_roller(double way, double speed, double element, double damping) {
    OverRoller d(element, damping);
    RollerRun r;
    const double even = way / speed - kRampSeconds, wait = 5.0,
                 once = even + 2.0 * kRampSeconds + wait;
    const auto wanted = [&](double t) { return speed * speed_at(t, even); };
    const double whole = kPayoutStored + d.length_out();
    const long steps = std::lround(2.0 * once / kStep);
    std::vector<double> pull;
    std::vector<std::size_t> edits;
    std::vector<BodyId> nodes;
    for (long i = 0; i < steps; ++i) {
        const double t = static_cast<double>(i) * kStep;
        d.w.set_system_signal("winch.speed", t < once ? wanted(t) : -wanted(t - once));
        advance(d.w, 1);
        const double before = d.get("roller.before"), behind = d.get("roller.behind");
        pull.push_back(before);
        const auto now = d.w.wires().nodes(d.wire);
        if (!std::equal(now.begin(), now.end(), nodes.begin(), nodes.end())) {
            edits.push_back(pull.size());
            nodes.assign(now.begin(), now.end());
        }
        r.account =
            std::max(r.account, std::abs(d.length_out() + d.get("winch.wire_left") - whole));
        const double part = std::fmod(t, once);
        if (part < kRampSeconds + 2.0 || part > even + kRampSeconds) continue;
        const double euler = std::exp(kFriction * d.get("roller.angle"));
        r.ratio = std::max(r.ratio,
                           std::abs((t < once ? behind / before : before / behind) / euler - 1.0));
    }
    static_cast<Changes&>(r) = largest_changes(pull, edits);
    r.grade = d.w.verdict().grade;
    return r;
}

}  // namespace

void check_roller(Report& report) {
    const auto check = [&](double element, double damping) {
        const RollerRun r = lower_over_roller(600.0, 1.0, element, damping);
        const std::string what = fmt::format(
            "over a roller, elements of {:g} m, {}", element,
            std::isnan(damping) ? "default damping" : fmt::format("damping {:g}", damping));
        report.compare("ratio of tensions over e^(mu theta), " + what, {0.0}, {r.ratio}, 5e-3,
                       "largest at even speed, out and in", 1.0);
        report.compare("change a step at nodes, above others [N], " + what, {0.0},
                       {std::max(0.0, r.at_edits - r.elsewhere)}, 1.0, "max(0.1 %, 150 N)",
                       std::max(1e-3 * r.tension, 150.0));
        report.compare("wire on the drum and off it [m], " + what, {0.0}, {r.account}, 1e-9,
                       "an account", 1.0);
        report.compare("grade, " + what, {static_cast<double>(Grade::good)},
                       {static_cast<double>(r.grade)}, 0.0, "judged good", 1.0);
    };
    for (const double element : {5.0, 20.0})
        for (const double damping : {0.0, 0.1, 1.0, kDefault}) check(element, damping);
}

}  // namespace hawser::validate
