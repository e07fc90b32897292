// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file chain.h
/// A wire to be laid out, as elements and lumps in a vertical plane: x towards the last end, z up,
/// the first end at the origin.

#include <hawser/catenary.h>

#include <cstddef>
#include <span>
#include <vector>

namespace hawser::wire {

/// Elements and lumps, whatever line types they are of.
struct Chain {
    std::vector<double> s;           ///< Of the nodes [m]; one more than the elements.
    std::vector<double> length;      ///< Of the elements, unstretched [m].
    std::vector<double> compliance;  ///< Elongation of an element per tension [m/N].
    std::vector<double> weight;      ///< Of the nodes [N]; 0 at both ends.
    double half_first = 0.0;         ///< Weight of the half element at the first end [N].
    double half_last = 0.0;          ///< And at the last [N].
    std::vector<double> heavy;       ///< Weight of the elements in air [N].
    std::vector<double> buoyancy;    ///< Of the elements, wholly in the water [N].
    std::vector<double> diameter;    ///< Of the elements where they cut the surface [m].
    std::vector<double> bend;        ///< EI/l of the nodes [N m]; 0: none, and at both ends.

    [[nodiscard]] std::size_t elements() const noexcept { return length.size(); }
    [[nodiscard]] double total_length() const noexcept { return s.back(); }
    [[nodiscard]] double total_weight() const noexcept;
};

/// Make the chain of a definition. @throws DefError.
[[nodiscard]] Chain make_chain(const CatenaryDef& def);
/// Shares of the elements' halves that are in the water, at the first and the last node of each.
struct WetHalves {
    std::vector<double> first, last;
};
/// Sum the weights of halves at the nodes, less the buoyancy of their wet shares. @return the
/// largest change of a weight [N].
double weigh_nodes(Chain& chain, const WetHalves& wet);
/// The same chain counted from its last end.
[[nodiscard]] Chain reversed(const Chain& chain);

/// What the sums of its chords are not known better than, ends this far apart [m].
[[nodiscard]] double rounding(const Chain& chain, double distance) noexcept;

/// A shape in the plane; y is sideways, for what lies in an arc.
struct Plane {
    /// Of the elements, by index: along x, y, z from the first to the last end [m].
    std::vector<Vec3> chord;
    std::vector<double> tension;  ///< Of the elements [N].
    bool slack = false;           ///< Elements without tension are shorter than they might be.
    /// Nodes on the seabed, first and last; first > last: none.
    std::size_t laid_first = 1, laid_last = 0;
};

/// Chord of an element that pulls with (h, v), and its derivatives; 0 where it does not pull.
struct Pulled {
    double x = 0.0, z = 0.0, tension = 0.0;
    double x_h = 0.0, x_v = 0.0, z_v = 0.0;  ///< z_h = x_v.
};
[[nodiscard]] Pulled pulled(double length, double compliance, double h, double v) noexcept;

/// A polyline of these lengths in a plane, from the origin to (chord, 0), as an arc of even
/// curvature to positive y. Where it cannot close so far its elements are shortened.
[[nodiscard]] std::vector<Vec3> arc(std::span<const double> lengths, double chord);

}  // namespace hawser::wire
