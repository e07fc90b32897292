// SPDX-License-Identifier: Apache-2.0
/// Checks of shapes and materials.
#include <hawser/material_fields.h>

#include "world/checks.h"

#include <cmath>
#include <string>
#include <variant>

namespace hawser::world {
namespace {

constexpr double kMaxShapeSize = 1e6;           ///< [m].
constexpr std::size_t kMostNodes = 1U << 24;    ///< Nodes of a heightfield.
constexpr std::size_t kMaxVertices = 1U << 22;  ///< Vertices of a mesh, and its triangles.
constexpr std::size_t kMostHull = 4096;         ///< Vertices of a hull.

[[noreturn]] void throw_shape_error(const Where& where, const std::string& what) {
    throw DefError(where.text() + ": " + what);
}

void check_within(const Where& where, const char* field, double value, double low, double high) {
    if (!(value >= low && value <= high))
        throw_shape_error(where, std::string(field) + " = " + number(value) + " is outside " +
                                     number(low) + " … " + number(high));
}

void length(const Where& where, const char* field, double value) {
    if (!(value > 0.0 && value <= kMaxShapeSize))
        throw_shape_error(where, std::string(field) + " = " + number(value) +
                                     " m; it must be above 0 and at most 1e6 m");
}

void points(const Where& where, const std::vector<Vec3>& vertices) {
    for (std::size_t i = 0; i < vertices.size(); ++i)
        for (int k = 0; k < 3; ++k)
            if (!(std::abs(vertices[i][k]) <= kMaxShapeSize))
                throw_shape_error(where,
                                  "vertex " + std::to_string(i) + " is not finite or beyond 1e6 m");
}

void check_values(const Where& where, const MaterialDef& m, Nonsmooth method) {
    for (const FieldInfo<MaterialDef>& row : kMaterialFields)
        if (!has_default(m, row))
            check_within(where, row.key, m.*std::get<double MaterialDef::*>(row.member), row.least,
                         row.most);
    if (method != Nonsmooth::newton && (m.rolling > 0.0 || m.torsional > 0.0))
        throw_shape_error(where, "rolling and torsional resistance need the method newton");
}

void check_heightfield(const Where& where, const ShapeDef& d) {
    if (d.rows < 2 || d.columns < 2)
        throw_shape_error(where, "a heightfield needs 2 rows and 2 columns");
    const auto nodes = static_cast<std::size_t>(d.rows) * static_cast<std::size_t>(d.columns);
    if (nodes > kMostNodes)
        throw_shape_error(where, "a heightfield may have 16,777,216 nodes at most");
    if (d.heights.size() != nodes)
        throw_shape_error(where, std::to_string(d.heights.size()) + " heights for " +
                                     std::to_string(d.rows) + " × " + std::to_string(d.columns) +
                                     " nodes");
    for (const double c : d.cell) length(where, "cell", c);
    for (const double z : d.heights)
        if (!(std::abs(z) <= kMaxShapeSize))
            throw_shape_error(where, "a height is not finite or beyond 1e6 m");
}

void check_mesh(const Where& where, const ShapeDef& d) {
    if (d.vertices.size() > kMaxVertices || d.triangles.size() > kMaxVertices)
        throw_shape_error(where, "a mesh may have 4,194,304 vertices and triangles at most");
    if (d.triangles.empty()) throw_shape_error(where, "a mesh needs triangles");
    points(where, d.vertices);
    for (std::size_t t = 0; t < d.triangles.size(); ++t)
        for (const std::int32_t v : d.triangles[t])
            if (v < 0 || static_cast<std::size_t>(v) >= d.vertices.size())
                throw_shape_error(where, "triangle " + std::to_string(t) + " names vertex " +
                                             std::to_string(v) + " of " +
                                             std::to_string(d.vertices.size()));
}

void check_size(const Where& where, const ShapeDef& d) {
    const bool segment = d.body_b.valid();
    check_within(where, "margin", d.margin, 0.0, 1000.0);
    switch (d.kind) {
        case ShapeKind::sphere:
            return length(where, "radius", d.radius);
        case ShapeKind::capsule:
        case ShapeKind::cylinder:
            length(where, "radius", d.radius);
            if (!segment) length(where, "half_length", d.half_length);
            return;
        case ShapeKind::box:
            for (int k = 0; k < 3; ++k) length(where, "half_size", d.half_size[k]);
            return;
        case ShapeKind::plane:
            return;
        case ShapeKind::heightfield:
            return check_heightfield(where, d);
        case ShapeKind::hull:
            if (d.vertices.size() < 4 || d.vertices.size() > kMostHull)
                throw_shape_error(where, "a hull needs 4 to 4,096 vertices, given " +
                                             std::to_string(d.vertices.size()));
            return points(where, d.vertices);
        case ShapeKind::mesh:
            return check_mesh(where, d);
    }
    throw_shape_error(where, "unknown kind");
}

void check_bodies(const Where& where, const ShapeDef& d, const model::Bodies& bodies, int count) {
    auto kind = [&](BodyId id, const char* which) {
        if (id.index < 0 || id.index >= count)
            throw_shape_error(where, std::string(which) + " does not exist");
        if (!bodies.slots.names(id))
            throw_shape_error(where, std::string(which) + " has been removed");
        return bodies.kind[static_cast<std::size_t>(id.index)];
    };
    const BodyKind a = kind(d.body, "body");
    if (d.body_b.valid()) {
        if (d.kind != ShapeKind::capsule)
            throw_shape_error(where, "only a capsule can connect two bodies (a segment)");
        if (d.body_b == d.body) throw_shape_error(where, "a segment needs two different nodes");
        const BodyKind b = kind(d.body_b, "body_b");
        const bool lumps = a == BodyKind::lump || b == BodyKind::lump;
        if (!lumps || a == BodyKind::scalar || b == BodyKind::scalar)
            throw_shape_error(
                where,
                "a segment connects two nodes, or a node and a body that is not scalar; name a "
                "node on one side");
        return;
    }
    if (a == BodyKind::scalar)
        throw_shape_error(where, "a scalar body has no position, so no shape");
    if (a == BodyKind::lump) {
        if (d.kind != ShapeKind::sphere)
            throw_shape_error(
                where,
                "a point mass has no orientation: it can have a sphere, or a segment to another "
                "node (body_b)");
        if (!d.position.isZero(0.0))
            throw_shape_error(where,
                              "the sphere of a point mass is centred on it; position must be 0");
    }
    const bool moves = model::dof_of(a) > 0;
    if (moves && d.kind == ShapeKind::mesh)
        throw_shape_error(where,
                          "a mesh needs a fixed or kinematic body; give a moving body a hull");
}

}  // namespace

void check(const MaterialDef& def, Nonsmooth method) {
    if (def.name.empty()) throw DefError("a material needs a name");
    check_values(Where("material", def.name), def, method);
}

void check(const MaterialPairDef& def, int materials, Nonsmooth method) {
    const std::string where = "material pair";
    for (const MaterialId id : {def.a, def.b})
        if (id.index < 0 || id.index >= materials)
            throw_shape_error(where, "a material does not exist");
    check_values(where, def.values, method);
}

void check(const ShapeDef& def, const model::Bodies& bodies, int count, int materials) {
    const Where where("shape", def.name);
    check_bodies(where, def, bodies, count);
    for (int k = 0; k < 3; ++k)
        if (!(std::abs(def.position[k]) <= kMaxShapeSize))
            throw_shape_error(where, "position is not finite or beyond 1e6 m");
    const double norm = def.orientation.norm();
    if (!(norm > 0.5 && norm < 2.0))
        throw_shape_error(where, "orientation is not a unit quaternion");
    check_size(where, def);
    if (def.material.index >= materials) throw_shape_error(where, "the material does not exist");
}

}  // namespace hawser::world
