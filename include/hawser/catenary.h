// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file catenary.h
/// The shape in which a wire of lumps rests between two points, over a seabed or without one.
///
/// A wire of a world is a row of lumps joined by straight elements that pull and do not push. What
/// is found here is its own static balance, not points of a smooth curve: put its lumps there, and
/// they stay. Each inner node carries half the weight of the elements beside it; the half at an
/// end belongs to what holds that end and is in nobody's balance (WireDef adds it to no body).
/// A smooth wire of the same ends therefore pulls at an end with the tension of the last element
/// and, along the vertical, the weight of half an element: pull_from and weight_from.
/// Derivation: docs/wires.md.

#include <hawser/math.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace hawser {

/// A piece of a wire of one line type.
struct CatenarySection {
    double length = 0.0;  ///< Unstretched [m]. Required.
    double weight = 0.0;  ///< Per unstretched length in what surrounds it [N/m]; negative: floats.
    double EA = 0.0;      ///< Axial stiffness [N]. Required.
    int elements = 1;     ///< Equal ones; unless CatenaryDef::nodes says where nodes are.
    double EI = 0.0;      ///< Bending stiffness [N m²]; 0: none.
    /// Of CatenaryDef::water alone: weight of the water that it displaces, per unstretched length
    /// [N/m], and the diameter over which it comes out of the water [m].
    double buoyancy = 0.0, diameter = 0.0;
};

/// A level, rigid bottom. An end may lie under it by up to half of the element there: nodes that
/// touch by a radius lie that much higher than an anchor.
struct FlatSeabed {
    double height = 0.0;    ///< Of the bottom for nodes, against `down` from the origin [m].
    double friction = 0.0;  ///< Coulomb coefficient along the wire; 0 or more.
};

/// A wire to be laid out.
struct CatenaryDef {
    Vec3 from{0.0, 0.0, 0.0};  ///< Where its first end is held, world frame [m].
    Vec3 to{0.0, 0.0, 0.0};    ///< Where its last end is held [m].
    /// The last end is free: the wire hangs straight down from the first, and what of it reaches
    /// the seabed lies from there towards `to`, without tension. Its last node has half an element.
    bool free = false;
    std::vector<CatenarySection> sections{};  ///< From the first end on. At least one.
    /// Material coordinates of the inner nodes [m], ascending, between 0 and the length; empty: as
    /// the sections have them. An element may lie in two sections.
    std::vector<double> nodes{};
    Vec3 down{0.0, 0.0, -1.0};           ///< Direction of gravity, any length but 0.
    std::optional<FlatSeabed> seabed{};  ///< None: nothing is in its way.
    /// Height of still water, against `down` from the origin [m]. Sections then have their weight
    /// in air, and half elements their buoyancy as far as they are wet, as in a sea (sea.h).
    std::optional<double> water{};
    /// Force that may be left at a node, as a part of the heaviest node's weight. What the last
    /// digits of positions let an element pull is allowed beside it.
    double tolerance = 1e-6;
};

enum class CatenaryStatus : std::uint8_t {
    balanced,      ///< In balance, and the only shape that is, with its friction.
    slack,         ///< In balance with elements without tension, which might lie otherwise.
    below_seabed,  ///< An end lies deep under the seabed, which was left out.
    unbalanced,    ///< More than the tolerance is left at a node: the best shape found.
};
[[nodiscard]] const char* to_string(CatenaryStatus status) noexcept;

/// A wire laid out. Whatever the status, no number is NaN but laid_from and laid_to.
struct Catenary {
    CatenaryStatus status = CatenaryStatus::balanced;
    std::vector<double> s{};        ///< Material coordinates of the nodes, ends included [m].
    std::vector<Vec3> nodes{};      ///< Where they are [m]; the ends as given.
    std::vector<double> tension{};  ///< Of the elements, one fewer than the nodes [N].
    Vec3 pull_from{0.0, 0.0, 0.0};  ///< Of the first element on what holds it [N].
    Vec3 pull_to{0.0, 0.0, 0.0};    ///< Of the last element on what holds it [N].
    double weight_from = 0.0;  ///< Of the half element at the first end, carried by no node [N].
    double weight_to = 0.0;    ///< Of the half element at the last end [N]; 0 where it is free.
    /// Material coordinates of the first and the last node on the seabed [m]; NaN: none is.
    double laid_from = std::numeric_limits<double>::quiet_NaN();
    double laid_to = std::numeric_limits<double>::quiet_NaN();
    double residual = 0.0;  ///< Largest force left at a node, friction at its best [N].
    double allowed = 0.0;   ///< What the tolerance allowed there [N].

    [[nodiscard]] bool touches() const noexcept { return laid_from == laid_from; }
    /// Largest tension of an element [N].
    [[nodiscard]] double largest() const noexcept;
};

/// Lay out a wire: over or under its length, level, steep or vertical, taut, slack, partly or
/// wholly on the seabed. From each touchdown point the tension along the laid part of the wire
/// falls by friction times weight, to no less than 0; a wire with both ends on the seabed has the
/// same tension everywhere. A wire too long to lie straight lies in an arc. Sections that float are
/// laid out as long as they stay clear of the seabed. Takes some hundred sums over all nodes.
///
/// With bending stiffness, with buoyancy that floats, and with sections that float over a seabed,
/// the shape is the minimum of the potential energy, found by Newton's method from the shape above
/// (wire/rest.h). Slack shapes stay as they are without bending. If the minimum is not found to the
/// tolerance, the shape without bending is returned.
/// @throws DefError  for lengths, stiffnesses or numbers that no wire has.
[[nodiscard]] Catenary catenary(const CatenaryDef& def);

}  // namespace hawser
