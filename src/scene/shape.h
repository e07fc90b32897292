// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file shape.h
/// Describe the format as data. The checker, the JSON Schema and the reference page use this one
/// description, so that they cannot disagree.

#include "scene/read_json.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace hawser::scene {

struct Shape;
using ShapePtr = std::shared_ptr<const Shape>;

/// One key of an object.
struct Field {
    std::string name;
    ShapePtr shape;
    bool required = false;
    std::string fallback;  ///< Default, in words or digits, for the documents.
    std::string unit;      ///< Unit in SI; "" = none.
    std::string doc;
};

/// Description of the valid values of one kind.
struct Shape {
    enum class Type {
        any,      ///< Anything.
        number,   ///< Finite, in [min, max] or (min, max].
        integer,  ///< Written without a decimal point, in [min, max].
        boolean,
        text,      ///< A string of 1 to 4096 bytes.
        name,      ///< A name defined by the scene: is_valid_name().
        word,      ///< One of `words`.
        list,      ///< Array of `item`, between min_items and max_items.
        object,    ///< `fields` and no others.
        map,       ///< Object with keys of the reader's choice, all values `item`.
        choice,    ///< One of `options`.
        switched,  ///< Object whose field `key` selects one of `cases`.
    };
    Type type = Type::any;
    std::string id;    ///< Name of the definition in the schema; "" = inline.
    std::string what;  ///< Description in words, for messages: "a length in metres".
    std::string doc;

    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    bool above_min = false;  ///< True if min itself is rejected.

    std::vector<std::string> words;

    ShapePtr item;
    std::size_t min_items = 0;
    std::size_t max_items = std::numeric_limits<std::size_t>::max();

    std::vector<Field> fields;
    /// Sets of fields; at most one field of a set may be present.
    std::vector<std::vector<std::string>> alternatives;

    std::vector<ShapePtr> options;

    std::string key;
    std::vector<std::pair<std::string, ShapePtr>> cases;

    /// True if any scalar or list inside may be a string with "${parameter}" (templates).
    bool holds_placeholders = false;
    /// True if a placeholder may not replace the value, even in a template.
    bool literal = false;
};

/// A mistake in a value.
struct Problem {
    std::string path;  ///< JSON pointer from the value that was checked.
    std::string message;
};

/// Compare a value with a shape. @return its mistakes in the order of the value, at most `most`.
[[nodiscard]] std::vector<Problem> find_problems(const Json& value, const Shape& shape,
                                                 std::size_t most);

/// Return the first problem of a value; null if the value fits.
[[nodiscard]] std::optional<Problem> find_problem(const Json& value, const Shape& shape,
                                                  bool placeholders = false);

/// Check a value. @throws SceneError with the place of the first mistake.
void check_shape(const Json& value, const Shape& shape, const SourceLocation& location);

/// True for letters, digits and `_ . + -`, starting with a letter, digit or `_`, at most 100. (`/`
/// and `:` are reserved for generated names.)
[[nodiscard]] bool is_valid_name(const std::string& name);
inline constexpr const char* kNamePattern = "^[A-Za-z0-9_][A-Za-z0-9_.+-]{0,99}$";

/// True if a value has the JSON type of a shape, with any content.
[[nodiscard]] bool is_of_type(const Json& value, const Shape& shape);

/// True for a string that contains "${".
[[nodiscard]] bool is_placeholder(const Json& value);

/// Return the shape for use inside a template, where values may be placeholders.
[[nodiscard]] ShapePtr with_placeholders(const ShapePtr& shape);

}  // namespace hawser::scene
