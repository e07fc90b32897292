// SPDX-License-Identifier: Apache-2.0
#include "draw/axes.h"
#include "linear/report.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace hawser::bench {
namespace {

/// Return the libraries in order of first appearance, without Hawser.
std::vector<std::string> libraries_of(const std::vector<ProblemReport>& reports) {
    std::vector<std::string> names;
    for (const ProblemReport& p : reports)
        for (const Result& r : p.best)
            if (r.library != "hawser" &&
                std::find(names.begin(), names.end(), r.library) == names.end())
                names.push_back(r.library);
    return names;
}

double total_of(const ProblemReport& p, const std::string& library) {
    for (const Result& r : p.best)
        if (r.library == library && r.threads == 1 && r.failure.empty()) return r.total;
    return 0.0;
}

}  // namespace

draw::Drawing ratio_picture(const std::vector<ProblemReport>& reports) {
    const std::vector<std::string> libraries = libraries_of(reports);
    constexpr double kLow = 0.5, kHigh = 64.0, kLeft = 190.0, kTop = 70.0, kBar = 10.0;
    const double group = kBar * static_cast<double>(libraries.size()) + 16.0;
    draw::Drawing d;
    d.width = 1000.0;
    d.height = kTop + group * static_cast<double>(reports.size()) + 50.0;
    draw::draw_heading(d, "Time of each library over ours, one thread",
                       "condense + refactor + solve + one refinement; logarithmic");
    const double width = d.width - kLeft - 200.0, bottom = d.height - 40.0;
    auto x = [&](double ratio) {
        return kLeft +
               width * std::log(std::clamp(ratio, kLow, kHigh) / kLow) / std::log(kHigh / kLow);
    };
    for (double tick = kLow; tick <= kHigh; tick *= 2.0) {
        d.line({x(tick), kTop - 8.0}, {x(tick), bottom}, tick == 1.0 ? draw::kInk : draw::kGrid);
        d.text({x(tick), bottom + 16.0}, fmt::format("{:g}", tick), 11.0, draw::Anchor::middle);
    }
    std::vector<draw::LegendEntry> legend;
    for (std::size_t k = 0; k < libraries.size(); ++k)
        legend.push_back({libraries[k], "", draw::curve_color(k), {}});
    draw::draw_legend(d, {d.width - 185.0, kTop}, legend);
    double y = kTop;
    for (const ProblemReport& p : reports) {
        const double base = total_of(p, "hawser");
        d.text({kLeft - 8.0, y + 0.5 * group - 4.0}, p.name, 12.0, draw::Anchor::end);
        for (std::size_t k = 0; k < libraries.size(); ++k) {
            const double t = total_of(p, libraries[k]);
            if (!(t > 0.0) || !(base > 0.0)) continue;
            const double top = y + kBar * static_cast<double>(k);
            d.box({x(1.0), top, x(t / base) - x(1.0), kBar - 2.0}, draw::curve_color(k));
            d.text({x(t / base) + 4.0, top + kBar - 2.0}, fmt::format("{:.1f}", t / base), 9.0);
        }
        y += group;
    }
    return d;
}

}  // namespace hawser::bench
