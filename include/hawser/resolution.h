// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file resolution.h
/// Adaptive resolution of wires: element lengths by tension, curvature and contact.
///
/// ```cpp
/// const hawser::WireId tow = world.wires().add({.name = "tow", …, .consistent_mass = true});
/// world.add(hawser::ResolutionDef{.name = "tow_nodes", .wire = tow, .min_length = 2.5,
///                                 .max_length = 20.0});
/// ```
/// Between steps a node is inserted in the middle of an element that is too long
/// (WorldWires::insert_node()). A node is removed if its two elements are short enough to be
/// replaced by one (WorldWires::remove_node()). These functions conserve mass, momentum and angular
/// momentum; energy is conserved or decreases. All lengths of this header are *material* lengths:
/// mass of an element over mass per length. Tension does not change them, and edits divide them
/// exactly. Rest lengths are separate quantities, which edits adapt to the forces.
///
/// *Bounds*. The upper bound L of an element's length is the smallest of
///
/// 1. √(8 `sag_error`/κ). The chord of an arc of curvature κ [1/m] deviates by L²κ/8. At a node, κ
///    is the angle between its elements over half of their total length. An element uses the larger
///    value of its nodes.
///
/// 2. `max_angle`/κ, the angle at its nodes.
///
/// 3. `wave_period` √(T/ρ)/`points_per_wave`, for the shortest transverse wave. With a consistent
///    mass matrix and n elements per wavelength it is too fast by (2π/n)²/24: 1 % with 12, 2.6 %
///    with 8. T is the mean along the wire and over `averaging`.
///
/// 4. `contact_length`, for segments in contact and their neighbours. Before the removal of a node
/// it
///    also applies to the neighbours of these, since segments near the end of a contact touch
///    intermittently.
///
/// 5. `drum_length`, next to an element at a drum, so that the drum hauls in nodes of its own
///    spacing (WinchDef::element).
///
/// *Edits*. An element gets a node if it is longer than L or `max_length`, and at least twice
/// `min_length`. A node is removed if the sum of its two elements is at most `max_length`, and at
/// most L/`hysteresis` of each. This must be true for the time `patience`, so that passing waves
/// cause no repeated edits. Each wire is checked every `interval` steps, and a check inserts or
/// removes at most one node. Different wires are checked in different steps.
///
/// *Excluded elements*. Elements at drums belong to the winch. Elements are also unchanged if
/// another object holds them, if they have no mass (consistent_mass), if they are broken, or if the
/// wire did not have their line type at the start. Without a ResolutionDef the elements of a wire
/// are constant.
///
/// *Budget*. If the time of a step is limited, coarser wires save work. At the coarsening level n
/// of WorldSolver::coarsening(), L and its limits are multiplied by 1.5ⁿ, and `patience` is
/// ignored.
///
/// Outputs, as "name.signal":
/// - `nodes`: number of nodes of the wire, ends included;
/// - `shortest`, `longest`: lengths of the shortest and longest element [m];
/// - `inserted`, `removed`: numbers of nodes since the start;
/// - `material`: total material length without elements at drums [m].
///
/// Event: `node_limit` if `max_nodes` prevents the division of an element that is too long.
///
/// Sources: sag of an arc by elementary geometry. Consistent mass and its dispersion: O. C.
/// Zienkiewicz, R. L. Taylor, "The Finite Element Method", vol. 1, ch. 17. Hybrid resolution of
/// wires: M. Servin, C. Lacoursière, F. Nordfelth, K. Bodin, IEEE TVCG 17 (2011).
///
/// Limits: docs/theory/resolution.md.

#include <hawser/id.h>
#include <hawser/interactions.h>

#include <cstdint>
#include <string>

namespace hawser {

class World;

/// Resolution of one wire. World::add() copies the definition.
struct ResolutionDef {
    std::string name{};  ///< Unique name among systems. Required.
    WireId wire{};       ///< Wire whose elements have mass. Required.

    double min_length = 2.5;   ///< Smallest element length after an insertion [m], 0.01 to 1e6.
    double max_length = 20.0;  ///< Largest element length [m]; at least twice `min_length`.
    int max_nodes = 1000;  ///< Largest number of nodes of the wire, ends included; 3 to 100,000.

    double sag_error = 0.05;  ///< Largest deviation of an element from its arc [m]; 0: no bound.
    double max_angle = 0.26;  ///< Largest angle between elements [rad], to π; 0: no bound.
    /// Largest element length at contacts [m]; 0: no bound; default: twice `min_length`.
    double contact_length = kDefault;
    double drum_length = kDefault;  ///< Largest element length next to a drum [m]; default: initial
                                    ///< length of the element there.
    double wave_period = 2.0;       ///< Period of the shortest transverse wave [s]; 0: no bound.
    double points_per_wave = 8.0;   ///< Elements per wavelength, 2 to 1000.
    double averaging = 10.0;        ///< Averaging time of the tension [s].
    double hysteresis = 1.5;  ///< Ratio of the bound for insertion to that for removal [1], 1 to
                              ///< 100.
    double patience = 2.0;    ///< Time for which a node must be unnecessary before its removal [s].
    int interval = 4;         ///< Steps between checks of the wire, 1 to 10,000.
    /// Mass per length of the whole wire [kg/m]. Default: that of each line type (EA, mass per
    /// length) of the present elements. A node between two line types stays.
    double mass_per_length = kDefault;
};

/// Add a resolution; World::add() calls it.
/// @throws DefError if a required field is missing or a value is out of range
/// @throws DefError if limits conflict: max_length below twice min_length, or a contact or drum
/// length beyond them
/// @throws DefError if the name is already used, or the wire has a resolution already, or its
/// elements have no mass
void define(World& world, const ResolutionDef& def);

}  // namespace hawser
