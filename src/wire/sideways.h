// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sideways.h
/// Sliding of a wire along the axis of the surface that it lies on.
///
/// Seen on the unrolled surface a wire comes at the angle β₁ to the axis and leaves at β₂:
/// ```
///     ────────────┼──────────── axis        On a cylinder of radius R a piece ds presses with
///            β₂ .'│                         T sin²β/R ds and pulls sideways, in the surface and
///        .   .'   │                         across itself, with T dβ. It stays while Coulomb's
///          '○     │ s                       law holds that, |dβ| ≤ μ sin²β/R ds; with
///          .' β₁  │                         R dφ = sin β ds
///        .'       │                             |dβ/dφ| ≤ μ sin β,
/// ```
/// Over the whole angle φ by which it turns about the axis this gives:
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
/// across the axis. The function f grows with s and is 0 at the shortest path, with equal angles on
/// both sides. If |f| exceeds the bound, the position moves towards that point until |f| = μφ,
/// which has one solution.
///
/// Sliding adds no energy: d(path)/ds = cos β₁ − cos β₂ has the sign of f, so the path between the
/// nodes becomes shorter. The parts keep the ratio of their tensions by rest length that passes
/// from one to the other.
///
/// Limits: friction along the wire and across it are bounded separately, each by μ times the normal
/// force. Together they may reach √2 of it. A wire that runs along does not slide sideways more
/// easily. The axial advance of the wire on the wheel is neglected.

namespace hawser::wire {

/// A wire that crosses a surface, relative to its position there.
struct Crossing {
    double along[2];   ///< Distances to the nodes before and behind, along the axis [m].
    double across[2];  ///< The straight parts, across the axis [m]; above 0.
};

/// Return f(s) of the law of sideways friction in the file header, at a position [rad].
/// @param s  Position relative to the present one [m].
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
/// Return the rest length that passes from the second part to the first so that the ratio of
/// strains is kept [m].
[[nodiscard]] double length_to_feed(const Parts& parts) noexcept;

}  // namespace hawser::wire
