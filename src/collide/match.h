// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file match.h
/// Matching of contacts with each other and with those of the last step.

#include "base/memory.h"
#include "collide/contacts.h"
#include "collide/placing.h"

#include <cstdint>
#include <vector>

namespace hawser::collide {

/// Data of a contact that are kept until the next step; plain data, part of the saved state.
struct KeptContact {
    std::int32_t shape[2];
    std::uint32_t feature;
    std::int32_t zero = 0;  ///< No padding: the state is compared and hashed.
    double at[3];           ///< Point on side 1, see local_point() [m].
};

/// Compute the point of a contact on side 1. If the shape belongs to a body with an orientation,
/// the point is in the frame of the shape. Otherwise it is relative to the middle of the segment or
/// the centre of the sphere, in world axes.
void local_point(const Contact& contact, const Shape& side, const Placed& placed,
                 double* out) noexcept;

/// True if contact i is a duplicate at a node that several segments share.
///
/// Each segment finds the same contact at the end of the wire at its node. n equal contacts would
/// have n times the stiffness. Therefore one segment owns the node (Shape::owner: the one with the
/// lowest index). The contact of another segment is a duplicate if it agrees with a contact of the
/// owner in all of these:
/// 1. the single node on this side;
/// 2. the shape on the other side;
/// 3. the point, to 1e-6 m;
/// 4. the normal.
///
/// A wire of n segments lying on a plane thus touches it in n + 1 points, on any shape. If the
/// owner touches the other shape elsewhere along its length, both contacts stay. Each then carries
/// a fraction that changes smoothly with the motion of the wire. @param contacts  Ascending by
/// their keys.
[[nodiscard]] bool is_duplicate(const std::vector<Contact>& contacts, std::size_t i,
                                const std::vector<Shape>& shapes) noexcept;

/// Set Contact::previous to the contact of the last step with the same key. If there is none, use
/// the nearest contact of the same two shapes without a successor, within `radius` [m] of the same
/// point on side 1. The friction state thus survives a change of feature. @param awake  Number of
/// active contacts of the last step. These come first, then the sleeping ones, both ascending.
/// @param taken  Scratch; resized.
void match(std::vector<Contact>& contacts, const base::Array<KeptContact>& now,
           const base::Array<KeptContact>& last, std::size_t awake, double radius,
           base::Array<std::uint8_t>& taken);

}  // namespace hawser::collide
