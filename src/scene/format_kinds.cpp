// SPDX-License-Identifier: Apache-2.0
#include "scene/format.h"

#include <fmt/format.h>

#include <cmath>

namespace hawser::scene {
namespace {

std::string article(const std::string& noun) {
    return (std::string("aeiou").find(noun.front()) != std::string::npos ? "an " : "a ") + noun;
}

ShapePtr per_row(const std::string& what, int rows) {
    constexpr double kMaxDimension = 1e12;
    const ShapePtr one = make::number(what, 0.0, kMaxDimension);
    const auto count = static_cast<std::size_t>(rows);
    return make::choice(
        fmt::format("{}, or {} of them, one a row", what, rows),
        {one, make::list(fmt::format("{} numbers, one a row", rows), one, count, count)});
}

Field parameter_field(const KindInfo& kind, const ParamInfo& param) {
    const bool from_pose = is_taken_from_pose(kind, param.name);
    Field field;
    field.name = param.name;
    field.shape = make::number(fmt::format("a number [{}]", param.unit), param.min, param.max);
    field.required = std::isnan(param.fallback) && !from_pose;
    field.unit = param.unit;
    field.doc = param.doc;
    if (from_pose) {
        field.fallback = "the initial value";
    } else if (!std::isnan(param.fallback)) {
        field.fallback = fmt::format("{}", param.fallback);
    }
    if (param.input) {
        field.doc += " May be driven by an input.";
    }
    return field;
}

ShapePtr loads_shape() {
    return make::list(
        "one or two loads",
        make::object(
            "friction_load", "a load of friction",
            "Force of another interaction. A fraction of it adds to the bound of the friction.",
            {{"interaction", make::text("an interaction's name"), true, "", "",
              "Defined before; its rows in metres count: the force of a joint, of a line."},
             {"factor", make::number("a factor", 0.0, 1e6), true, "", "1, or m for a torque",
              "Friction coefficient of a slide; times the radius of a bearing; "
              "tanh(μδ/2) of each end of a line round an angle δ."}}),
        1, static_cast<std::size_t>(kMaxFrictionLoads));
}

ShapePtr kind_shape(const KindInfo& kind) {
    const auto count = static_cast<std::size_t>(kind.bodies);
    const std::string counted =
        count == 1 ? "1 body name" : fmt::format("{} body names", kind.bodies);
    std::vector<Field> fields{
        {"kind", make::literal(make::word("the kind", {kind.name})), true, "", "", "The kind."},
        {"name", make::name("a name"), false, "", "", "Unique among interactions."},
        {"bodies", make::list(counted, make::text("a body name"), count, count), true, "", "",
         "Bodies by name, in order; \"world\" is a fixed body at the origin."},
    };
    std::vector<std::vector<std::string>> alternatives;
    if (kind.uses_points) {
        fields.push_back({"at", make::vector3("a point"), false, "", "m",
                          "World point at which every body is attached."});
        fields.push_back({"points",
                          make::list(fmt::format("{} points, one a body", kind.bodies),
                                     make::vector3("a point"), count, count),
                          false, "the centres of mass", "m",
                          "Attachment point of each body, in its frame."});
        alternatives.push_back({"at", "points"});
    }
    if (kind.uses_frames) {
        fields.push_back({"axis", make::vector3("a direction"), false, "", "1",
                          "World direction that becomes z of every joint frame."});
        fields.push_back({"axes",
                          make::list(fmt::format("{} directions, one a body", kind.bodies),
                                     make::vector3("a direction"), count, count),
                          false, "", "1", "One world direction a body, z of its joint frame."});
        fields.push_back({"frames",
                          make::list(fmt::format("{} orientations, one a body", kind.bodies),
                                     make::list("an orientation [w, x, y, z]",
                                                make::number("a number", -1e6, 1e6), 4, 4),
                                     count, count),
                          false, "", "1",
                          "Orientation [w, x, y, z] of the joint frame in each body's frame."});
        alternatives.push_back({"axis", "axes", "frames"});
    }
    const bool velocity = std::string(kind.row_units).find('v') != std::string::npos;
    fields.push_back({"compliance", per_row("a compliance", kind.rows), false, "of the kind",
                      velocity ? "m/s/N or rad/s/(N m)" : "m/N or rad/(N m)",
                      "Of every row, or one number a row; 0 is rigid."});
    fields.push_back({"damping_time", per_row("a damping time", kind.rows), false, "of the kind",
                      "s", "Of every row, or one number a row."});
    for (const ParamInfo& param : kind.params) {
        fields.push_back(parameter_field(kind, param));
    }
    if (kind.takes_loads) {
        fields.push_back({"loads", loads_shape(), false, "none", "",
                          "Interactions whose force adds to the largest one, at most two."});
    }
    return make::object(fmt::format("interaction_{}", kind.name), article(kind.name), kind.doc,
                        std::move(fields), std::move(alternatives));
}

}  // namespace

bool is_taken_from_pose(const KindInfo& kind, std::string_view param) {
    return (kind.length_from_pose && param == "length") ||
           (!param.empty() && param == kind.from_pose);
}

ShapePtr interaction_shape() {
    auto shape = std::make_shared<Shape>();
    shape->type = Shape::Type::switched;
    shape->id = "interaction";
    shape->what = "an interaction";
    shape->doc = "A coupling between one to three bodies; \"kind\" selects which.";
    shape->key = "kind";
    for (const KindInfo& kind : interaction_kinds()) {
        shape->cases.emplace_back(kind.name, kind_shape(kind));
    }
    return shape;
}

}  // namespace hawser::scene
