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
constexpr Shares kRecoilShares{0.25, 0.0};

/// Return a factor that increases from 0 at z = `from` to `most` for large z.
double rise(double most, double z, double from) noexcept {
    return z > from ? most * (z - from) / (z + from) : 0.0;
}

/// Return the minimum damping time of a joint's row, in steps (docs/theory/compliance.md).
/// @param spring  z = h²W/4ε of the vibration of the row.
///
/// Without this damping a linearised rigid row has the double root −1, which means undamped
/// oscillation from step to step. In stiff rows, errors of the iteration and singular poses cause
/// large energies. The energy that the damping removes from resolved motion is proportional to ε.
double min_damping(double epsilon, double spring) noexcept {
    constexpr double kMinDampingRigid = 0.5, kMaxDampingStiff = 0.1, kStiffZ = 1e4;
    return epsilon == 0.0 ? kMinDampingRigid : rise(kMaxDampingStiff, spring, kStiffZ);
}

/// Return κ/h of a compliant joint's row. The law of the row contains κ (d₊ − d₋), which adds κ/h
/// to the parameter β = ¼ of Newmark's scheme (docs/theory/compliance.md).
/// @param spring  z = h²W/4ε of its vibration. @param damping  Damping time in steps.
///
/// The trapezoidal rule has nearly the double root −1 for a vibration that the step does not
/// resolve. In a closed loop the end-of-step iteration then feeds it. The shift separates the
/// roots and dissipates nothing. Damping separates them as well.
double newmark_shift(double spring, double damping) noexcept {
    constexpr double kMaxShift = 0.1, kResolvedZ = 0.25;  // hω = 1
    return std::max(0.0, rise(kMaxShift, spring, kResolvedZ) - damping);
}

/// Compute Υ and the factor of ġ in the right-hand side (recall) of a row. The step rarely resolves
/// the axial vibration of a wire's nodes, which would not decay with the trapezoidal rule alone.
/// Rows of wires therefore have a damping time of at least half a step.
Shares shares_of(const Interactions& in, std::size_t row, bool wire, double h) noexcept {
    const double w = in.mobility[row], e = in.epsilon[row];
    const bool joint = (in.row_flags[row] & kRowJoint) != 0;
    double t = in.tau[row], late = 1.0, recall = 1.0, shift = 0.0;
    if (joint && e == 0.0) t = std::max(t, min_damping(e, 0.0) * h);
    if ((in.row_flags[row] & kRowDamper) && w > 0.0 && e > 0.0) {
        const double spring = 0.25 * h * h * w / e;
        if (wire) t = std::max(t, (late_fraction(spring) - 0.5) * h);
        if (joint) {
            t = std::max(t, min_damping(e, spring) * h);
            shift = newmark_shift(spring, t / h);
        }
        late = late_fraction(h * t * w / e + spring);
        recall = 1.0 - 4.0 * t * (1.0 - late) / h;
    }
    const double upsilon = row_upsilon(t, h, late);
    if (shift > 0.0) return {upsilon / (1.0 + 4.0 * shift * upsilon), recall + 4.0 * shift};
    return {upsilon, recall};
}

}  // namespace

void Interactions::split_damping(std::size_t row, bool wire, double h) noexcept {
    recall[row] = 1.0;
    if (row_flags[row] & kRowVelocity) return;
    const Shares s = row_flags[row] & kRowRecoils ? kRecoilShares : shares_of(*this, row, wire, h);
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
        update_damping_of_row(row, rest_length[at(id)] > 0.0, h);
    }
}

double Interactions::sigma_without_floor(std::size_t row, double h) const noexcept {
    return row_flags[row] & kRowVelocity ? velocity_row_sigma(epsilon[row], h)
                                         : row_sigma(epsilon[row], upsilon[row], h);
}

void Interactions::update_damping_of_row(std::size_t row, bool wire, double h) noexcept {
    split_damping(row, wire, h);
    sigma[row] = std::max(row_sigma(epsilon[row], upsilon[row], h), min_sigma[row]);
    if (inv_sigma[row] != 0.0) inv_sigma[row] = 1.0 / sigma[row];
}

}  // namespace hawser::model
