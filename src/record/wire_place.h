// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_place.h
/// Where along its wire an element is.

#include <hawser/hawser.h>

#include <optional>
#include <string>

namespace hawser::record {

struct WirePlace {
    std::string wire;
    double s = 0.0;       ///< Material coordinate of the element's middle [m].
    double length = 0.0;  ///< Of the wire, unstretched [m].
};

/// Unstretched length of an element that is there, as its drum has it now [m].
[[nodiscard]] double rest_length(const World& world, InteractionId element);

/// Of the first wire that has it; nothing where none does.
[[nodiscard]] std::optional<WirePlace> wire_place(const World& world, InteractionId element);

/// Of a line that parts, `wire/s39 (wire at 197.5 m)`; else as interaction_label() has it.
[[nodiscard]] std::string parted_label(const World& world, InteractionId element);

}  // namespace hawser::record
