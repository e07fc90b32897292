// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file id.h
/// Typed handles. A default-constructed id names nothing. Indices count from 0 in the order
/// in which things were added to one World and stay valid for its life.

#include <compare>
#include <cstdint>

namespace hawser {

template <class Tag>
struct Id {
    std::int32_t index = -1;
    [[nodiscard]] constexpr bool valid() const noexcept { return index >= 0; }
    friend constexpr auto operator<=>(const Id&, const Id&) = default;
};

using BodyId = Id<struct BodyTag>;
using InteractionId = Id<struct InteractionTag>;
using InputId = Id<struct InputTag>;
using ShapeId = Id<struct ShapeTag>;
using MaterialId = Id<struct MaterialTag>;

}  // namespace hawser
