// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file sideways.h
/// How a wire slides along the axis of what it lies on.
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
/// and over the whole angle φ by which it turns about the axis
/// ```
///     |ln tan(β₂/2) − ln tan(β₁/2)| ≤ μφ.
/// ```
/// The tension and the radius are not in it, so that it holds at a rounded edge as well: what
/// Euler's ratio is along the wire, this is across it. With cot β = way along the axis over the
/// straight part across it, ln tan(β/2) = −arsinh(cot β), it is a function of the place s,
/// ```
///     f(s) = arsinh((s − z₁)/p₁) + arsinh((s − z₂)/p₂),      |f(s)| ≤ μφ
/// ```
/// z₁ and z₂ of the nodes on both sides, p₁ and p₂ their straight parts across the axis. f grows
/// with s and is 0 where the way is shortest, equal angles on both sides. Where |f| is beyond the
/// bound the place goes towards there until |f| = μφ, which has one solution.
///
/// It makes no energy: d(path)/ds = cos β₁ − cos β₂ has the sign of f, so that the way between the
/// nodes gets shorter. The parts keep the ratio of their tensions, by rest length that goes from
/// one to the other.
///
/// Limits: friction along the wire and across it are bounded apart, each by μ times what the wire
/// presses with: both at once may reach √2 of it. A wire that runs along does not slide sideways
/// more easily. The wire advances along the axis by nothing while it lies on the wheel.

namespace hawser::wire {

/// Where a wire crosses what it lies on, seen from its place.
struct Crossing {
    double along[2];   ///< To the nodes before and behind, along the axis [m].
    double across[2];  ///< The straight parts, across the axis [m]; above 0.
};

/// f at a place [rad]. @param s  From the present one [m].
[[nodiscard]] double lean(const Crossing& c, double s) noexcept;

/// How far the place goes [m]; 0: friction holds it. No farther than a quarter of the shorter part
/// at once. @param bound  μφ [rad].
[[nodiscard]] double way_sideways(const Crossing& c, double bound) noexcept;

/// Two parts of a line.
struct Parts {
    double rest[2];     ///< Without tension [m].
    double longer[2];   ///< By how much they are stretched [m]; below 0: slack.
    double changes[2];  ///< By which their ways are about to change [m].
};
/// Rest length that goes from the second one to the first, so that the strains of both keep their
/// ratio [m].
[[nodiscard]] double fed_between(const Parts& parts) noexcept;

}  // namespace hawser::wire
