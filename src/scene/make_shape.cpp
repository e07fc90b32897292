// SPDX-License-Identifier: Apache-2.0
#include "scene/make_shape.h"

#include <memory>
#include <utility>

namespace hawser::scene::make {
namespace {

using Type = Shape::Type;

// Limit of coordinates, velocities and forces; larger ones are mistakes of unit or damage.
constexpr double kLargestComponent = 1e12;

Shape plain_shape(Type type, std::string what) {
    Shape shape;
    shape.type = type;
    shape.what = std::move(what);
    return shape;
}

ShapePtr shared(Shape shape) { return std::make_shared<const Shape>(std::move(shape)); }

}  // namespace

ShapePtr number(std::string what, double min, double max) {
    Shape shape = plain_shape(Type::number, std::move(what));
    shape.min = min;
    shape.max = max;
    return shared(std::move(shape));
}

ShapePtr positive(std::string what, double max) {
    Shape shape = plain_shape(Type::number, std::move(what));
    shape.min = 0.0;
    shape.above_min = true;
    shape.max = max;
    return shared(std::move(shape));
}

ShapePtr integer(std::string what, double min, double max) {
    Shape shape = plain_shape(Type::integer, std::move(what));
    shape.min = min;
    shape.max = max;
    return shared(std::move(shape));
}

ShapePtr boolean(std::string what) { return shared(plain_shape(Type::boolean, std::move(what))); }
ShapePtr text(std::string what) { return shared(plain_shape(Type::text, std::move(what))); }
ShapePtr name(std::string what) { return shared(plain_shape(Type::name, std::move(what))); }

ShapePtr word(std::string what, std::vector<std::string> words) {
    Shape shape = plain_shape(Type::word, std::move(what));
    shape.words = std::move(words);
    return shared(std::move(shape));
}

ShapePtr list(std::string what, ShapePtr item, std::size_t min_items, std::size_t max_items) {
    Shape shape = plain_shape(Type::list, std::move(what));
    shape.item = std::move(item);
    shape.min_items = min_items;
    shape.max_items = max_items;
    return shared(std::move(shape));
}

ShapePtr vector3(std::string what) {
    Shape shape = plain_shape(Type::list, std::move(what) + " [x, y, z]");
    shape.id = "vector3";
    shape.item = number("a number", -kLargestComponent, kLargestComponent);
    shape.min_items = shape.max_items = 3;
    return shared(std::move(shape));
}

ShapePtr map(std::string what, ShapePtr item) {
    Shape shape = plain_shape(Type::map, std::move(what));
    shape.item = std::move(item);
    return shared(std::move(shape));
}

ShapePtr choice(std::string what, std::vector<ShapePtr> options) {
    Shape shape = plain_shape(Type::choice, std::move(what));
    shape.options = std::move(options);
    return shared(std::move(shape));
}

ShapePtr object(std::string id, std::string what, std::string doc, std::vector<Field> fields,
                std::vector<std::vector<std::string>> alternatives) {
    Shape shape = plain_shape(Type::object, std::move(what));
    shape.id = std::move(id);
    shape.doc = std::move(doc);
    shape.fields = std::move(fields);
    shape.alternatives = std::move(alternatives);
    return shared(std::move(shape));
}

ShapePtr list_of(std::string what, ShapePtr item) {
    return list(std::move(what), std::move(item), 0, kMaxElements);
}

ShapePtr body_ref() { return text("a body name"); }

ShapePtr group() {
    return choice("a group: a name or a number", {text("a name"), integer("a number", 0, 1e6)});
}

ShapePtr literal(const ShapePtr& shape) {
    Shape copy = *shape;
    copy.literal = true;
    return shared(std::move(copy));
}

}  // namespace hawser::scene::make
