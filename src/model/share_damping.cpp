// SPDX-License-Identifier: Apache-2.0
#include "model/damping.h"
#include "model/interactions.h"

#include <hawser/row_constants.h>

#include "base/index.h"

#include <algorithm>

namespace hawser::model {
namespace {

/// Values of Υ and recall of a row.
struct Shares {
    double upsilon, recall;
};

/// Row of a recoiling wire: the force is that at the end of the step, −g₊/ε. The wire behind the
/// recoil front then moves at T/√(EA ρ) for any length of elements (docs/theory/parting.md). In
/// terms of the step τ = h and θ = ¾, for any damper of the line.
constexpr Shares kRecoil{0.25, 0.0};

/// Compute Υ and the factor recall of a row. With the trapezoidal rule alone, the axial vibration
/// of a wire's nodes, which is rarely resolved, would never decay. The damping time of a wire is
/// therefore at least half a step if the vibration is not resolved.
Shares shares_of(const Interactions& in, std::size_t row, bool wire, double h) noexcept {
    const double w = in.mobility[row], e = in.epsilon[row];
    double t = in.tau[row], late = 1.0, recall = 1.0;
    if ((in.row_flags[row] & kRowDamper) && w > 0.0 && e > 0.0) {
        const double spring = 0.25 * h * h * w / e;
        if (wire) t = std::max(t, (late_fraction(spring) - 0.5) * h);
        late = late_fraction(h * t * w / e + spring);
        recall = 1.0 - 4.0 * t * (1.0 - late) / h;
    }
    return {row_upsilon(t, h, late), recall};
}

}  // namespace

void Interactions::split_damping(std::size_t row, bool wire, double h) noexcept {
    recall[row] = 1.0;
    if (row_flags[row] & kRowVelocity) return;
    const Shares s = row_flags[row] & kRowRecoils ? kRecoil : shares_of(*this, row, wire, h);
    upsilon[row] = s.upsilon;
    recall[row] = s.recall;
}

double Interactions::recoil_fraction(std::size_t row, bool wire, double h) const noexcept {
    if (!(row_flags[row] & kRowRecoils)) return 1.0;
    return upsilon[row] / shares_of(*this, row, wire, h).upsilon;
}

void Interactions::recoil(int id, bool recoils, double h) noexcept {
    for (int r = 0; r < rows[at(id)]; ++r) {
        const auto row = at(row_begin[at(id)] + r);
        if (((row_flags[row] & kRowRecoils) != 0) == recoils) continue;
        row_flags[row] ^= kRowRecoils;
        follow_compliance(row, rest_length[at(id)] > 0.0, h);
    }
}

double Interactions::bare_sigma(std::size_t row, double h) const noexcept {
    return row_flags[row] & kRowVelocity ? velocity_row_sigma(epsilon[row], h)
                                         : row_sigma(epsilon[row], upsilon[row], h);
}

void Interactions::follow_compliance(std::size_t row, bool wire, double h) noexcept {
    split_damping(row, wire, h);
    sigma[row] = std::max(row_sigma(epsilon[row], upsilon[row], h), min_sigma[row]);
    if (inv_sigma[row] != 0.0) inv_sigma[row] = 1.0 / sigma[row];
}

}  // namespace hawser::model
