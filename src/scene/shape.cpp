// SPDX-License-Identifier: Apache-2.0
#include "scene/shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace hawser::scene {
namespace {

using Type = Shape::Type;
using Result = std::optional<Problem>;

constexpr std::size_t kMaxText = 4096;

Problem wrong(std::string message) { return {"", std::move(message)}; }

Result expected(const Shape& shape, const Json& value) {
    return wrong("expected " + shape.what + ", found " + describe(value));
}

Problem at(const std::string& token, Problem inner) {
    inner.path.insert(0, token);
    return inner;
}

std::string range_text(const Shape& shape) {
    const bool low = std::isfinite(shape.min);
    const bool high = std::isfinite(shape.max);
    const char* than = shape.above_min ? "greater than" : "at least";
    if (low && high) {
        return fmt::format("{} {:.10g} and at most {:.10g}", than, shape.min, shape.max);
    }
    return low ? fmt::format("{} {:.10g}", than, shape.min)
               : fmt::format("at most {:.10g}", shape.max);
}

Result number_problem(const Json& value, const Shape& shape) {
    const bool fits_type =
        shape.type == Type::integer ? value.is_number_integer() : value.is_number();
    if (!fits_type) {
        return expected(shape, value);
    }
    const double number = value.get<double>();
    if (!std::isfinite(number)) {
        return wrong("expected a finite number, found " + describe(value));
    }
    const bool low = shape.above_min ? number <= shape.min : number < shape.min;
    if (low || number > shape.max) {
        return wrong("must be " + range_text(shape) + ", found " + describe(value));
    }
    return {};
}

Result text_problem(const Json& value, const Shape& shape) {
    if (!value.is_string()) {
        return expected(shape, value);
    }
    const auto& text = value.get_ref<const std::string&>();
    if (shape.type == Type::name && !is_valid_name(text)) {
        return wrong("expected " + shape.what +
                     " (letters, digits and _ . + -, at most 100, starting with a letter, a "
                     "digit or _), found " +
                     describe(value));
    }
    if (text.empty() || text.size() > kMaxText) {
        return wrong("expected " + shape.what + " of 1 to 4096 bytes, found " +
                     std::to_string(text.size()) + " bytes");
    }
    if (shape.type == Type::word &&
        std::find(shape.words.begin(), shape.words.end(), text) == shape.words.end()) {
        return wrong("expected " + shape.what + ", found " + describe(value) +
                     suggestion(text, shape.words));
    }
    return {};
}

Result list_problem(const Json& value, const Shape& shape, bool placeholders) {
    if (!value.is_array()) {
        return expected(shape, value);
    }
    if (value.size() < shape.min_items || value.size() > shape.max_items) {
        return wrong("expected " + shape.what + ", found " + std::to_string(value.size()) +
                     (value.size() == 1 ? " entry" : " entries"));
    }
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (auto problem = find_problem(value[i], *shape.item, placeholders)) {
            return at(fmt::format("/{}", i), std::move(*problem));
        }
    }
    return {};
}

Result alternatives_problem(const Json& value, const Shape& shape) {
    for (const auto& group : shape.alternatives) {
        const std::string* first = nullptr;
        for (const std::string& name : group) {
            if (!value.contains(name)) {
                continue;
            }
            if (first != nullptr) {
                return wrong("give either " + in_quotes(*first) + " or " + in_quotes(name) +
                             ", not both");
            }
            first = &name;
        }
    }
    return {};
}

Result object_problem(const Json& value, const Shape& shape, bool placeholders) {
    if (!value.is_object()) {
        return expected(shape, value);
    }
    for (const auto& [key, entry] : value.items()) {
        const auto field = std::find_if(shape.fields.begin(), shape.fields.end(),
                                        [&key = key](const Field& f) { return f.name == key; });
        if (field == shape.fields.end()) {
            std::vector<std::string> known;
            for (const Field& f : shape.fields) {
                known.push_back(f.name);
            }
            return at(pointer_token(key),
                      wrong(shape.what + " has no key " + in_quotes(key) + suggestion(key, known)));
        }
        if (auto problem = find_problem(entry, *field->shape, placeholders)) {
            return at(pointer_token(key), std::move(*problem));
        }
    }
    for (const Field& field : shape.fields) {
        if (field.required && !value.contains(field.name)) {
            return wrong(shape.what + " needs the key " + in_quotes(field.name) + " (" +
                         field.shape->what + ")");
        }
    }
    return alternatives_problem(value, shape);
}

