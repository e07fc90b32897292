// SPDX-License-Identifier: Apache-2.0
#include "model/damping.h"
#include "model/interactions.h"

#include <hawser/row_constants.h>

#include <algorithm>

namespace hawser::model {

/// The axial swing of a wire's lumps is seldom resolved, and with the trapezoidal rule alone it
/// would never end: where it is not, a wire has the damping of half a step at least.
void Interactions::share_damping(std::size_t row, bool wire, double h) noexcept {
    const double w = mobility[row], e = epsilon[row];
    double t = tau[row], late = 1.0;
    recall[row] = 1.0;
    if (row_flags[row] & kRowVelocity) return;
    if ((row_flags[row] & kRowDamper) && w > 0.0 && e > 0.0) {
        const double spring = 0.25 * h * h * w / e;
        if (wire) t = std::max(t, (late_share(spring) - 0.5) * h);
        late = late_share(h * t * w / e + spring);
        recall[row] = 1.0 - 4.0 * t * (1.0 - late) / h;
    }
    upsilon[row] = row_upsilon(t, h, late);
}

double Interactions::bare_sigma(std::size_t row, double h) const noexcept {
    return row_flags[row] & kRowVelocity ? velocity_row_sigma(epsilon[row], h)
                                         : row_sigma(epsilon[row], upsilon[row], h);
}

void Interactions::follow_compliance(std::size_t row, bool wire, double h) noexcept {
    share_damping(row, wire, h);
    sigma[row] = std::max(row_sigma(epsilon[row], upsilon[row], h), least_sigma[row]);
    if (inv_sigma[row] != 0.0) inv_sigma[row] = 1.0 / sigma[row];
}

}  // namespace hawser::model
