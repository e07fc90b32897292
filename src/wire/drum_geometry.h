// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file drum_geometry.h
/// How wire lies on a drum.
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
/// and the layer that the length L on the drum ends in is the first K with S(K) ≥ L. A wrap is a
/// ring of a round wire, of the moment of inertia ρ 2π r (r² + 3 d²/16) about the drum's axis
/// (a torus: m (r² + ¾ a²), a = d/2), of which the wire on the drum has the sum.
///
/// At a flange the wire climbs from one layer to the next: over the wire of one wrap, half before
/// the layer ends and half behind, the radius that it leaves at (leaving_radius()) goes from r_k to
/// r_{k+1} evenly. The sums above stay, as much of a wrap is below them as above.
///
/// Not part of it: the helix of a wrap, longer than the circle by ½ (d/2πr)² (2e-4 for r = 8 d).
/// Level wind is ideal: the wire leaves at the wrap that is being laid or taken.

namespace hawser::wire {

struct DrumGeometry {
    double core_radius = 0.0;    ///< R [m].
    double width = 0.0;          ///< w [m].
    double wire_diameter = 0.0;  ///< d [m].
    double layer_pitch = 0.0;    ///< p [m].
    double flange_radius = 0.0;  ///< Wire does not stand above it [m].

    /// Most layers, and most wraps of a layer, that are counted.
    static constexpr int kMostLayers = 100'000;

    /// Turns side by side in a layer, n.
    [[nodiscard]] int wraps_a_layer() const noexcept;
    /// Layers that fit below the flange.
    [[nodiscard]] int layers() const noexcept;
    /// r_k of layer k, 1 the innermost [m].
    [[nodiscard]] double radius(int layer) const noexcept;
    /// Length of wire in K full layers, S(K) [m].
    [[nodiscard]] double length_of(int layers) const noexcept;
    /// Length of wire that fits below the flange [m].
    [[nodiscard]] double capacity() const noexcept { return length_of(layers()); }

    /// Where wire of a length on the drum ends.
    struct Place {
        int layer = 1;        ///< 1 the innermost, also of an empty drum.
        double radius = 0.0;  ///< r of it [m].
        double wraps = 0.0;   ///< On the drum, in all.
        double across = 0.0;  ///< Level wind: along the axis from the middle, −w/2 to w/2 [m].
    };
    /// @param length  [m]; below 0 and NaN as 0, beyond the capacity on further layers, up to
    /// kMostLayers.
    [[nodiscard]] Place place(double length) const noexcept;
    /// Radius at which the wire leaves the drum with a length on it [m].
    [[nodiscard]] double leaving_radius(double length) const noexcept;
    /// Angle by which the drum has turned from empty to hold a length [rad].
    [[nodiscard]] double angle(double length) const noexcept;
    /// Length of wire on the drum when it has turned by an angle from empty [m].
    [[nodiscard]] double length(double angle) const noexcept;
    /// Inertia of the wire on the drum about its axis [kg m²]. @param mass_per_length  [kg/m].
    [[nodiscard]] double inertia(double length, double mass_per_length) const noexcept;
};

}  // namespace hawser::wire
