// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file make_shape.h
/// Build shapes of values (shape.h).

#include "scene/shape.h"

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace hawser::scene {

/// Bodies, cable elements and interactions that one scene may have, copies included.
inline constexpr std::size_t kMaxElements = 2'000'000;

/// Functions that return shapes. `what`: the value in words, for messages.
namespace make {
[[nodiscard]] ShapePtr number(std::string what, double min, double max);
[[nodiscard]] ShapePtr positive(std::string what, double max);
[[nodiscard]] ShapePtr integer(std::string what, double min, double max);
[[nodiscard]] ShapePtr boolean(std::string what);
[[nodiscard]] ShapePtr text(std::string what);
[[nodiscard]] ShapePtr name(std::string what);
[[nodiscard]] ShapePtr word(std::string what, std::vector<std::string> words);
[[nodiscard]] ShapePtr list(std::string what, ShapePtr item, std::size_t min_items,
                            std::size_t max_items = std::numeric_limits<std::size_t>::max());
[[nodiscard]] ShapePtr vector3(std::string what);
[[nodiscard]] ShapePtr map(std::string what, ShapePtr item);
[[nodiscard]] ShapePtr choice(std::string what, std::vector<ShapePtr> options);
[[nodiscard]] ShapePtr object(std::string id, std::string what, std::string doc,
                              std::vector<Field> fields,
                              std::vector<std::vector<std::string>> alternatives = {});
/// Return the schema of a list of values of one kind, at most kMaxElements.
[[nodiscard]] ShapePtr list_of(std::string what, ShapePtr item);
[[nodiscard]] ShapePtr body_ref();
/// Return the schema of the group of a body, for settings.coupling.
[[nodiscard]] ShapePtr group();
[[nodiscard]] ShapePtr literal(const ShapePtr& shape);
}  // namespace make

}  // namespace hawser::scene
