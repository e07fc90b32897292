// SPDX-License-Identifier: Apache-2.0
#include "scene/catenary.h"

#include <algorithm>
#include <cmath>

namespace hawser::scene {
namespace {

/// Sums over a chain with slopes t_0 + i k: span and rise in units of the element, and their
/// derivatives.
struct Sums {
    double span = 0.0, rise = 0.0;
    double span_t = 0.0, span_k = 0.0;
    double rise_t = 0.0, rise_k = 0.0;
};

Sums add_up(double t0, double k, int n) {
    Sums s;
    for (int i = 0; i < n; ++i) {
        const double t = t0 + i * k;
        const double cosine = 1.0 / std::sqrt(1.0 + t * t);
        const double cube = cosine * cosine * cosine;
        s.span += cosine;
        s.rise += t * cosine;
        s.span_t -= t * cube;
        s.span_k -= i * t * cube;
        s.rise_t += cube;
        s.rise_k += i * cube;
    }
    return s;
}

struct CatenaryProblem {
    double span, rise;  ///< In units of the element.
    int n;

    [[nodiscard]] double residual(const Sums& s) const {
        return std::hypot(s.span - span, s.rise - rise);
    }
    [[nodiscard]] double tolerance() const { return 1e-11 * n; }
};

struct Slopes {
    double t0, k;
};

/// Return the root x > 0 of sinh(x)/x = ratio > 1, by bisection in the logarithm of the left side.
double sinh_ratio_root(double ratio) {
    double low = 0.0;
    double high = 1.0;
    const auto left = [](double x) { return x < 1e-4 ? 1.0 + x * x / 6.0 : std::sinh(x) / x; };
    while (left(high) < ratio && high < 700.0) {
        high *= 2.0;
    }
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (left(middle) < ratio ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

Slopes smooth_start_slopes(const CatenaryProblem& p) {
    const double n = p.n;
    const double ratio = std::sqrt(n * n - p.rise * p.rise) / p.span;
    const double x = std::max(sinh_ratio_root(std::max(ratio, 1.0)), 1e-9);
    const double a = p.span / (2.0 * x);
    const double middle = a * std::atanh(std::clamp(p.rise / n, -1.0 + 1e-15, 1.0 - 1e-15));
    const double start = std::sinh((middle - p.span / 2.0) / a);
    return {start + 0.5 / a, 1.0 / a};
}

/// Solve by Newton's method with halved steps. @return false if it does not converge.
bool newton(const CatenaryProblem& p, Slopes& at) {
    Sums s = add_up(at.t0, at.k, p.n);
    double error = p.residual(s);
    for (int i = 0; i < 60 && error > p.tolerance(); ++i) {
        const double det = s.span_t * s.rise_k - s.span_k * s.rise_t;
        if (!(std::abs(det) > 0.0)) {
            return false;
        }
        const double f = p.span - s.span;
        const double g = p.rise - s.rise;
        const double dt = (f * s.rise_k - g * s.span_k) / det;
        const double dk = (g * s.span_t - f * s.rise_t) / det;
        double part = 1.0;
        bool better = false;
        for (int halving = 0; halving < 40 && !better; ++halving, part *= 0.5) {
            const Slopes next{at.t0 + part * dt, at.k + part * dk};
            if (!(next.k > 0.0)) {
                continue;
            }
            const Sums trial = add_up(next.t0, next.k, p.n);
            if (p.residual(trial) < error) {
                at = next;
                s = trial;
                error = p.residual(trial);
                better = true;
            }
        }
        if (!better) {
            break;
        }
    }
    return error <= p.tolerance();
}

/// Return the first slope for which the chain of curvature k has the right rise. The rise grows
/// with this slope.
double match_rise(const CatenaryProblem& p, double k) {
    double low = -30.0;  // asinh of the slope of the middle element: slopes up to 5e12.
    double high = 30.0;
    const double half = 0.5 * (p.n - 1) * k;
    low = std::asinh(std::sinh(low) - half);
    high = std::asinh(std::sinh(high) + half);
    for (int i = 0; i < 120; ++i) {
        const double middle = 0.5 * (low + high);
        (add_up(std::sinh(middle) - half, k, p.n).rise < p.rise ? low : high) = middle;
    }
    return std::sinh(0.5 * (low + high)) - half;
}

/// Solve by nested bisection, which is slower but needs no starting point.
bool bisect(const CatenaryProblem& p, Slopes& at) {
    double low = -30.0;
    double high = 30.0;
    for (int i = 0; i < 120; ++i) {
        const double middle = 0.5 * (low + high);
        const double k = std::exp(middle);
        (add_up(match_rise(p, k), k, p.n).span > p.span ? low : high) = middle;
    }
    at.k = std::exp(0.5 * (low + high));
    at.t0 = match_rise(p, at.k);
    return newton(p, at);
}

}  // namespace

std::optional<std::vector<Vec3>> hanging_nodes(const Vec3& a, const Vec3& b, double length, int n,
                                               const Vec3& down) {
    const Vec3 up = -down.normalized();
    const Vec3 across = b - a;
    const double rise = across.dot(up);
    const Vec3 flat = across - rise * up;
    const double span = flat.norm();
    const double distance = across.norm();
    // Within round-off of the distance the chain is straight.
    if (length < distance * (1.0 - 1e-9)) {
        return {};
    }
    std::vector<Vec3> nodes(static_cast<std::size_t>(n) + 1);
    nodes.front() = a;
    nodes.back() = b;
    if (length <= distance * (1.0 + 1e-9)) {
        for (int i = 1; i < n; ++i) {
            nodes[static_cast<std::size_t>(i)] = a + across * (static_cast<double>(i) / n);
        }
        return nodes;
    }
    if (n < 2 || span < 1e-9 * length) {
        return {};
    }
    const double l = length / n;
    const CatenaryProblem p{span / l, rise / l, n};
    Slopes slopes = smooth_start_slopes(p);
    if (!newton(p, slopes)) {
        slopes = smooth_start_slopes(p);
        if (!bisect(p, slopes)) {
            return {};
        }
    }
    const Vec3 along = flat / span;
    Vec3 node = a;
    for (int i = 0; i + 1 < n; ++i) {
        const double t = slopes.t0 + i * slopes.k;
        node += l / std::sqrt(1.0 + t * t) * (along + t * up);
        nodes[static_cast<std::size_t>(i) + 1] = node;
    }
    return nodes;
}

}  // namespace hawser::scene
