// SPDX-License-Identifier: Apache-2.0
#include "model/damping.h"
#include "model/interactions.h"

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
    upsilon[row] = 1.0 / (1.0 + 4.0 * t * late / h);
}

}  // namespace hawser::model
