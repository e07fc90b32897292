// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sideways.h
/// Sliding of a wire on a cylinder along the axis.
///
/// On the unrolled surface a wire arrives at the angle β₁ to the axis and leaves at β₂:
/// ```
///     ────────────┼──────────── axis        On a cylinder of radius R a piece ds presses with
///            β₂ .'│                         T sin²β/R ds and pulls sideways, in the surface and
///        .   .'   │                         across itself, with T dβ. It sticks while, by
///          '○     │ s                       Coulomb's law, |dβ| ≤ μ sin²β/R ds; with
///          .' β₁  │                         R dφ = sin β ds
///        .'       │                             |dβ/dφ| ≤ μ sin β,
/// ```
/// Integrated over the angle φ by which the wire turns about the axis, the condition is:
/// ```
///     |ln tan(β₂/2) − ln tan(β₁/2)| ≤ μφ.
/// ```
/// Tension and radius cancel, so the law also holds at a rounded edge. It is the transverse
/// counterpart of Euler's ratio along the wire. Let cot β = distance along the axis over the
/// straight part across it. With ln tan(β/2) = −arsinh(cot β) this is a function of the position s,
/// ```
///     f(s) = arsinh((s − z₁)/p₁) + arsinh((s − z₂)/p₂),      |f(s)| ≤ μφ
/// ```
/// Here z₁ and z₂ are the positions of the nodes on both sides, p₁ and p₂ their straight parts
/// across the axis. The function f increases with s and is 0 at the shortest path, with equal
/// angles on both sides. If |f| exceeds the bound, the position moves towards that point until |f|
/// = μφ, which has one solution.
///
/// Sliding adds no energy: d(path)/ds = cos β₁ − cos β₂ has the sign of f, so the path between the
/// nodes becomes shorter. Rest length is transferred from one part to the other, so that the
/// ratio of their tensions does not change.
///
/// Limits: friction along the wire and across it are bounded separately, each by μ times the normal
/// force. Their resultant may reach √2 times this bound. Sliding of a wire along itself does not
/// reduce its sideways friction. The axial advance of the wire on the wheel is neglected.

namespace hawser::wire {

/// A wire that crosses a surface, relative to its position there.
struct Crossing {
    double along[2];   ///< Distances to the nodes before and behind, along the axis [m].
    double across[2];  ///< The straight parts, across the axis [m]; above 0.
};

/// Return f(s), the sideways pull of the wire on the bollard as an angle, by the formula at the
/// head of this file [rad].
/// @param s  Position along the axis, relative to the present one [m].
[[nodiscard]] double sideways_balance(const Crossing& c, double s) noexcept;

/// Return the displacement of the position, at most a quarter of the shorter part [m]; 0: it
/// sticks.
/// @param bound  μφ [rad].
[[nodiscard]] double sideways_displacement(const Crossing& c, double bound) noexcept;

/// Two parts of a line.
struct Parts {
    double rest[2];     ///< Rest lengths [m].
    double longer[2];   ///< Elongations [m]; negative: slack.
    double changes[2];  ///< Coming changes of their paths [m].
};
/// Return the rest length to transfer from the second part to the first so that the ratio of their
/// strains remains [m].
[[nodiscard]] double length_to_feed(const Parts& parts) noexcept;

}  // namespace hawser::wire
