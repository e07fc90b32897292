// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file arms.h
/// The compact form of the Jacobian of a ball joint between two rigid bodies: a *compact joint*.
///
/// With the arms r₀, r₁ from the centres of mass to the joint (world frame) its three rows are
/// ```
///   G = [ −E   r̂₀ │ E   −r̂₁ ],      r̂ v = r × v,
/// ```
/// 36 entries of which 30 are known or repeat the six of the arms. Chains of links have little
/// else, and their steps read it again and again, so that only an *arms record* is kept, a cache
/// line: 0-2 r₀; 3-5 r₁; 6 damping of the relative rotation, and 7 the swing number's constant,
/// both of assembly/geo.h.

namespace hawser::model {

inline constexpr int kArms = 8;  ///< Doubles of an arms record.
/// What Interactions::arms says: the Jacobian is compact; it is, and the rows are condensed.
inline constexpr unsigned char kCompactJacobian = 1, kCompactCondensed = 3;
inline constexpr int kArmsDamping = 6, kArmsSwing = 7;
/// Doubles of the packed rows, and slack for vector loads.
inline constexpr int kArmRows = 3, kArmWidth = 12, kArmRoom = kArmRows * kArmWidth + 8;

/// Row i, twelve wide, into `out`: for both bodies ∓(e_i, r × e_i). Always inline: also for code
/// compiled per instruction set (base/small.h).
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

/// The three rows into `out`, of kArmRoom, with zeros behind them.
[[gnu::always_inline]] inline void unpack_arms(const double* record, double* out) noexcept {
    for (int i = 0; i < kArmRows; ++i) unpack_arm_row(record, i, out + kArmWidth * i);
    for (int k = kArmRows * kArmWidth; k < kArmRoom; ++k) out[k] = 0.0;
}

/// Packed rows of an interaction whose Jacobian begins at `jacobian`, in `room` if it is compact.
[[nodiscard, gnu::always_inline]] inline const double* packed_rows(
    const double* jacobian, bool arms, double (&room)[kArmRoom]) noexcept {
    if (!arms) return jacobian;
    unpack_arms(jacobian, room);
    return room;
}

}  // namespace hawser::model
