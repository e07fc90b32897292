// SPDX-License-Identifier: Apache-2.0
#include "nonsmooth/associated.h"

#include <algorithm>
#include <cmath>

namespace hawser::nonsmooth {
namespace {

/// Coordinates z = Σ^½ y: the norm is Euclidean, and the cone has another opening.
struct Scaled {
    double root_n, root_t, friction;
    explicit Scaled(const Cone& c)
        : root_n(std::sqrt(c.sigma_n)),
          root_t(std::sqrt(c.sigma_t)),
          friction(c.friction * root_t / root_n) {}
    void z(const Cone& c, const double u[3], double out[3]) const {
        out[0] = (c.b[0] - u[0]) / root_n;
        for (int i = 1; i < 3; ++i) out[i] = (c.b[i] - u[i]) / root_t;
    }
};

}  // namespace

void associated_impulse(const Cone& c, const double u[3], double lambda[3]) noexcept {
    const Scaled scaled(c);
    scaled.z(c, u, lambda);
    project(scaled.friction, lambda);
    lambda[0] /= scaled.root_n;
    lambda[1] /= scaled.root_t;
    lambda[2] /= scaled.root_t;
}

Law linearise_associated(const Cone& c, Touch& touch) noexcept {
    const Scaled scaled(c);
    double z[3];
    scaled.z(c, c.u, z);
    const double m = scaled.friction, t = std::sqrt(z[1] * z[1] + z[2] * z[2]);
    double d[9] = {};
    if (z[0] > 0.0 && t <= m * z[0]) {
        touch = Touch::stick;
        d[0] = d[4] = d[8] = 1.0;
    } else if (m * t <= -z[0]) {
        touch = Touch::open;
    } else {
        // Project onto the rim along a = (1, m ŷ); in the perpendicular direction the circle of
        // radius m n' turns.
        touch = Touch::slip;
        const double yx = z[1] / t, yy = z[2] / t, fraction = 1.0 / (1.0 + m * m);
        const double turn = m * fraction * (z[0] + m * t) / t;
        const double a[3] = {1.0, m * yx, m * yy}, q[3] = {0.0, -yy, yx};
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) d[3 * i + j] = fraction * a[i] * a[j] + turn * q[i] * q[j];
    }
    const double inverse[3] = {1.0 / scaled.root_n, 1.0 / scaled.root_t, 1.0 / scaled.root_t};
    Law law{};
    associated_impulse(c, c.u, law.p);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            law.s[3 * i + j] = inverse[i] * d[3 * i + j] * inverse[j];
            law.p[i] += law.s[3 * i + j] * c.u[j];
        }
    return law;
}

double associated_map(const Cone& c, double floor) noexcept {
    const double rho = 1.0 / (c.mobility + std::max(c.sigma_n, c.sigma_t));
    double y[3];
    for (int i = 0; i < 3; ++i) {
        const double sigma = i == 0 ? c.sigma_n : c.sigma_t;
        y[i] = c.lambda[i] - rho * (c.u[i] + sigma * c.lambda[i] - c.b[i]);
    }
    project(c.friction, y);
    return relative_distance(c, y, rho, floor);
}

}  // namespace hawser::nonsmooth
