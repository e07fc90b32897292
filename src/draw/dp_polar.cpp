// SPDX-License-Identifier: Apache-2.0
#include "draw/dp_polar.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace hawser::draw {
namespace {

constexpr double kPolarWidth = 900.0, kPolarHeight = 860.0;
constexpr Point kPolarCentre{430.0, 470.0};
constexpr double kPolarUnit = 28.0;  ///< Points for each number.
constexpr Color kIntactColor{31, 119, 180, 255};
constexpr Color kFailureColors[] = {{214, 39, 40, 255},   {255, 127, 14, 255}, {148, 103, 189, 255},
                                    {44, 160, 44, 255},   {140, 86, 75, 255},  {227, 119, 194, 255},
                                    {127, 127, 127, 255}, {188, 189, 34, 255}};

/// Return the point at a radius and direction: the bow is up, angles are clockwise.
Point polar(double radius, double from) {
    return {kPolarCentre.x + kPolarUnit * radius * std::sin(from),
            kPolarCentre.y - kPolarUnit * radius * std::cos(from)};
}

void add_grid(Drawing& out) {
    for (int n = 1; n <= kDpNumbers; ++n) {
        Path ring{.points = {}, .stroke = kGrid, .closed = true};
        for (int k = 0; k < 180; ++k) ring.points.push_back(polar(n, k * std::numbers::pi / 90.0));
        out.add(std::move(ring));
    }
    for (int k = 0; k < 12; ++k) {
        const double from = k * std::numbers::pi / 6.0;
        out.line(kPolarCentre, polar(kDpNumbers, from), kGrid);
        const Point at = polar(kDpNumbers + 0.8, from);
        out.text({at.x, at.y + 4.0}, fmt::format("{}°", 30 * k), 12.0, Anchor::middle, kSoft);
    }
    for (int n = 1; n <= kDpNumbers; ++n) {
        const Point at = polar(n, 0.0);
        out.text({at.x + 3.0, at.y - 2.0}, fmt::format("{}", n), 10.0, Anchor::start, kSoft);
    }
}

void add_ship(Drawing& out) {
    const Point c = kPolarCentre;
    out.add(Path{.points = {{c.x, c.y - 22},
                            {c.x + 6, c.y - 10},
                            {c.x + 6, c.y + 20},
                            {c.x - 6, c.y + 20},
                            {c.x - 6, c.y - 10}},
                 .stroke = kSoft,
                 .closed = true});
}

}  // namespace

Drawing plot_dp_capability(const DpCapability& capability, const std::string& title,
                           const std::string& parameters) {
    Drawing out;
    out.width = kPolarWidth;
    out.height = kPolarHeight;
    out.title = title;
    out.description = parameters;
    out.box({0.0, 0.0, kPolarWidth, kPolarHeight}, kWhite);
    out.text({24.0, 34.0}, title, 18.0, Anchor::start, kInk, true);
    out.text({24.0, 56.0}, parameters, 12.0, Anchor::start, kSoft);
    out.text({24.0, 74.0},
             "DP capability number over the direction from which wind, waves and current come",
             12.0, Anchor::start, kSoft);
    add_grid(out);
    add_ship(out);
    double legend = 110.0;
    const auto curve = [&](const std::string& name, Color color, double width, const auto& number) {
        Path path{.points = {}, .stroke = color, .width = width, .closed = true};
        for (const DpHeading& h : capability.headings)
            path.points.push_back(polar(number(h), h.from));
        out.add(std::move(path));
        out.line({kPolarWidth - 150.0, legend - 4.0}, {kPolarWidth - 125.0, legend - 4.0}, color,
                 width);
        out.text({kPolarWidth - 118.0, legend}, name, 12.0);
        legend += 18.0;
    };
    constexpr std::size_t kColors = sizeof kFailureColors / sizeof kFailureColors[0];
    for (std::size_t k = 0; k < capability.failures.size(); ++k)
        curve("without " + capability.failures[k].name, kFailureColors[k % kColors], 1.2,
              [k](const DpHeading& h) { return h.failed_numbers[k]; });
    curve("intact", kIntactColor, 2.2, [](const DpHeading& h) { return h.number; });
    return out;
}

}  // namespace hawser::draw
