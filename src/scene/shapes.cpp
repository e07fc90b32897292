// SPDX-License-Identifier: Apache-2.0
#include "scene/description.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <set>

namespace hawser::scene {
namespace {

/// Return the rotation from the shape's z, the axis of cylinders in the world, to the named axis.
Quat to_axis(const std::string& axis) {
    return axis == "z"   ? Quat::Identity()
           : axis == "y" ? turn_between(Vec3::UnitZ(), Vec3::UnitY())
                         : turn_between(Vec3::UnitZ(), Vec3::UnitX());
}

void read_ground(ShapeDef& def, const Json& ground, const SourceLocation& location) {
    const auto pair = [&](const char* key, double fallback) {
        std::array<double, 2> value{fallback, fallback};
        if (const auto entry = ground.find(key); entry != ground.end()) {
            value = {(*entry)[0].get<double>(), (*entry)[1].get<double>()};
        }
        return value;
    };
    const double height = number_or(ground, "height", 0.0);
    if (height != 0.0 && !ground.contains("length")) {
        throw_error(location, "waves need \"length\"");
    }
    const auto slope = pair("slope", 0.0);
    const auto length = pair("length", 1.0);
    constexpr double kTurn = 2.0 * std::numbers::pi;
    for (int i = 0; i < def.rows; ++i) {
        for (int j = 0; j < def.columns; ++j) {
            const double x = (j - 0.5 * (def.columns - 1)) * def.cell[0];
            const double y = (i - 0.5 * (def.rows - 1)) * def.cell[1];
            def.heights.push_back(slope[0] * x + slope[1] * y +
                                  height * std::cos(kTurn * x / length[0]) *
                                      std::cos(kTurn * y / length[1]));
        }
    }
}

void read_heightfield(ShapeDef& def, const Json& json, const SourceLocation& location) {
    constexpr std::size_t kMostNodes = 1'000'000;
    def.rows = json["rows"].get<int>();
    def.columns = json["columns"].get<int>();
    def.cell = {json["cell"][0].get<double>(), json["cell"][1].get<double>()};
    const auto nodes = static_cast<std::size_t>(def.rows) * static_cast<std::size_t>(def.columns);
    if (nodes > kMostNodes) {
        throw_error(location, fmt::format("{} rows of {} are more than {} nodes", def.rows,
                                          def.columns, kMostNodes));
    }
    if (json.contains("heights")) {
        const Json& heights = json["heights"];
        if (heights.size() != nodes) {
            throw_error(location / "heights",
                        fmt::format("expected {} heights, {} rows of {}, found {}", nodes, def.rows,
                                    def.columns, heights.size()));
        }
        def.heights = heights.get<std::vector<double>>();
    } else {
        read_ground(def, json.value("ground", Json::object()), location / "ground");
    }
}

void read_mesh(ShapeDef& def, const Json& json, const SourceLocation& location) {
    const Json& list = json["triangles"];
    for (std::size_t t = 0; t < list.size(); ++t) {
        std::array<std::int32_t, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] = list[t][k].get<std::int32_t>();
            if (static_cast<std::size_t>(corners[k]) >= def.vertices.size()) {
                throw_error(location / "triangles" / t / k,
                            fmt::format("there is no vertex {}; the last one is {}", corners[k],
                                        def.vertices.size() - 1));
            }
        }
        def.triangles.push_back(corners);
    }
}

ShapeDef read_shape(const Json& json, const SourceLocation& location) {
    ShapeDef def;
    const auto& word = json["kind"].get_ref<const std::string&>();
    for (int i = 0; i <= static_cast<int>(ShapeKind::mesh); ++i) {
        if (word == to_string(static_cast<ShapeKind>(i))) {
            def.kind = static_cast<ShapeKind>(i);
        }
    }
    def.position = vector_or(json, "position", Vec3::Zero());
    def.orientation = orientation_of(json, location);
    def.radius = number_or(json, "radius", 0.0);
    def.half_length = 0.5 * number_or(json, "length", 0.0);
    def.half_size = vector_or(json, "half_size", Vec3::Zero());
    if (def.kind == ShapeKind::capsule || def.kind == ShapeKind::cylinder) {
        def.orientation = def.orientation * to_axis(text_or(json, "axis", "x"));
    }
    if (json.contains("normal")) {
        const Vec3 normal = vector_of(json["normal"]);
        if (!(normal.norm() > 1e-9)) {
            throw_error(location / "normal", "a direction must not be zero");
        }
        def.orientation = turn_between(Vec3::UnitZ(), normal);
    }
    if (def.kind == ShapeKind::heightfield) {
        read_heightfield(def, json, location);
    }
    if (json.contains("vertices")) {
        for (const Json& vertex : json["vertices"]) {
            def.vertices.push_back(vector_of(vertex));
        }
    }
    if (def.kind == ShapeKind::mesh) {
        read_mesh(def, json, location);
    }
    return def;
}

