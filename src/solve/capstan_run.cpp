// SPDX-License-Identifier: Apache-2.0
#include "solve/capstan_run.h"

#include "solve/capstans.h"

#include <cmath>

namespace hawser::solve {
namespace {

/// Relative rounding of the impulses whose difference acts at a turning point.
constexpr double kRounding = 2e-15;

/// Express the speed w of a turning point as a linear function of the impulses of the parts before
/// and behind it.
void write_speed(context::RunPoint& p) noexcept {
    if (p.side == 0) {
        const double scale = 1.0 / (1.0 + p.sigma * p.mass);
        p.w0 = scale * (p.hold + p.sigma * p.mass * p.free);
        p.w1 = scale * p.sigma * p.before;
        p.w2 = scale * p.sigma * p.behind;
        return;
    }
    const double bound = p.side > 0 ? p.high : p.low, side = p.side;
    p.w0 = p.free + bound / p.mass;
    p.w1 = (p.before - side * p.fraction[0]) / p.mass;
    p.w2 = (p.behind - side * p.fraction[1]) / p.mass;
}

/// Solve the tridiagonal system for the impulses λ of all parts, with the present statuses.
void solve_run(std::size_t n, context::RunPoint* place, context::RunPart* part) noexcept {
    for (std::size_t k = 0; k < n; ++k) write_speed(place[k]);
    double above = 0.0, above_right = 0.0;  // of the part before: upper/diagonal, right/diagonal
    for (std::size_t i = 0; i <= n; ++i) {
        context::RunPart& p = part[i];
        double lower = 0.0;
        p.diagonal = p.softness;
        p.upper = 0.0;
        p.right = p.asked;
        if (i > 0) {
            const context::RunPoint& a = place[i - 1];
            lower = a.behind * a.w1;
            p.diagonal += a.behind * a.w2;
            p.right -= a.behind * a.w0;
        }
        if (i < n) {
            const context::RunPoint& b = place[i];
            p.diagonal += b.before * b.w1;
            p.upper = b.before * b.w2;
            p.right -= b.before * b.w0;
        }
        if (!p.pulls) {
            p.diagonal = 1.0;
            lower = p.upper = p.right = 0.0;
        }
        const double pivot = p.diagonal - lower * above;
        above = p.upper / pivot;
        above_right = (p.right - lower * above_right) / pivot;
        p.upper = above;
        p.right = above_right;
    }
    part[n].lambda = part[n].right;
    for (std::size_t i = n; i-- > 0;)
        part[i].lambda = part[i].right - part[i].upper * part[i + 1].lambda;
}

/// Compute the speeds w of all turning points from the impulses of the parts. For a sliding point
/// the equation of the part before it is used. The point's own equation would give w as a small
/// difference of large forces divided by a small mass.
void find_speeds(std::size_t n, context::RunPoint* place, const context::RunPart* part) noexcept {
    for (std::size_t k = 0; k < n; ++k) {
        context::RunPoint& p = place[k];
        const context::RunPart& before = part[k];
        p.speed = p.w0 + p.w1 * before.lambda + p.w2 * part[k + 1].lambda;
        if (p.side == 0 || !before.pulls) continue;
        const double last = k > 0 ? place[k - 1].behind * place[k - 1].speed : 0.0;
        p.speed = (before.asked - before.softness * before.lambda - last) / p.before;
    }
}

/// Change the statuses that do not match the solution. Parts change between taut and slack, turning
/// points between sticking and sliding in either direction.
/// @param most  Maximum number of changes.
/// @return the number of changes.
int switch_run(std::size_t n, context::RunPoint* place, context::RunPart* part, int most) noexcept {
    int switched = 0;
    for (std::size_t i = 0; i <= n && switched < most; ++i) {
        context::RunPart& p = part[i];
        if (!p.one_sided) continue;
        double left = p.asked;
        if (i > 0) left -= place[i - 1].behind * place[i - 1].speed;
        if (i < n) left -= place[i].before * place[i].speed;
        const bool pulls = p.pulls ? p.lambda <= 0.0 : left < 0.0;
        switched += pulls != p.pulls ? 1 : 0;
        p.pulls = pulls;
    }
    std::int32_t before = 0;  // former side of the previous point
    for (std::size_t k = 0; k < n && switched < most; ++k) {
        context::RunPoint& p = place[k];
        const std::int32_t was = p.side, behind = k + 1 < n ? place[k + 1].side : 0;
        const double w = p.speed;
        const double load = p.fraction[0] * std::fabs(part[k].lambda) +
                            p.fraction[1] * std::fabs(part[k + 1].lambda);
        std::int32_t side = 0;
        if (p.side == 0) {
            const double force =
                p.mass * (w - p.free) - p.before * part[k].lambda - p.behind * part[k + 1].lambda;
            // Points behind one that has slid are at their bounds.
            constexpr double beyond = 1.0 + kCapstanAtBound;
            if (force > beyond * (p.high + load)) side = 1;
            if (force < beyond * (p.low - load)) side = -1;
        } else {
            // A point continues to slide while its spring requires more than the bound.
            const double bound = p.side > 0 ? p.high + load : p.low - load;
            const double noise =
                kRounding * (std::fabs(part[k].lambda) + std::fabs(part[k + 1].lambda)) / p.mass;
            const bool goes_on = p.side * (p.hold - w - p.sigma * bound) > -noise;
            // Places that slide towards each other: only those from the meeting point on hold.
            if (goes_on || (before == p.side && behind == p.side)) side = p.side;
        }
        before = was;
        switched += side != was ? 1 : 0;
        p.side = side;
    }
    return switched;
}

}  // namespace

bool find_statuses(std::size_t n, context::RunPoint* place, context::RunPart* part) noexcept {
    const int together = 20 + 4 * static_cast<int>(n), most = 2 * together;
    for (int pass = 0; pass < most; ++pass) {
        solve_run(n, place, part);
        find_speeds(n, place, part);
        if (!std::isfinite(part[0].lambda)) return false;
        const int all = static_cast<int>(4 * n);
        if (switch_run(n, place, part, pass < together ? all : 1) == 0) break;
    }
    for (std::size_t k = 0; k < n; ++k)
        if (place[k].side != place[k].was) return true;
    for (std::size_t i = 0; i <= n; ++i)
        if (part[i].pulls != part[i].was) return true;
    return false;
}

}  // namespace hawser::solve
