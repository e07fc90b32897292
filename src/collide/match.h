// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file match.h
/// Contacts of this step held against each other and against those of the last one.

#include "base/memory.h"
#include "collide/contacts.h"
#include "collide/placing.h"

#include <cstdint>
#include <vector>

namespace hawser::collide {

/// What is remembered of a contact until the next step: plain data, part of the saved state.
struct KeptContact {
    std::int32_t shape[2];
    std::uint32_t feature;
    std::int32_t zero = 0;  ///< No bytes without a value: the state is compared and hashed.
    double at[3];           ///< On side 1, see local_point() [m].
};

/// The point of a contact on side 1, in the frame of its shape where that belongs to a body with
/// an orientation; else from the middle of the segment or the centre of the sphere, in the world's
/// axes.
void local_point(const Contact& contact, const Shape& side, const Placed& placed,
                 double* out) noexcept;

/// Contacts at a lump that several segments share: each of them finds the lump's end of the wire
/// touching the same thing at the same place, and n times the same contact would have n times the
/// stiffness. One segment owns the lump (Shape::owner: that with the lowest index), and the contact
/// of another one is left out where the owner has the same: the same lump alone on this side, the
/// same shape opposite, the same point to 1e-6 m and the same normal. So a wire of n segments lying
/// on a plane touches it in n + 1 points, whatever it slides over. Where the owner touches the
/// other shape elsewhere along its length both stay: each carries its share, which changes
/// smoothly as the wire moves.
/// @param contacts  Ascending by their keys. @return whether contact i is one to leave out.
[[nodiscard]] bool is_duplicate(const std::vector<Contact>& contacts, std::size_t i,
                                const std::vector<Shape>& shapes) noexcept;

/// Fill in Contact::previous. The same key, else the nearest one of the same two shapes that has
/// no successor yet and is within `radius` [m] of the same place on side 1: memory of friction
/// outlives a change of feature. @param awake  So many of the last step's contacts were awake:
/// these come first, then those that slept, both ascending. @param taken  Scratch; resized.
void match(std::vector<Contact>& contacts, const base::Array<KeptContact>& now,
           const base::Array<KeptContact>& last, std::size_t awake, double radius,
           base::Array<std::uint8_t>& taken);

}  // namespace hawser::collide
