// SPDX-License-Identifier: Apache-2.0
#include "draw/axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace hawser::draw {

Range range_of(std::span<const double> values) {
    Range r{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const double v : values) {
        if (!std::isfinite(v)) continue;
        r.low = std::min(r.low, v);
        r.high = std::max(r.high, v);
    }
    return r.low <= r.high ? r : Range{};
}

Range widened(Range range, double fraction, double least) {
    const double required_span = std::max(range.span() * (1.0 + 2.0 * fraction), least);
    const double middle = 0.5 * (range.low + range.high);
    return {middle - 0.5 * required_span, middle + 0.5 * required_span};
}

namespace {

double tick_distance(Range range, int count) {
    const double raw = range.span() / std::max(1, count);
    if (!(raw > 0.0) || !std::isfinite(raw)) return 1.0;
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    // Choose the step whose number of ticks is closest to the requested one.
    const double ratio = raw / power;
    return power * (ratio < 1.5 ? 1.0 : ratio < 3.5 ? 2.0 : ratio < 7.5 ? 5.0 : 10.0);
}

}  // namespace

std::vector<double> ticks(Range range, int count) {
    std::vector<double> out;
    if (range.low > range.high) std::swap(range.low, range.high);
    const double distance = tick_distance(range, count);
    const double slack = 1e-9 * distance;
    // A narrow range far from zero may exceed double precision; it has no useful ticks.
    const double first = std::ceil((range.low - slack) / distance);
    for (int i = 0; i <= 2 * std::max(1, count) + 2; ++i) {
        const double value = (first + i) * distance;
        if (!(value <= range.high + slack)) break;
        out.push_back(value == 0.0 ? 0.0 : value);
    }
    return out;
}

std::string tick_label(double value, double distance) {
    const double largest = std::max(std::abs(value), distance);
    if (distance > 0.0 && (largest >= 1e6 || distance < 1e-4)) {
        std::string text = fmt::format("{:.2g}", value);
        if (std::abs(value) < 1e-9 * distance) text = "0";
        return text;
    }
    const int decimals =
        distance > 0.0
            ? std::clamp(static_cast<int>(-std::floor(std::log10(distance * 1.0001))), 0, 6)
            : 2;
    std::string text = fmt::format("{:.{}f}", value, decimals);
    if (text.starts_with("-")) text = "−" + text.substr(1);
    return text;
}

}  // namespace hawser::draw
