// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file drum_geometry.h
/// Geometry of wire on a drum.
///
/// ```
///      flange          layer k turns at r_k = R + d/2 + (k − 1) p
///        |  o o o o o  |   k = 2    d  diameter of the wire
///        | o o o o o o |   k = 1    p  pitch of the layers: d, or √3/2 d where wires lie in
///        grooves
///        |=============|   - - R    R  radius of the bare drum
///        |<---- w ---->|   n = ⌊w/d⌋ wraps a layer
/// ```
/// A full layer k holds n 2π r_k of wire, so that K layers hold
/// ```
///     S(K) = 2π n Σ r_k = 2π n (K (R + d/2) + p K (K − 1)/2)
/// ```
/// The length L on the drum ends in the first layer K with S(K) ≥ L. A wrap is a ring of round wire
/// with the moment of inertia ρ 2π r (r² + 3 d²/16) about the drum's axis (a torus: m (r² + ¾ a²),
/// a = d/2). The wire on the drum has the sum over its wraps.
///
/// At a flange the wire climbs from one layer to the next. Over the wire of one wrap, half before
/// the end of the layer and half behind, the radius at which it leaves (leaving_radius()) changes
/// linearly from r_k to r_{k+1}. The sums above remain valid, because the parts above and below
/// cancel.
///
/// Limits: the helix of a wrap, longer than the circle by ½ (d/2πr)² (2e-4 for r = 8 d), is
/// neglected. Level wind is ideal: the wire leaves at the wrap that is being laid or taken off.

namespace hawser::wire {

struct DrumGeometry {
    double core_radius = 0.0;    ///< R [m].
    double width = 0.0;          ///< w [m].
    double wire_diameter = 0.0;  ///< d [m].
    double layer_pitch = 0.0;    ///< p [m].
    double flange_radius = 0.0;  ///< Largest outer radius of wire [m].

    /// Upper bound of layers, and of wraps in a layer.
    static constexpr int kMaxLayers = 100'000;

    /// Return the number of wraps side by side in a layer, n.
    [[nodiscard]] int wraps_a_layer() const noexcept;
    /// Return the number of layers that fit below the flange.
    [[nodiscard]] int layers() const noexcept;
    /// Return r_k of layer k, 1 the innermost [m].
    [[nodiscard]] double radius(int layer) const noexcept;
    /// Return the length of wire in K full layers, S(K) [m].
    [[nodiscard]] double length_in_layers(int layers) const noexcept;
    /// Return the length of wire that fits below the flange [m].
    [[nodiscard]] double capacity() const noexcept { return length_in_layers(layers()); }

    /// End of a length of wire on the drum.
    struct Place {
        int layer = 1;        ///< 1 the innermost, also for an empty drum.
        double radius = 0.0;  ///< Radius of the layer [m].
        double wraps = 0.0;   ///< Total wraps on the drum.
        /// Position of the level wind along the axis from the middle, −w/2 to w/2 [m].
        double across = 0.0;
    };
    /// Find the end of a length of wire.
    /// @param length  [m]; negative lengths and NaN count as 0. Lengths beyond the capacity fill
    ///        further layers, up to kMaxLayers.
    [[nodiscard]] Place wire_end(double length) const noexcept;
    /// Return the radius at which the wire leaves the drum with a length on it [m].
    [[nodiscard]] double leaving_radius(double length) const noexcept;
    /// Return the angle by which the drum turns from empty to a length [rad].
    [[nodiscard]] double angle(double length) const noexcept;
    /// Return the length of wire on the drum after a turn from empty [m].
    [[nodiscard]] double length(double angle) const noexcept;
    /// Return the inertia of the wire on the drum about its axis [kg m²].
    /// @param mass_per_length  [kg/m].
    [[nodiscard]] double inertia(double length, double mass_per_length) const noexcept;
};

}  // namespace hawser::wire