Result map_problem(const Json& value, const Shape& shape, bool placeholders) {
    if (!value.is_object()) {
        return expected(shape, value);
    }
    for (const auto& [key, entry] : value.items()) {
        if (key.empty() || key.size() > kMaxText) {
            return at(pointer_token(key), wrong("a key must have 1 to 4096 bytes"));
        }
        if (auto problem = find_problem(entry, *shape.item, placeholders)) {
            return at(pointer_token(key), std::move(*problem));
        }
    }
    return {};
}

bool same_json_type(const Json& value, const Shape& shape) {
    switch (shape.type) {
        case Type::any:
            return true;
        case Type::number:
        case Type::integer:
            return value.is_number();
        case Type::boolean:
            return value.is_boolean();
        case Type::text:
        case Type::name:
        case Type::word:
            return value.is_string();
        case Type::list:
            return value.is_array();
        case Type::object:
        case Type::map:
        case Type::switched:
            return value.is_object();
        case Type::choice:
            break;
    }
    return std::any_of(shape.options.begin(), shape.options.end(),
                       [&](const ShapePtr& option) { return same_json_type(value, *option); });
}

/// Report the mistake in the option that the writer most likely meant: the one that fits
/// furthest into the value.
Result choice_problem(const Json& value, const Shape& shape, bool placeholders) {
    Result best;
    std::ptrdiff_t best_depth = -1;
    for (const ShapePtr& option : shape.options) {
        if (!same_json_type(value, *option)) {
            continue;
        }
        auto problem = find_problem(value, *option, placeholders);
        if (!problem) {
            return {};
        }
        auto depth = 2 * std::count(problem->path.begin(), problem->path.end(), '/');
        if (value.is_array() && !value.empty() && option->item &&
            same_json_type(value[0], *option->item)) {
            ++depth;  // A list of the right sort of entries.
        }
        if (depth > best_depth) {
            best_depth = depth;
            best = std::move(problem);
        }
    }
    return best ? best : expected(shape, value);
}

Result switched_problem(const Json& value, const Shape& shape, bool placeholders) {
    if (!value.is_object()) {
        return expected(shape, value);
    }
    const auto selector = value.find(shape.key);
    if (selector == value.end()) {
        return wrong(shape.what + " needs the key " + in_quotes(shape.key));
    }
    std::vector<std::string> known;
    for (const auto& [name, fields] : shape.cases) {
        if (*selector == name) {
            return object_problem(value, *fields, placeholders);
        }
        known.push_back(name);
    }
    const std::string hint =
        selector->is_string() ? suggestion(selector->get_ref<const std::string&>(), known) : "";
    return at(pointer_token(shape.key), wrong("there is no " + shape.key + " " +
                                              describe(*selector) + " of " + shape.what + hint));
}

}  // namespace

std::optional<Problem> find_problem(const Json& value, const Shape& shape, bool placeholders) {
    placeholders = placeholders || shape.holds_placeholders;
    const bool container =
        shape.type == Type::object || shape.type == Type::map || shape.type == Type::switched;
    if (placeholders && !shape.literal && !container && is_placeholder(value)) {
        return {};
    }
    switch (shape.type) {
        case Type::any:
            return {};
        case Type::number:
        case Type::integer:
            return number_problem(value, shape);
        case Type::boolean:
            return value.is_boolean() ? Result{} : expected(shape, value);
        case Type::text:
        case Type::name:
        case Type::word:
            return text_problem(value, shape);
        case Type::list:
            return list_problem(value, shape, placeholders);
        case Type::object:
            return object_problem(value, shape, placeholders);
        case Type::map:
            return map_problem(value, shape, placeholders);
        case Type::choice:
            return choice_problem(value, shape, placeholders);
        case Type::switched:
            return switched_problem(value, shape, placeholders);
    }
    return {};
}

void check_shape(const Json& value, const Shape& shape, const Place& place) {
    if (const auto problem = find_problem(value, shape)) {
        refuse({place.file, place.path + problem->path}, problem->message);
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

bool is_placeholder(const Json& value) {
    return value.is_string() && value.get_ref<const std::string&>().find("${") != std::string::npos;
}

ShapePtr with_placeholders(const ShapePtr& shape) {
    auto copy = std::make_shared<Shape>(*shape);
    copy->holds_placeholders = true;
    return copy;
}

}  // namespace hawser::scene
