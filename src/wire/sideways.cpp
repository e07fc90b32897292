// SPDX-License-Identifier: Apache-2.0
#include "wire/sideways.h"

#include <algorithm>
#include <cmath>

namespace hawser::wire {
namespace {

constexpr int kWayRounds = 60;
/// Rounding of a displacement, relative to the length of both parts.
constexpr double kWaySolved = 1e-13;
constexpr double kMinWay = 1e-7;  ///< Smallest displacement [m].
/// Largest displacement in a step, as a fraction of the shorter part.
constexpr double kMaxWay = 0.25;
/// Relative distance inside the bound at which a sliding position stops, so that it sticks
/// afterwards.
constexpr double kInsideBound = 1e-9;

double sideways_balance_slope(const Crossing& c, double s) noexcept {
    return 1.0 / std::hypot(c.across[0], s - c.along[0]) +
           1.0 / std::hypot(c.across[1], s - c.along[1]);
}

}  // namespace

double sideways_balance(const Crossing& c, double s) noexcept {
    return std::asinh((s - c.along[0]) / c.across[0]) + std::asinh((s - c.along[1]) / c.across[1]);
}

double sideways_displacement(const Crossing& c, double bound) noexcept {
    const double now = sideways_balance(c, 0.0);
    if (std::abs(now) <= bound) return 0.0;
    const double signed_bound = now > 0.0 ? bound : -bound;
    const double whole = c.across[0] + c.across[1];
    const double shortest = (c.along[0] * c.across[1] + c.along[1] * c.across[0]) / whole;
    double inside = shortest, outside = 0.0, s = shortest;
    for (int i = 0; i < kWayRounds; ++i) {
        const double over = sideways_balance(c, s) - signed_bound;
        ((over > 0.0) == (now > 0.0) ? outside : inside) = s;
        double next = s - over / sideways_balance_slope(c, s);
        if (!(next > std::min(inside, outside) && next < std::max(inside, outside)))
            next = 0.5 * (inside + outside);
        const double by = std::abs(next - s);
        s = next;
        if (by <= kWaySolved * whole) break;
    }
    s += kInsideBound * (shortest - s);
    const double most = kMaxWay * std::min(c.across[0], c.across[1]);
    return std::abs(s) < kMinWay ? 0.0 : std::clamp(s, -most, most);
}

double length_to_feed(const Parts& p) noexcept {
    double strain[2], path[2];
    for (int k = 0; k < 2; ++k) {
        strain[k] = std::max(0.0, p.longer[k]) / p.rest[k];
        path[k] = p.rest[k] + p.longer[k] + p.changes[k];
    }
    const double rest = p.rest[0] + p.rest[1], both = path[0] + path[1];
    // Without tension both have the same relative slack.
    if (both <= rest || (strain[0] == 0.0 && strain[1] == 0.0))
        return path[0] * rest / both - p.rest[0];
    // Find strains t ε₁ and t ε₂ for which the rest lengths sum to the total. Convex in t.
    double t = 1.0;
    for (int i = 0; i < kWayRounds; ++i) {
        const double first = path[0] / (1.0 + t * strain[0]),
                     second = path[1] / (1.0 + t * strain[1]);
        const double falls =
            first * strain[0] / (1.0 + t * strain[0]) + second * strain[1] / (1.0 + t * strain[1]);
        const double by = (first + second - rest) / falls;
        t = std::max(0.0, t + by);
        if (std::abs(by) <= 1e-12 * t) break;
    }
    return path[0] / (1.0 + t * strain[0]) - p.rest[0];
}

}  // namespace hawser::wire
