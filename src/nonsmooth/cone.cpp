// SPDX-License-Identifier: Apache-2.0
#include "nonsmooth/cone.h"

#include <algorithm>
#include <cmath>

namespace hawser::nonsmooth {
namespace {

/// Fraction of W in the tangents' ρ. Iterations per step on a wall of bricks with 648 contacts, of
/// which 150 slide, at k = 3.4e7 N/m and at 1e8. 1.0: 7.4 and 11.2; 0.3: 6.2 and 8.8; 0.1: 5.7 and
/// 7.2; 0.03: does not always converge.
constexpr double kTangentialMobility = 0.1;

/// Compute r = u + Σλ − b of a contact.
void gap_rate(const Cone& c, const double u[3], const double lambda[3], double r[3]) noexcept {
    r[0] = u[0] + c.sigma_n * lambda[0] - c.b[0];
    for (int i = 1; i < 3; ++i) r[i] = u[i] + c.sigma_t * lambda[i] - c.b[i];
}

double normal_rho(const Cone& c) noexcept { return 1.0 / (c.sigma_n + c.mobility); }
double tangential_rho(const Cone& c) noexcept {
    return 1.0 / (c.sigma_t + kTangentialMobility * c.mobility);
}

}  // namespace

Law linearise(const Cone& c, Touch& status) noexcept {
    const double rho_n = normal_rho(c), rho_t = tangential_rho(c);
    double r[3];
    gap_rate(c, c.u, c.lambda, r);
    const double y_n = c.lambda[0] - rho_n * r[0];
    const double y1 = c.lambda[1] - rho_t * r[1];
    const double y2 = c.lambda[2] - rho_t * r[2];

    Law law{};
    double* s = law.s;
    double* p = law.p;
    Touch touch = Touch::open;
    if (y_n > 0.0) {
        s[0] = 1.0 / c.sigma_n;
        p[0] = s[0] * c.b[0];
        const double radius = c.friction * y_n, length = std::sqrt(y1 * y1 + y2 * y2);
        if (length <= radius) {
            touch = Touch::stick;
            s[4] = s[8] = 1.0 / c.sigma_t;
            p[1] = s[4] * c.b[1];
            p[2] = s[4] * c.b[2];
        } else {
            touch = Touch::slip;
            const double yx = y1 / length, yy = y2 / length, qx = -yy, qy = yx;
            const double kappa = radius / length;
            const double part = 1.0 - kappa + kappa * rho_t * c.sigma_t;
            const double st = kappa * rho_t / part;
            s[4] = st * qx * qx;
            s[5] = s[7] = st * qx * qy;
            s[8] = st * qy * qy;
            const double along = qx * c.lambda[1] + qy * c.lambda[2];
            const double pq = along * (1.0 - 1.0 / part) + st * (qx * c.u[1] + qy * c.u[2]);
            p[1] = pq * qx;
            p[2] = pq * qy;
            if (c.coupling == Coupling::exact) {
                s[3] = c.friction * yx * s[0];
                s[6] = c.friction * yy * s[0];
                p[1] += s[3] * c.b[0];
                p[2] += s[6] * c.b[0];
            } else {
                p[1] += radius * yx;
                p[2] += radius * yy;
            }
        }
    }
    status = touch;
    return law;
}

Law sticking_law(const Cone& c) noexcept {
    Law law{};
    law.s[0] = 1.0 / c.sigma_n;
    law.s[4] = law.s[8] = 1.0 / c.sigma_t;
    for (int i = 0; i < 3; ++i) law.p[i] = law.s[4 * i] * c.b[i];
    return law;
}

bool sliding_reversed(const Law& before, const Law& after) noexcept {
    // μŷ/Σ_n; zero of every other law.
    return before.s[3] * after.s[3] + before.s[6] * after.s[6] < 0.0;
}

double disk_radius(const Cone& c, const double u[3], const double lambda[3]) noexcept {
    double r[3];
    gap_rate(c, u, lambda, r);
    return c.friction * std::max(0.0, lambda[0] - normal_rho(c) * r[0]);
}

void project(double mu, double l[3]) noexcept {
    const double t = std::sqrt(l[1] * l[1] + l[2] * l[2]);
    // Test the polar cone first: with μ = 0 and t = 0 the test of the cone itself accepts l_n < 0.
    if (mu * t <= -l[0]) {
        l[0] = l[1] = l[2] = 0.0;
        return;
    }
    if (t <= mu * l[0]) return;
    const double n = (l[0] + mu * t) / (1.0 + mu * mu), shorten = mu * n / t;
    l[0] = n;
    l[1] *= shorten;
    l[2] *= shorten;
}

void residual(const Cone& c, const double u[3], const double lambda[3], double out[3]) noexcept {
    double r[3];
    gap_rate(c, u, lambda, r);
    const double rho_n = normal_rho(c), rho_t = tangential_rho(c);
    const double n = std::max(0.0, lambda[0] - rho_n * r[0]);
    const double y1 = lambda[1] - rho_t * r[1], y2 = lambda[2] - rho_t * r[2];
    const double length = std::sqrt(y1 * y1 + y2 * y2), radius = c.friction * n;
    const double shorten = length > radius ? radius / length : 1.0;
    out[0] = lambda[0] - n;
    out[1] = lambda[1] - shorten * y1;
    out[2] = lambda[2] - shorten * y2;
}

double relative_distance(const Cone& c, const double y[3], double rho, double floor) noexcept {
    double error = 0.0, size = 0.0, free = 0.0;
    for (int i = 0; i < 3; ++i) {
        const double e = c.lambda[i] - y[i];
        const double q = rho * (c.u[i] - c.b[i] - c.mobility * c.lambda[i]);
        error += e * e;
        size += c.lambda[i] * c.lambda[i];
        free += q * q;
    }
    if (error == 0.0) return 0.0;
    return std::sqrt(error) / std::max({std::sqrt(size), std::sqrt(free), floor});
}

double natural_map(const Cone& c, double floor) noexcept {
    double r[3];
    gap_rate(c, c.u, c.lambda, r);
    const double rho = 1.0 / (c.mobility + std::max(c.sigma_n, c.sigma_t));
    const double shift = c.friction * std::sqrt(r[1] * r[1] + r[2] * r[2]);
    double y[3] = {c.lambda[0] - rho * (r[0] + shift), c.lambda[1] - rho * r[1],
                   c.lambda[2] - rho * r[2]};
    project(c.friction, y);
    return relative_distance(c, y, rho, floor);
}

}  // namespace hawser::nonsmooth
