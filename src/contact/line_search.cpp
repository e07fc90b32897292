// SPDX-License-Identifier: Apache-2.0
#include "contact/line_search.h"

#include "contact/iterate.h"
#include "contact/newton_laws.h"

namespace hawser::contact {

LineStep move_fraction(context::Model& model, const context::Newton& newton,
                       double fraction) noexcept {
    const double merit_there = merit(model, newton, fraction);
    if (fraction < 1.0) return_to_fraction(model, newton, fraction);
    return {fraction, merit_there};
}

LineStep search_line(context::Model& model, const context::Newton& newton, double before,
                     double given) noexcept {
    if (given > 0.0) return move_fraction(model, newton, given);
    double now = merit(model, newton, 1.0), best = now, best_t = 1.0, t = 1.0;
    constexpr int kHalvings = 4;
    for (int k = 0; k < kHalvings && !(now <= before * (1.0 - 1e-4 * t)); ++k) {
        t *= 0.5;
        now = merit(model, newton, t);
        if (!(now < best)) continue;
        best = now;
        best_t = t;
    }
    if (best_t < 1.0) return_to_fraction(model, newton, best_t);
    return {best_t, best};
}

}  // namespace hawser::contact