bool is_segment(const Json& shape) { return shape["kind"] == "segment"; }

/// Check that a body may be an end of a segment.
void check_end(const BodyDef& body, const SourceLocation& location) {
    if (body.kind != BodyKind::lump && body.kind != BodyKind::fixed) {
        throw_error(location,
                    "a segment connects two point masses, or a point mass and a fixed body; " +
                        in_quotes(body.name) + " is neither a lump nor fixed");
    }
}

ShapeDef read_segment(Description& out, const Scope& scope, BodyId body, const Json& json,
                      const SourceLocation& location) {
    check_end(out.body(body), location / "kind");
    ShapeDef def;
    def.kind = ShapeKind::capsule;
    def.body = body;
    def.body_b = resolve_body(out, scope, json["to"].get<std::string>(), location / "to");
    def.radius = json["radius"].get<double>();
    check_end(out.body(def.body_b), location / "to");
    if (def.body_b.index == def.body.index) {
        throw_error(location / "to", "a segment needs two different bodies");
    }
    if (out.body(body).kind == BodyKind::fixed && out.body(def.body_b).kind == BodyKind::fixed) {
        throw_error(location / "to", "one end of a segment must be a lump; both are fixed");
    }
    if (json.contains("name")) {
        def.name = out.body(body).name + "/" + json["name"].get<std::string>();
    }
    return def;
}

}  // namespace

void expand_segments(Description& out, const Scope& scope) {
    const auto bodies = scope.content->find("bodies");
    if (bodies == scope.content->end()) {
        return;
    }
    for (std::size_t b = 0; b < bodies->size(); ++b) {
        const Json& body = (*bodies)[b];
        if (body.is_null()) {
            continue;  // Left out: mistakes.h.
        }
        const auto shapes = body.find("shapes");
        const BodyId id = out.find_body(scope.prefix + body["name"].get<std::string>());
        if (shapes == body.end() || !id.valid()) {
            continue;
        }
        for (std::size_t i = 0; i < shapes->size(); ++i) {
            if (!is_segment((*shapes)[i])) {
                continue;
            }
            const SourceLocation at = scope.location / "bodies" / b / "shapes" / i;
            (void)attempt(out.mistakes, [&] {
                ShapeDef def = read_segment(out, scope, id, (*shapes)[i], at);
                read_surface(def, out, (*shapes)[i], at);
                out.add_shape(std::move(def), out.store_location(at));
            });
        }
    }
}

namespace {

void expand_shape(Description& out, BodyId body, const Json& json, std::set<std::string>& names,
                  const SourceLocation& at) {
    const std::string name = text_or(json, "name", "");
    if (!name.empty() && !names.insert(name).second) {
        throw_error(at / "name", "the body has a shape " + in_quotes(name) + " already");
    }
    if (is_segment(json)) {
        return;  // The other end may not exist yet: expand_segments().
    }
    ShapeDef def = read_shape(json, at);
    def.body = body;
    if (!name.empty()) {
        def.name = out.body(body).name + "/" + name;
    }
    read_surface(def, out, json, at);
    out.add_shape(std::move(def), out.store_location(at));
}

}  // namespace

void expand_shapes(Description& out, BodyId body, const Json& list,
                   const SourceLocation& location) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < list.size(); ++i) {
        (void)attempt(out.mistakes, [&] { expand_shape(out, body, list[i], names, location / i); });
    }
}

}  // namespace hawser::scene
