// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file contacts.h
/// What stage collide hands on: contact points in the order of their keys.

#include <hawser/shapes.h>

#include <cstdint>
#include <vector>

namespace hawser::collide {

inline constexpr int kMaxContactBodies = 4;  ///< Two segments of two ends each.

/// How two materials touch: what the mixing rules or a pair gave.
struct Surface {
    double friction;               ///< μ.
    double restitution;            ///< e.
    double compliance;             ///< ε_n of one point [m/N].
    double tangential_compliance;  ///< ε_t [m/N].
    double damping_time;           ///< τ [s].
    double rolling, torsional;     ///< [m].
};

/// One contact point. Slots are the bodies that it acts on: those of side 0, then those of side 1.
/// The velocity of side s at the point is Σ weight (v + ω × (point − x)) over its slots, that of a
/// side with a lump and a body that holds the segment Σ weight v + ω × (point − Σ weight x). Bodies
/// without freedom have slots too.
struct Contact {
    std::int32_t shape[2];       ///< Side 0, side 1; shape[0] < shape[1].
    std::uint32_t feature;       ///< Key within the pair of shapes.
    std::int32_t previous;       ///< Index of the same contact in the last step's set, or −1.
    std::int32_t surface;        ///< Index of its Surface.
    std::uint8_t slots, side_0;  ///< Number of slots; those of side 0 come first.
    std::int32_t body[kMaxContactBodies];  ///< −1 behind the last.
    double weight[kMaxContactBodies];      ///< > 0; they add up to 1 on each side.
    double normal[3];                      ///< Unit, from side 0 to side 1, world frame.
    double on[2][3];                       ///< On the surfaces, world frame [m].
    double gap;                            ///< (on[1] − on[0]) · normal [m].
};

struct ContactSet {
    /// Ascending by (shape 0, shape 1, feature): those that take part, then those that are asleep.
    std::vector<Contact> contacts;
    std::size_t awake = 0;  ///< How many take part.
    std::vector<Surface> surfaces;
};

}  // namespace hawser::collide
