// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file id.h
/// Typed handles. A default-constructed id names nothing.
///
/// An id is a place and a generation. Places count from 0 in the order in which things were added
/// to one World; a thing that is removed leaves its place empty, and a later one of the same kind
/// takes the first empty place that fits, with the next generation:
/// ```
///     add a, b, c          (0, 0) (1, 0) (2, 0)
///     remove b             (0, 0)        (2, 0)
///     add d                (0, 0) (1, 1) (2, 0)      (1, 0) is refused from now on: it was b
/// ```
/// Places never move, so that arrays by place stay as they are. Where nothing has been removed
/// all generations are 0, and `BodyId{i}` is the body added as number i.

#include <compare>
#include <cstdint>

namespace hawser {

template <class Tag>
struct Id {
    std::int32_t index = -1;      ///< Place; −1: none.
    std::int32_t generation = 0;  ///< How many others had the place before.
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
