// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file chain.h
/// A wire in a vertical plane as elements and nodes (lumped masses): x towards the last end, z up,
/// the first end at the origin.

#include <hawser/catenary.h>

#include <cstddef>
#include <span>
#include <vector>

namespace hawser::wire {

/// Elements and nodes of any line types.
struct Chain {
    std::vector<double> s;  ///< Material coordinates of the nodes [m]; one more than the elements.
    std::vector<double> length;      ///< Unstretched lengths of the elements [m].
    std::vector<double> compliance;  ///< Elongation of an element per tension [m/N].
    std::vector<double> weight;      ///< Weights of the nodes [N]; 0 at both ends.
    double half_first = 0.0;         ///< Weight of the half element at the first end [N].
    double half_last = 0.0;          ///< Weight of the half element at the last end [N].
    std::vector<double> heavy;       ///< Weight of the elements in air [N].
    std::vector<double> buoyancy;    ///< Buoyancy of the elements when fully in the water [N].
    std::vector<double> diameter;    ///< Diameters of the elements at the surface [m].
    /// EI/l of the nodes [N m]; 0: no bending stiffness, and at both ends.
    std::vector<double> bend;

    [[nodiscard]] std::size_t elements() const noexcept { return length.size(); }
    [[nodiscard]] double total_length() const noexcept { return s.back(); }
    [[nodiscard]] double total_weight() const noexcept;
};

/// Create the chain of a definition.
/// @throws DefError.
[[nodiscard]] Chain make_chain(const CatenaryDef& def);
/// Wet fractions of the halves of each element, at its first and its last node.
struct WetHalves {
    std::vector<double> first, last;
};
/// Compute the weights of the nodes: half of the weight of each adjacent element, less the buoyancy
/// of its submerged fraction.
/// @return the largest change of a weight [N].
double weigh_nodes(Chain& chain, const WetHalves& wet);
/// Return the chain in reversed order, counted from its last end.
[[nodiscard]] Chain reversed(const Chain& chain);

/// Return the rounding error of the sum of the chords of a chain whose ends have this distance [m].
[[nodiscard]] double rounding(const Chain& chain, double distance) noexcept;

/// A shape in the plane. y is sideways, for parts that lie in an arc.
struct Plane {
    /// Chord of each element: along x, y, z from the first to the last end [m].
    std::vector<Vec3> chord;
    std::vector<double> tension;  ///< Tension of each element [N].
    bool slack = false;  ///< true if elements without tension are shorter than their length
    /// Range of nodes on the seabed; first > last: none.
    std::size_t laid_first = 1, laid_last = 0;
};

/// Chord of an element under the pull (h, v), and its derivatives; 0 if it has no pull.
struct Pulled {
    double x = 0.0, z = 0.0, tension = 0.0;
    double x_h = 0.0, x_v = 0.0, z_v = 0.0;  ///< z_h = x_v.
};
[[nodiscard]] Pulled stretched_element(double length, double compliance, double h,
                                       double v) noexcept;

/// Return a polyline with given element lengths from the origin to (chord, 0), as an arc of
/// constant curvature towards positive y. If no arc of these lengths reaches (chord, 0), the
/// elements are shortened.
[[nodiscard]] std::vector<Vec3> arc(std::span<const double> lengths, double chord);

}  // namespace hawser::wire
