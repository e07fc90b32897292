// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file resolution.h
/// Resolution of wires: elements that are as long as tension, curvature and contact let them be.
///
/// ```cpp
/// const hawser::WireId tow = world.add_wire({.name = "tow", …, .consistent_mass = true});
/// world.add(hawser::ResolutionDef{.name = "tow_nodes", .wire = tow, .min_length = 2.5,
///                                 .max_length = 20.0});
/// ```
/// Between steps an element that is too long gets a node in its middle (World::insert_node()), and
/// a node goes whose elements are short enough to be one (World::remove_node()): mass, momentum,
/// angular momentum and energy stay as they do there. Lengths here are those of *material*, the
/// mass of an element over that of a metre: edits share them without rounding away, and no tension
/// changes them. Rest lengths of elements are another account, which follows forces.
///
/// *How long an element may be*: its bound L is the least of
/// - √(8 `sag_error`/κ): the chord of an arc of curvature κ [1/m] lies off by L²κ/8. κ at a node is
///   the angle between its elements over half of their lengths together, and the larger one of its
///   two nodes counts for an element;
/// - `max_angle`/κ, the angle at its nodes;
/// - `wave_period` √(T/ρ)/`points_per_wave`: the shortest wave across that is to be resolved. With
///   a consistent mass matrix it runs too fast by (2π/n)²/24 with n elements to the wave (1 % with
///   12, 2.6 % with 8). T is the mean along the wire and over `averaging`;
/// - `contact_length`, where a segment touches something, and its neighbours; for a node to go also
///   the next ones, since where a wire leaves what it touches segments come near and go;
/// - `drum_length`, next to an element that a drum pays out, so that the drum takes in nodes of the
///   length that it makes (WinchDef::element);
///
/// An element gets a node where it is longer than L or `max_length`, and as long as twice
/// `min_length`. A node goes where its elements together are no longer than `max_length`, nor than
/// L of either over `hysteresis`, and that has been so for `patience`: a wave that passes does not
/// have the wire change to and fro. At most one node comes or goes each time that the wire is
/// looked at, every `interval` steps; wires take turns.
///
/// Elements at drums are the winch's, and what something else holds, carries no mass of its own
/// (consistent_mass), is of a line type that the wire did not have at first or has parted stays as
/// it is. Fixed elements remain possible: without a
/// ResolutionDef nothing changes.
///
/// *Budget.* At a level of World::coarsening() L is 1.5 to its power times as long, limits
/// included, and `patience` is not waited for.
///
/// Signals, as "name.signal". Outputs: `nodes` (of the wire, ends included), `shortest` and
/// `longest` [m] element, `inserted` and `removed` (by this system since the start), `material`
/// [m]: the sum of what elements are made of, those at drums left out. Event `node_limit` where
/// `max_nodes` keeps an element too long.
///
/// Sources: sag of an arc by elementary geometry; consistent mass and its dispersion as in
/// O. C. Zienkiewicz, R. L. Taylor, "The Finite Element Method", vol. 1, ch. 17; hybrid resolution
/// of wires: M. Servin, C. Lacoursière, F. Nordfelth, K. Bodin, IEEE TVCG 17 (2011).
/// Limits: docs/wires.md, "Resolution".

#include <hawser/id.h>
#include <hawser/interactions.h>

#include <cstdint>
#include <string>

namespace hawser {

class World;

/// Resolution of one wire. A definition: World::add copies it whole.
struct ResolutionDef {
    std::string name{};  ///< Unique among systems. Required.
    WireId wire{};       ///< Whose elements have a mass of their own. Required.

    double min_length = 2.5;   ///< No element gets shorter by a node [m], 0.01 to 1e6.
    double max_length = 20.0;  ///< Longest element [m]; from twice `min_length` on.
    int max_nodes = 1000;      ///< Of the wire, ends included; 3 to 100,000.

    double sag_error = 0.05;  ///< Of an element off its arc [m]; 0: no such bound.
    double max_angle = 0.26;  ///< Between elements [rad], to π; 0: no such bound.
    /// Where it touches something [m]; 0: no such bound; twice `min_length`.
    double contact_length = kDefault;
    double drum_length = kDefault;  ///< Next to a drum [m]; length of the element there at first.
    double wave_period = 2.0;       ///< Of the shortest wave across [s]; 0: no such bound.
    double points_per_wave = 8.0;   ///< Elements to it, 2 to 1000.
    double averaging = 10.0;        ///< Time over which tension is averaged [s].
    double hysteresis = 1.5;        ///< 1 to 100: see above.
    double patience = 2.0;          ///< For which a node is not needed before it goes [s].
    int interval = 4;               ///< Steps from one look at the wire to the next, 1 to 10,000.
    /// Of all of the wire [kg/m]; kDefault: of each line type (EA, mass a length) that its elements
    /// have now. Where two meet the node stays.
    double mass_per_length = kDefault;
};

/// What World::add() of it calls. @throws DefError on what is missing or out of range, limits that
/// cross (max_length below twice min_length; a bound by contact or drum beyond them), a name that
/// is taken, a wire that has a resolution already, or none of whose elements has a mass.
void define(World& world, const ResolutionDef& def);

}  // namespace hawser
