// SPDX-License-Identifier: Apache-2.0
#include "scene/shape.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace hawser::scene {

void check_shape(const Json& value, const Shape& shape, const SourceLocation& location) {
    if (const auto problem = find_problem(value, shape)) {
        throw_error({location.file, location.path + problem->path}, problem->message);
    }
}

bool is_valid_name(const std::string& name) {
    constexpr std::size_t kMaxName = 100;
    const auto letter = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_';
    };
    return !name.empty() && name.size() <= kMaxName && letter(name.front()) &&
           std::all_of(name.begin(), name.end(),
                       [&](char c) { return letter(c) || c == '.' || c == '+' || c == '-'; });
}

bool is_of_type(const Json& value, const Shape& shape) {
    switch (shape.type) {
        case Shape::Type::any:
            return true;
        case Shape::Type::number:
        case Shape::Type::integer:
            return value.is_number();
        case Shape::Type::boolean:
            return value.is_boolean();
        case Shape::Type::text:
        case Shape::Type::name:
        case Shape::Type::word:
            return value.is_string();
        case Shape::Type::list:
            return value.is_array();
        case Shape::Type::object:
        case Shape::Type::map:
        case Shape::Type::switched:
            return value.is_object();
        case Shape::Type::choice:
            break;
    }
    return std::any_of(shape.options.begin(), shape.options.end(),
                       [&](const ShapePtr& option) { return is_of_type(value, *option); });
}

bool is_placeholder(const Json& value) {
    return value.is_string() && value.get_ref<const std::string&>().find("${") != std::string::npos;
}

ShapePtr with_placeholders(const ShapePtr& shape) {
    auto copy = std::make_shared<Shape>(*shape);
    copy->holds_placeholders = true;
    return copy;
}

}  // namespace hawser::scene
