// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file arms.h
/// Store the Jacobian of a ball joint between two rigid bodies in compact form: a *compact joint*.
///
/// With the arms r₀, r₁ from the centres of mass to the joint (world frame) its three rows are:
/// ```
///   G = [ −E   r̂₀ │ E   −r̂₁ ],      r̂ v = r × v,
/// ```
/// The Jacobian has 36 entries; 30 are constant or repeat the six entries of the arms. Chains of
/// links consist mostly of such joints, and a step reads each Jacobian several times. Therefore
/// only an *arms record* of one cache line is stored:
/// 1. Entries 0-2: r₀.
/// 2. Entries 3-5: r₁.
/// 3. Entry 6: damping of the relative rotation (assembly/geo.h).
/// 4. Entry 7: constant of the oscillation about the joint (assembly/geo.h).

namespace hawser::model {

inline constexpr int kArms = 8;  ///< Number of doubles of an arms record.
/// Values of Interactions::arms: the Jacobian is compact; the Jacobian is compact and the rows are
/// condensed.
inline constexpr unsigned char kCompactJacobian = 1, kCompactCondensed = 3;
inline constexpr int kArmsDamping = 6, kArmsVibration = 7;
/// Number and width of the packed rows; buffer size in doubles with slack for vector loads.
inline constexpr int kArmRows = 3, kArmWidth = 12, kArmBufferSize = kArmRows * kArmWidth + 8;

/// Write row i of a compact ball joint to `out`: 12 entries, ∓(e_i, r × e_i) for each of the two
/// bodies. Always inline, because it is also used in code compiled per instruction set
/// (base/small.h).
[[gnu::always_inline]] inline void unpack_arm_row(const double* record, int i,
                                                  double* out) noexcept {
    const int next = (i + 1) % 3, last = (i + 2) % 3;
    for (int k = 0; k < kArmWidth; ++k) out[k] = 0.0;
    for (int b = 0; b < 2; ++b) {
        const double sign = b == 0 ? -1.0 : 1.0, *r = record + 3 * b;
        out[6 * b + i] = sign;
        out[6 * b + 3 + next] = sign * r[last];
        out[6 * b + 3 + last] = -sign * r[next];
    }
}

/// Write the three rows of a compact ball joint to `out`. The rest of the kArmBufferSize entries is
/// set to zero.
[[gnu::always_inline]] inline void unpack_arms(const double* record, double* out) noexcept {
    for (int i = 0; i < kArmRows; ++i) unpack_arm_row(record, i, out + kArmWidth * i);
    for (int k = kArmRows * kArmWidth; k < kArmBufferSize; ++k) out[k] = 0.0;
}

/// Return the packed rows of an interaction whose Jacobian begins at `jacobian`. A compact Jacobian
/// is unpacked to `buffer`.
[[nodiscard, gnu::always_inline]] inline const double* packed_rows(
    const double* jacobian, bool arms, double (&buffer)[kArmBufferSize]) noexcept {
    if (!arms) return jacobian;
    unpack_arms(jacobian, buffer);
    return buffer;
}

}  // namespace hawser::model
