// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_position.h
/// Describe broken elements: position along the wire, and tension relative to the breaking load.

#include <hawser/hawser.h>

#include <optional>
#include <string>

namespace hawser::record {

struct WirePosition {
    std::string wire;
    double s = 0.0;       ///< Material coordinate of the element's middle [m].
    double length = 0.0;  ///< Unstretched length of the wire [m].
};

/// Return the unstretched length of an existing element at the present angle of its drum [m].
[[nodiscard]] double rest_length(const World& world, InteractionId element);

/// Return the position of an element in the first wire that contains it; null if there is none.
[[nodiscard]] std::optional<WirePosition> wire_position(const World& world, InteractionId element);

/// Return the label of a broken line, `wire/s39 (wire at 197.5 m)`, or else the result of
/// interaction_label().
[[nodiscard]] std::string broken_label(const World& world, InteractionId element);

/// Return the tension of a line_break event as a percentage of the line's breaking load, such as
/// " (131 % of its breaking load)"; "" for other events, and for lines without a breaking load.
[[nodiscard]] std::string describe_breaking(const World& world, const Event& event);

}  // namespace hawser::record
