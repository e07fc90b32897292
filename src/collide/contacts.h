// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file contacts.h
/// Output of stage collide: contact points, ascending by their keys.

#include <hawser/shapes.h>

#include <cstdint>
#include <vector>

namespace hawser::collide {

inline constexpr int kMaxContactBodies = 4;  ///< Two segments with two ends each.

/// Contact parameters of two materials, from the mixing rules or a material pair.
struct Surface {
    double friction;               ///< Coefficient of friction μ.
    double restitution;            ///< Coefficient of restitution e.
    double compliance;             ///< Normal compliance ε_n of one point [m/N].
    double tangential_compliance;  ///< Tangential compliance ε_t [m/N].
    double damping_time;           ///< Damping time τ [s].
    double rolling, torsional;     ///< Friction lengths [m].
};

/// One contact point. Slots name the bodies that it acts on: first the bodies of side 0, then the
/// bodies of side 1. Bodies without degrees of freedom have slots too.
///
/// The velocity of side s at the point is Σ weight (v + ω × (point − x)) over its slots. If the
/// side has a node and a body that holds the segment, it is Σ weight v + ω × (point − Σ weight x).
struct Contact {
    std::int32_t shape[2];       ///< Shapes of side 0 and side 1; shape[0] < shape[1].
    std::uint32_t feature;       ///< Key within the pair of shapes.
    std::int32_t previous;       ///< Index of this contact in the set of the last step, or −1.
    std::int32_t surface;        ///< Index of its Surface.
    std::uint8_t slots, side_0;  ///< Number of slots; number of slots of side 0, which come first.
    std::int32_t body[kMaxContactBodies];  ///< Body of each slot; −1 after the last one.
    double weight[kMaxContactBodies];      ///< Weight of each slot, > 0; the sum is 1 on each side.
    double normal[3];                      ///< Unit normal from side 0 to side 1, world frame.
    double on[2][3];                       ///< Points on the two surfaces, world frame [m].
    double gap;                            ///< Gap (on[1] − on[0]) · normal [m].
};

struct ContactSet {
    /// Contacts, ascending by (shape 0, shape 1, feature): first the active ones, then the sleeping
    /// ones.
    std::vector<Contact> contacts;
    std::size_t awake = 0;  ///< Number of active contacts.
    std::vector<Surface> surfaces;
};

}  // namespace hawser::collide
