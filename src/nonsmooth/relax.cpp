// SPDX-License-Identifier: Apache-2.0
#include "nonsmooth/relax.h"

#include <algorithm>
#include <cmath>

namespace hawser::nonsmooth {

double relax_normal(const Cone& c, double mobility) noexcept {
    const double r = c.u[0] + c.sigma_n * c.lambda[0] - c.b[0];
    return std::max(0.0, c.lambda[0] - r / (mobility + c.sigma_n));
}

void relax_tangents(const Cone& c, double mobility, double out[2]) noexcept {
    const double rho = 1.0 / (mobility + c.sigma_t);
    for (int i = 0; i < 2; ++i)
        out[i] = c.lambda[1 + i] - rho * (c.u[1 + i] + c.sigma_t * c.lambda[1 + i] - c.b[1 + i]);
    const double length = std::sqrt(out[0] * out[0] + out[1] * out[1]);
    const double radius = c.friction * std::max(0.0, c.lambda[0]);
    if (length <= radius) return;
    out[0] *= radius / length;
    out[1] *= radius / length;
}

Touch touch_by_impulse(const Cone& c) noexcept {
    if (!(c.lambda[0] > 0.0)) return Touch::open;
    const double length = std::sqrt(c.lambda[1] * c.lambda[1] + c.lambda[2] * c.lambda[2]);
    // The projection onto the disk leaves rounding of this size.
    return length >= (1.0 - 1e-12) * c.friction * c.lambda[0] ? Touch::slip : Touch::stick;
}

}  // namespace hawser::nonsmooth
