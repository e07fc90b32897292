// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file id.h
/// Ids of the objects of a World, with a separate type for each kind of object.
///
/// An id has an index and a generation. Indices count from 0 in the order of additions to one
/// World. A removal frees the index. A later object of the same kind gets the first suitable free
/// index, with the next generation:
/// ```
///     add a, b, c          (0, 0) (1, 0) (2, 0)
///     remove b             (0, 0)        (2, 0)
///     add d                (0, 0) (1, 1) (2, 0)      (1, 0) is rejected from now on: it was b
/// ```
/// An object keeps its index until it is removed, so that arrays by index stay valid. Before the
/// first removal all generations are 0, and `BodyId{i}` is the body added as number i, from 0. A
/// default-constructed id is invalid. Ids of one world have no meaning in another.

#include <compare>
#include <cstdint>

namespace hawser {

/// Id of an object. `Tag` distinguishes the kinds, so that a BodyId is no ShapeId.
template <class Tag>
struct Id {
    std::int32_t index = -1;      ///< Index of the object in arrays of its kind; −1: invalid id.
    std::int32_t generation = 0;  ///< Number of removed objects that had this index before.
    /// True if the id was assigned. It does not show whether the object still exists: see
    /// World::alive().
    [[nodiscard]] constexpr bool valid() const noexcept { return index >= 0; }
    friend constexpr auto operator<=>(const Id&, const Id&) = default;
};

using BodyId = Id<struct BodyTag>;
using InteractionId = Id<struct InteractionTag>;
using InputId = Id<struct InputTag>;
using ShapeId = Id<struct ShapeTag>;
using MaterialId = Id<struct MaterialTag>;
using WireId = Id<struct WireTag>;

}  // namespace hawser
