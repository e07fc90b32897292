// SPDX-License-Identifier: Apache-2.0
#include "nonsmooth/resistance.h"

#include <algorithm>
#include <cmath>

namespace hawser::nonsmooth {
namespace {

/// Return the normal impulse P(y)_n of the law of the cone at (u_n, λ_n).
double normal_law_impulse(const Cone& c, double u_n, double lambda_n) noexcept {
    const double r = u_n + c.sigma_n * lambda_n - c.b[0];
    return lambda_n - r / (c.sigma_n + c.mobility);
}

/// Return λ − ρ r of one component.
double target(const Resistance& a, double rho, double u, double lambda, int i) noexcept {
    return lambda - rho * (u + a.sigma * lambda - a.b[i]);
}

/// Set component i to λ_i = b_i/Σ − u_i/Σ: the spring holds.
void hold_component(const Resistance& a, int i, ResistanceLaw& law) noexcept {
    law.s[4 * i] = 1.0 / a.sigma;
    law.p[i] = law.s[4 * i] * a.b[i];
}

/// Set component i to the fraction `along` of the bound `coefficient` λ_n, whose present value is
/// `radius`.
void bound_component(const Cone& c, double coefficient, double radius, double along, int i,
                     ResistanceLaw& law) noexcept {
    if (c.coupling == Coupling::exact) {
        law.column[i] = coefficient * along / c.sigma_n;
        law.p[i] += law.column[i] * c.b[0];
    } else {
        law.p[i] += radius * along;
    }
}

}  // namespace

ResistanceLaw linearise(const Resistance& a, const Cone& c, Touch& spins, Touch& rolls) noexcept {
    ResistanceLaw law{};
    spins = rolls = Touch::open;
    const double y_n = normal_law_impulse(c, c.u[0], c.lambda[0]);
    if (!(y_n > 0.0)) return law;
    // ρ uses all of W. Measured on a collapsing heap of balls, unsolved steps out of 1,200 by the
    // factor of W: 1: 7; 0.3: 8; 0.1: 11; 0.03: 58.
    const double rho = 1.0 / (a.sigma + a.mobility);
    double y[3];
    for (int i = 0; i < 3; ++i) y[i] = target(a, rho, a.u[i], a.lambda[i], i);
    if (a.torsional > 0.0) {
        const double radius = a.torsional * y_n;
        spins = std::fabs(y[0]) <= radius ? Touch::stick : Touch::slip;
        if (spins == Touch::stick)
            hold_component(a, 0, law);
        else
            bound_component(c, a.torsional, radius, std::copysign(1.0, y[0]), 0, law);
    }
    if (a.rolling > 0.0) {
        const double radius = a.rolling * y_n, length = std::sqrt(y[1] * y[1] + y[2] * y[2]);
        rolls = length <= radius ? Touch::stick : Touch::slip;
        if (rolls == Touch::stick) {
            hold_component(a, 1, law);
            hold_component(a, 2, law);
        } else {
            // Like a sliding cone: along q ⟂ ŷ the torque turns with the velocity.
            const double yx = y[1] / length, yy = y[2] / length, qx = -yy, qy = yx;
            const double kappa = radius / length;
            const double part = 1.0 - kappa + kappa * rho * a.sigma;
            const double st = kappa * rho / part;
            law.s[4] = st * qx * qx;
            law.s[5] = law.s[7] = st * qx * qy;
            law.s[8] = st * qy * qy;
            const double along = qx * a.lambda[1] + qy * a.lambda[2];
            const double pq = along * (1.0 - 1.0 / part) + st * (qx * a.u[1] + qy * a.u[2]);
            law.p[1] = pq * qx;
            law.p[2] = pq * qy;
            bound_component(c, a.rolling, radius, yx, 1, law);
            bound_component(c, a.rolling, radius, yy, 2, law);
        }
    }
    return law;
}

void set_law_offset(Resistance& a, double u_n) noexcept {
    for (int i = 0; i < 3; ++i)
        a.p[i] = a.lambda[i] + a.s[3 * i] * a.u[0] + a.s[3 * i + 1] * a.u[1] +
                 a.s[3 * i + 2] * a.u[2] + a.column[i] * u_n;
}

void limit(const Resistance& a, double normal, double l[3]) noexcept {
    const double n = std::max(0.0, normal);
    l[0] = std::clamp(l[0], -a.torsional * n, a.torsional * n);
    const double length = std::sqrt(l[1] * l[1] + l[2] * l[2]), radius = a.rolling * n;
    if (length <= radius) return;
    l[1] *= radius / length;
    l[2] *= radius / length;
}

void residual(const Resistance& a, const Cone& c, double u_n, double lambda_n, const double u[3],
              const double lambda[3], double out[3]) noexcept {
    const double rho = 1.0 / (a.sigma + a.mobility);
    for (int i = 0; i < 3; ++i) out[i] = target(a, rho, u[i], lambda[i], i);
    limit(a, normal_law_impulse(c, u_n, lambda_n), out);
    for (int i = 0; i < 3; ++i) out[i] = lambda[i] - out[i];
}

double natural_map(const Resistance& a, const Cone& c, double floor) noexcept {
    const double rho = 1.0 / (a.sigma + a.mobility);
    double y[3];
    for (int i = 0; i < 3; ++i) y[i] = target(a, rho, a.u[i], a.lambda[i], i);
    limit(a, c.lambda[0], y);
    const bool part[3] = {a.torsional > 0.0, a.rolling > 0.0, a.rolling > 0.0};
    double error = 0.0, size = 0.0, free = 0.0;
    for (int i = 0; i < 3; ++i) {
        if (!part[i]) continue;
        const double e = a.lambda[i] - y[i];
        const double q = rho * (a.u[i] - a.b[i] - a.mobility * a.lambda[i]);
        error += e * e;
        size += a.lambda[i] * a.lambda[i];
        free += q * q;
    }
    if (error == 0.0) return 0.0;
    return std::sqrt(error) /
           std::max({std::sqrt(size), std::sqrt(free), floor * std::max(a.torsional, a.rolling)});
}

}  // namespace hawser::nonsmooth
