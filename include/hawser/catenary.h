// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file catenary.h
/// Static equilibrium of a wire with lumped masses between two points, with or without a seabed.
///
/// A wire of a world is a row of nodes joined by straight elements that carry tension only. The
/// result is the equilibrium of this discrete wire, not of a smooth curve, so that nodes placed
/// there stay at rest:
/// ```
///     from o                        T_{k+1} u_{k+1} − T_k u_k + W_k = 0 at each hanging node k:
///           \                  o to T_k tension, u_k direction of element k, W_k weight
///            o             o
///              o ─── o ─── o ───────── seabed
/// ```
/// Each inner node carries half the weight of the adjacent elements. The half element at an end
/// belongs to the holding body and is in no equilibrium equation (WireDef adds it to no body). A
/// smooth wire pulls at an end with the tension of the last element and the weight of half an
/// element (pull_from, weight_from). Derivation: docs/theory/catenary.md.

#include <hawser/math.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace hawser {

/// Section of a wire with one line type.
struct CatenarySection {
    double length = 0.0;  ///< Unstretched length [m]. Required.
    double weight = 0.0;  ///< Weight in the surrounding medium per unstretched length [N/m]; < 0:
                          ///< buoyant.
    double EA = 0.0;      ///< Axial stiffness [N]. Required.
    int elements = 1;     ///< Number of equal elements, unless CatenaryDef::nodes sets the nodes.
    double EI = 0.0;      ///< Bending stiffness [N m²]; 0: none.
    /// With CatenaryDef::water only: weight of the displaced water per unstretched length [N/m],
    /// and diameter over which the section emerges [m].
    double buoyancy = 0.0, diameter = 0.0;
};

/// Level, rigid seabed. An end may be up to half an element below it, because nodes with a contact
/// radius lie higher than an anchor by that radius.
struct FlatSeabed {
    double height = 0.0;    ///< Height of nodes that lie on it, upwards (against
                            ///< CatenaryDef::down) from the origin [m].
    double friction = 0.0;  ///< Coulomb friction coefficient along the wire [1], ≥ 0.
};

/// Input of the equilibrium.
struct CatenaryDef {
    Vec3 from{0.0, 0.0, 0.0};  ///< Position of the first end, world frame [m].
    Vec3 to{0.0, 0.0, 0.0};    ///< Position of the last end, world frame [m].
    /// True: the last end is free, and `to` only gives a direction. The wire hangs straight down
    /// from the first end; its rest lies on the seabed in the direction of `to`, without tension.
    /// The last node carries half an element.
    bool free = false;
    std::vector<CatenarySection> sections{};  ///< Sections from the first end, at least one.
    /// Material coordinates of the inner nodes [m], ascending, between 0 and the length. Empty:
    /// from the sections. An element may extend over two sections.
    std::vector<double> nodes{};
    Vec3 down{0.0, 0.0, -1.0};           ///< Direction of gravity, any length but 0.
    std::optional<FlatSeabed> seabed{};  ///< Seabed; none: the wire hangs freely.
    /// Height of still water, upwards from the origin [m]; none: no water. CatenarySection::weight
    /// is then the weight in air, and half elements have buoyancy for their wet part, as in a sea
    /// (sea.h).
    std::optional<double> water{};
    /// Permitted residual force at a node, relative to the largest weight of a node [1]. The force
    /// that rounding of positions causes in the elements is permitted in addition.
    double tolerance = 1e-6;
};

/// Result of the equilibrium computation.
enum class CatenaryStatus : std::uint8_t {
    balanced,      ///< In equilibrium; the shape is unique, with its friction.
    slack,         ///< In equilibrium with elements without tension; other shapes exist.
    below_seabed,  ///< An end is far below the seabed; the shape ignores the seabed.
    unbalanced,    ///< A residual exceeds the tolerance; the shape is the best one found.
};
/// Return the name of a status, as in its enumerator.
[[nodiscard]] const char* to_string(CatenaryStatus status) noexcept;

/// Equilibrium shape of a wire. At any status, no value but laid_from and laid_to is NaN.
struct Catenary {
    CatenaryStatus status = CatenaryStatus::balanced;
    std::vector<double> s{};        ///< Material coordinates of the nodes, ends included [m].
    std::vector<Vec3> nodes{};      ///< Positions of the nodes [m]; the ends as given.
    std::vector<double> tension{};  ///< Tensions of the elements, one fewer than nodes [N].
    /// Forces of the first and last element on the bodies that hold them, world frame [N].
    Vec3 pull_from{0.0, 0.0, 0.0};
    Vec3 pull_to{0.0, 0.0, 0.0};
    double weight_from = 0.0;  ///< Weight of the half element at the first end, which no node
                               ///< carries [N].
    double weight_to = 0.0;    ///< Weight of the half element at the last end [N]; 0 if the end is
                               ///< free.
    /// Material coordinates of the first and last node on the seabed [m]; NaN: none.
    double laid_from = std::numeric_limits<double>::quiet_NaN();
    double laid_to = std::numeric_limits<double>::quiet_NaN();
    double residual = 0.0;  ///< Largest residual force at a node, with the best friction force [N].
    double allowed = 0.0;   ///< Permitted residual force at that node [N].

    /// True if a node lies on the seabed.
    [[nodiscard]] bool touches() const noexcept { return laid_from == laid_from; }  // not NaN
    /// Return the largest tension of an element [N].
    [[nodiscard]] double largest() const noexcept;
};

/// Compute the equilibrium of a wire. The wire may be taut or slack, level, steep or vertical, and
/// partly or wholly on the seabed. From each touchdown point the tension along the seabed decreases
/// by friction times weight, to no less than 0. If both ends are on the seabed, the tension is
/// constant. A wire that is too long to lie straight lies in an arc. Buoyant sections are permitted
/// if they stay clear of the seabed. Cost: a few hundred sums over all nodes.
///
/// Three cases need a further solution: bending stiffness, net buoyancy in water, and buoyant
/// sections over a seabed. Their shape is the minimum of the potential energy, which Newton's
/// method finds from the shape above (wire/rest.h). Slack shapes remain without bending. If the
/// minimum is not found to the tolerance, the shape without bending is returned.
/// @throws DefError if lengths, stiffnesses or counts are invalid.
[[nodiscard]] Catenary catenary(const CatenaryDef& def);

}  // namespace hawser
