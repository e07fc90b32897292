// SPDX-License-Identifier: Apache-2.0
// A tug pays out its tow line over the stern roller. The wire stays on the roller and does not
// break. At constant speed the tension of the line equals the thrust minus the tug's drag.
#include "validate/tools.h"
#include "validate/wires.h"

#include <hawser/timeline.h>
#include <hawser/wire.h>

#include <algorithm>
#include <cmath>

namespace hawser::validate {
namespace {

constexpr double kFrameSeconds = 1.0 / 60.0;
constexpr double kEvaluatedSeconds = 60.0;  ///< Duration of the evaluated end of the run [s].

/// Return the tension of the first element astern of the roller [N].
double tension_outboard(const World& w, WireId wire, BodyId roller) {
    const auto nodes = w.wires().nodes(wire);
    const auto elements = w.wires().elements(wire);
    const double x = w.pose(roller).position.x();
    for (std::size_t k = 1; k < elements.size(); ++k)
        if (w.pose(nodes[k]).position.x() < x) return -w.force(elements[k])[0];
    return 0.0;
}

}  // namespace

void case_tow_payout(Report& report) {
    scene::Scene s = open_scene("tow_payout", kFrameSeconds);
    World& w = s.world;
    const WireId wire = w.wires().find("tow");
    const BodyId tug = w.find_body("tug"), roller = w.find_body("roller");
    const BodyDef def = w.body_def(tug);  // adding nodes moves definitions
    const double begun = w.wires().length(wire);
    const auto steps = static_cast<long>(std::lround(s.duration / kFrameSeconds));
    std::size_t next = 0;
    std::int32_t least = 1000;
    double pull = 0.0, drag = 0.0, largest = 0.0;
    long settled = 0;
    for (long i = 0; i < steps; ++i) {
        for (; next < s.timeline.size() && s.timeline[next].at <= w.time() + 1e-9; ++next)
            scene::perform(s.timeline[next], w);
        advance(w, 1);
        std::int32_t on_roller = 0;
        for (const ContactView& c : w.contacts()) on_roller += c.force.norm() > 0.0 ? 1 : 0;
        least = std::min(least, on_roller);
        const double now = tension_outboard(w, wire, roller);
        largest = std::max(largest, now);
        if (w.time() < s.duration - kEvaluatedSeconds) continue;
        pull += now;
        drag += def.linear_damping.x() * w.velocity(tug).linear.x();
        ++settled;
    }
    pull /= static_cast<double>(settled);
    drag /= static_cast<double>(settled);
    report.compare("contacts that press on the roller, at least 1", {0.0},
                   {static_cast<double>(std::min(0, least - 1))}, 0.0, "in every step", 1.0);
    report.compare("lines that broke", {0.0},
                   {static_cast<double>(w.events().extremes(EventKind::line_break).count)}, 0.0,
                   "far below the breaking load", 1.0);
    report.compare("wire paid out [m]", {50.0}, {w.wires().length(wire) - begun}, 0.02,
                   "1 m/s for 50 s, less what the motor takes to speed up and the brake to stop");
    report.compare("tension astern of the roller, the last minute [N]", {def.force.x() - drag},
                   {pull}, 0.02,
                   "thrust less drag; the line leaves at a slope, and all still sways");
    report.compare("grade", {static_cast<double>(Grade::good)},
                   {static_cast<double>(w.verdict().grade)}, 0.0, "judged good", 1.0);
}

}  // namespace hawser::validate
