// SPDX-License-Identifier: Apache-2.0
// Closed loops through singular poses, and light bodies between heavy ones.
#include "validate/light_links.h"
#include "validate/untuned.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace hawser::validate {
namespace {

/// Errors of a pendulum against the closed form, relative.
struct SwingErrors {
    double period = 0.0, amplitude = 0.0;
    bool good = true;  ///< The monitors found nothing.
};

SwingErrors swing(LightPendulum p, int periods) {
    constexpr double kAngle = LightPendulum::kAngle;
    const double step = p.world.settings().step;
    const double period =
        4.0 * std::sqrt(p.inertia / p.torque) * elliptic_k(std::sin(0.5 * kAngle));
    std::vector<double> angle{kAngle};
    const long steps = std::lround((periods + 0.6) * period / step);
    double last = 0.0;
    for (long k = 1; k <= steps; ++k) {
        advance(p.world, 1);
        angle.push_back(p.angle());
        if (k > steps - std::lround(period / step)) last = std::max(last, std::abs(angle.back()));
    }
    const std::vector<double> zeros = upward_zeros(angle, step);
    const double counted = static_cast<double>(zeros.size()) - 1.0;
    return {std::abs((zeros.back() - zeros.front()) / counted / period - 1.0),
            std::abs(last / kAngle - 1.0), p.world.verdict().grade == Grade::good};
}

}  // namespace

void case_singular_loops(Report& report) {
    for (const int windows : {1, 2, 4})
        for (const double step : {1.0 / 60.0, 1.0 / 70.0, 1.0 / 240.0}) {
            World w = make_windows(step, windows);
            advance(w, 1);
            const double start = w.energy().mechanical();
            double off = 0.0, exchanged = 0.0, good = 1.0;
            for (long k = std::lround(10.0 / step); k > 1; --k) {
                advance(w, 1);
                const Energy e = w.energy();
                off = std::max(off, std::abs(e.mechanical() - start));
                exchanged = std::max(exchanged, e.kinetic);
            }
            if (w.verdict().grade != Grade::good) good = 0.0;
            const std::string at =
                fmt::format("{} four-bar windows, 1/{:.0f} s, 10 s: ", windows, 1.0 / step);
            require_below(report, at + "change of energy", off / exchanged, 2e-2,
                          "of the kinetic energy, 4 to 5 turns through the singular pose");
            report.compare(at + "result of the monitors, 1: good", {1.0}, {good}, 0.0, "exact");
        }
}

void case_light_links(Report& report) {
    for (const double step : {1.0 / 60.0, 1.0 / 240.0}) {
        double period = 0.0, amplitude = 0.0, good = 1.0;
        for (const double ratio : {1e2, 1e4, 1e6, 1e8})
            for (const bool welded : {true, false}) {
                const SwingErrors e = swing(make_light_pendulum(step, ratio, welded), 10);
                period = std::max(period, e.period);
                amplitude = std::max(amplitude, e.amplitude);
                if (!e.good) good = 0.0;
            }
        const std::string at =
            fmt::format("bob on a rod 1e2 to 1e8 times lighter, 1/{:.0f} s: ", 1.0 / step);
        // The error of the period is of second order in the step: 2e-4 at 1/60 s.
        require_below(report, at + "period", period, 1e-3, "elliptic integral, 10 periods");
        require_below(report, at + "amplitude", amplitude, 1e-2, "after 10 periods");
        report.compare(at + "results of the monitors, 1: all good", {1.0}, {good}, 0.0, "exact");
    }
}

}  // namespace hawser::validate
