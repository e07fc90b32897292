// SPDX-License-Identifier: Apache-2.0
#include "nonsmooth/box.h"

#include <cmath>

namespace hawser::nonsmooth {

Law box_law(const Cone& c, const Bound rows[3], double limit) noexcept {
    Law law{};
    for (int i = 0; i < 3; ++i) {
        const double sigma = i == 0 ? c.sigma_n : c.sigma_t;
        if (rows[i] == Bound::free) {
            law.s[4 * i] = 1.0 / sigma;
            law.p[i] = c.b[i] / sigma;
        } else if (i > 0) {
            law.p[i] = rows[i] == Bound::high ? limit : -limit;
        }
    }
    return law;
}

int box_pivots(const Cone& c, const Bound rows[3], double limit, double floor,
               Bound wanted[3]) noexcept {
    // Rounding of λ, which is a difference of large numbers if Σ is small.
    const double noise = 1e-9 * (std::fabs(c.lambda[0]) + limit + floor);
    int count = 0;
    for (int i = 0; i < 3; ++i) {
        const double sigma = i == 0 ? c.sigma_n : c.sigma_t;
        const double r = c.u[i] + sigma * c.lambda[i] - c.b[i];
        const double slow = noise * (c.mobility + sigma);
        wanted[i] = rows[i];
        switch (rows[i]) {
            case Bound::free:
                if (i > 0 && c.lambda[i] > limit + noise) wanted[i] = Bound::high;
                if (c.lambda[i] < (i == 0 ? 0.0 : -limit) - noise) wanted[i] = Bound::low;
                break;
            case Bound::low:
                if (r < -slow && (i == 0 || limit > 0.0)) wanted[i] = Bound::free;
                break;
            case Bound::high:
                if (r > slow && limit > 0.0) wanted[i] = Bound::free;
                break;
        }
        count += wanted[i] != rows[i] ? 1 : 0;
    }
    return count;
}

Touch contact_state(const Bound rows[3], double limit) noexcept {
    const bool tied = rows[1] == Bound::free && rows[2] == Bound::free;
    const bool any = rows[0] == Bound::free || rows[1] == Bound::free || rows[2] == Bound::free;
    if (!any && limit == 0.0) return Touch::open;
    return tied ? Touch::stick : Touch::slip;
}

}  // namespace hawser::nonsmooth
