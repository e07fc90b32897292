// SPDX-License-Identifier: Apache-2.0
#include "scene/schema.h"

#include "scene/format.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace hawser::scene {
namespace {

using Ordered = nlohmann::ordered_json;
using Type = Shape::Type;

/// Writes shapes as schemas. Named shapes go to "definitions", and the schema refers to them.
class Writer {
  public:
    Ordered write(const Shape& shape, bool placeholders) {
        placeholders = placeholders || shape.holds_placeholders;
        if (shape.id.empty()) {
            return with_placeholder(shape, body(shape, placeholders), placeholders);
        }
        const std::string name = shape.id + (placeholders ? "_in_template" : "");
        if (!definitions_.contains(name)) {
            definitions_[name] = nullptr;  // Reserves the name for a shape that contains itself.
            Ordered definition = with_placeholder(shape, body(shape, placeholders), placeholders);
            definitions_[name] = std::move(definition);
        }
        return {{"$ref", "#/definitions/" + name}};
    }

    [[nodiscard]] const Ordered& definitions() const { return definitions_; }

  private:
    static constexpr int kMaxText = 4096;

    /// Extend a schema for templates: a scalar or a list may also be a string with "${parameter}".
    static Ordered with_placeholder(const Shape& shape, Ordered plain, bool placeholders) {
        const bool container = shape.type == Type::object || shape.type == Type::map ||
                               shape.type == Type::switched || shape.type == Type::any;
        if (!placeholders || shape.literal || container) {
            return plain;
        }
        return {{"anyOf", {std::move(plain), {{"type", "string"}, {"pattern", "\\$\\{"}}}}};
    }

    Ordered body(const Shape& shape, bool placeholders) {
        switch (shape.type) {
            case Type::any:
                return Ordered::object();
            case Type::number:
            case Type::integer:
                return number(shape);
            case Type::boolean:
                return {{"type", "boolean"}};
            case Type::text:
                return {{"type", "string"}, {"minLength", 1}, {"maxLength", kMaxText}};
            case Type::name:
                return {{"type", "string"}, {"pattern", kNamePattern}};
            case Type::word:
                return {{"type", "string"}, {"enum", shape.words}};
            case Type::list:
                return list(shape, placeholders);
            case Type::object:
                return object(shape, placeholders);
            case Type::map:
                return {{"type", "object"},
                        {"propertyNames", {{"minLength", 1}, {"maxLength", kMaxText}}},
                        {"additionalProperties", write(*shape.item, placeholders)}};
            case Type::choice:
                return choice(shape, placeholders);
            case Type::switched:
                return conditional_schema(shape, placeholders);
        }
        return {};
    }

    static Ordered number(const Shape& shape) {
        Ordered result{{"type", shape.type == Type::integer ? "integer" : "number"}};
        const auto bound = [&](const char* key, double value) {
            if (!std::isfinite(value)) {
                return;
            }
            if (shape.type == Type::integer) {
                result[key] = static_cast<std::int64_t>(value);
            } else {
                result[key] = value;
            }
        };
        bound(shape.above_min ? "exclusiveMinimum" : "minimum", shape.min);
        bound("maximum", shape.max);
        return result;
    }

    Ordered list(const Shape& shape, bool placeholders) {
        Ordered result{{"type", "array"}, {"items", write(*shape.item, placeholders)}};
        if (shape.min_items > 0) {
            result["minItems"] = shape.min_items;
        }
        if (shape.max_items != std::numeric_limits<std::size_t>::max()) {
            result["maxItems"] = shape.max_items;
        }
        return result;
    }

    Ordered object(const Shape& shape, bool placeholders) {
        Ordered result{{"type", "object"}};
        if (!shape.doc.empty()) {
            result["description"] = shape.doc;
        }
        Ordered required = Ordered::array();
        Ordered properties = Ordered::object();
        for (const Field& field : shape.fields) {
            Ordered entry = write(*field.shape, placeholders);
            // Draft 07 ignores other keys of an object with "$ref": wrap it.
            Ordered property = entry.contains("$ref") ? Ordered{{"allOf", {entry}}} : entry;
            property["description"] = description(field);
            properties[field.name] = std::move(property);
            if (field.required) {
                required.push_back(field.name);
            }
        }
        if (!required.empty()) {
            result["required"] = std::move(required);
        }
        result["additionalProperties"] = false;
        result["properties"] = std::move(properties);
        if (!shape.alternatives.empty()) {
            result["allOf"] = exclusions(shape);
        }
        return result;
    }

    static std::string description(const Field& field) {
        std::string text = field.doc;
        if (!field.unit.empty() && field.unit != "1") {
            text += " [" + field.unit + "]";
        }
        if (!field.fallback.empty()) {
            text += " Default: " + field.fallback + ".";
        }
        return text;
    }

    /// Return conditions that at most one field of each exclusive group is present.
    static Ordered exclusions(const Shape& shape) {
        Ordered result = Ordered::array();
        for (const auto& group : shape.alternatives) {
            for (std::size_t i = 0; i < group.size(); ++i) {
                for (std::size_t j = i + 1; j < group.size(); ++j) {
                    result.push_back({{"not", {{"required", {group[i], group[j]}}}}});
                }
            }
        }
        return result;
    }

    Ordered choice(const Shape& shape, bool placeholders) {
        Ordered options = Ordered::array();
        for (const ShapePtr& option : shape.options) {
            options.push_back(write(*option, placeholders));
        }
        return {{"anyOf", std::move(options)}};
    }

    /// Return a schema of the form "if kind is … then …", so that an editor reports errors of the
    /// matching kind only.
    Ordered conditional_schema(const Shape& shape, bool placeholders) {
        Ordered words = Ordered::array();
        Ordered cases = Ordered::array();
        for (const auto& [name, fields] : shape.cases) {
            words.push_back(name);
            cases.push_back(
                {{"if",
                  {{"required", {shape.key}}, {"properties", {{shape.key, {{"const", name}}}}}}},
                 {"then", write(*fields, placeholders)}});
        }
        return {{"type", "object"},
                {"description", shape.doc},
                {"required", {shape.key}},
                {"properties", {{shape.key, {{"type", "string"}, {"enum", std::move(words)}}}}},
                {"allOf", std::move(cases)}};
    }

    Ordered definitions_ = Ordered::object();
};

}  // namespace

std::string schema_text() {
    const Format& f = format();
    Writer writer;
    const Ordered root = writer.write(*f.scene, false);
    writer.write(*f.part, false);
    writer.write(*f.state, false);
    const Ordered schema{
        {"$schema", "http://json-schema.org/draft-07/schema#"},
        {"$comment", "Generated from the source (src/scene/format.cpp); do not edit by hand."},
        {"title", "Hawser scene, version 1"},
        {"allOf", {root}},
        {"definitions", writer.definitions()}};
    return schema.dump(1) + "\n";
}

std::string schema_of(const Shape& root, const std::string& title, const std::string& source) {
    Writer writer;
    const Ordered shape = writer.write(root, false);
    const Ordered schema{
        {"$schema", "http://json-schema.org/draft-07/schema#"},
        {"$comment", "Generated from the source (" + source + "); do not edit by hand."},
        {"title", title},
        {"allOf", {shape}},
        {"definitions", writer.definitions()}};
    return schema.dump(1) + "\n";
}

}  // namespace hawser::scene
