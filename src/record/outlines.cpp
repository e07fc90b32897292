// SPDX-License-Identifier: Apache-2.0
#include "record/outlines.h"

#include "record/recording_bytes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hawser::record {
namespace {

constexpr int kMaxLines = 64;  ///< Largest number of lines along each side of a ground.
constexpr std::size_t kMostTriangles = 4096;

std::vector<Vec3> circle_points(double radius, double z) {
    std::vector<Vec3> out;
    for (int i = 0; i < kOutlineRim; ++i) {
        const double t = 2.0 * std::numbers::pi * i / kOutlineRim;
        out.emplace_back(radius * std::cos(t), radius * std::sin(t), z);
    }
    return out;
}

/// Add every k-th row and column of a heightfield to an outline, including the last ones.
void ground_lines(const ShapeDef& def, RecordedOutline& out) {
    const auto some = [](int count) {
        std::vector<int> at;
        const int stride = (count + kMaxLines - 1) / kMaxLines;
        for (int i = 0; i < count; i += stride) at.push_back(i);
        if (at.back() != count - 1) at.push_back(count - 1);
        return at;
    };
    const std::vector<int> columns = some(def.columns);
    out.row = static_cast<std::int32_t>(columns.size());
    for (const int i : some(def.rows))
        for (const int j : columns)
            out.points.emplace_back(
                (j - 0.5 * (def.columns - 1)) * def.cell[0],
                (i - 0.5 * (def.rows - 1)) * def.cell[1],
                def.heights[static_cast<std::size_t>(i) * static_cast<std::size_t>(def.columns) +
                            static_cast<std::size_t>(j)]);
}

/// Return the outline of a shape in the shape's own frame.
RecordedOutline in_shape(const ShapeDef& def) {
    RecordedOutline out;
    out.body = def.body.index;
    switch (def.kind) {
        case ShapeKind::sphere:
            out.radius = def.radius;
            out.points = {Vec3::Zero()};
            break;
        case ShapeKind::capsule:
            out.radius = def.radius;
            out.points = {Vec3(0, 0, -def.half_length), Vec3(0, 0, def.half_length)};
            break;
        case ShapeKind::cylinder:
            out.points = circle_points(def.radius, -def.half_length);
            for (const Vec3& p : circle_points(def.radius, def.half_length))
                out.points.push_back(p);
            break;
        case ShapeKind::box:
            for (int i = 0; i < 8; ++i)
                out.points.emplace_back(def.half_size.x() * ((i & 1) != 0 ? 1 : -1),
                                        def.half_size.y() * ((i & 2) != 0 ? 1 : -1),
                                        def.half_size.z() * ((i & 4) != 0 ? 1 : -1));
            break;
        case ShapeKind::hull:
            out.points = def.vertices;
            break;
        case ShapeKind::plane:
            out.kind = OutlineKind::plane;
            out.points = {Vec3::Zero(), Vec3::UnitZ()};
            break;
        case ShapeKind::heightfield:
            out.kind = OutlineKind::lines;
            ground_lines(def, out);
            break;
        case ShapeKind::mesh:
            out.kind = OutlineKind::lines;
            out.row = 4;
            for (std::size_t t = 0; t < std::min(def.triangles.size(), kMostTriangles); ++t)
                for (const std::size_t k : {0U, 1U, 2U, 0U})
                    out.points.push_back(
                        def.vertices[static_cast<std::size_t>(def.triangles[t][k])]);
            break;
    }
    return out;
}

}  // namespace

std::vector<RecordedOutline> make_outlines(const SceneInfo& scene, const World& world) {
    std::vector<bool> in_cable(static_cast<std::size_t>(world.body_count()), false);
    for (const CableInfo& cable : scene.cables)
        for (std::size_t i = 1; i + 1 < cable.nodes.size(); ++i)
            in_cable[static_cast<std::size_t>(cable.nodes[i].index)] = true;
    std::vector<RecordedOutline> out;
    for (const ShapeId id : world.shapes()) {
        const ShapeDef& def = world.shape_def(id);
        if (def.body_b.valid() || in_cable[static_cast<std::size_t>(def.body.index)]) continue;
        RecordedOutline outline = in_shape(def);
        const Quat turn = def.orientation.normalized();
        for (std::size_t i = 0; i < outline.points.size(); ++i) {
            const bool direction = outline.kind == OutlineKind::plane && i == 1;
            outline.points[i] = turn * outline.points[i];
            if (!direction) outline.points[i] += def.position;
        }
        out.push_back(std::move(outline));
    }
    return out;
}

void write_outlines(ByteWriter& out, const std::vector<RecordedOutline>& outlines) {
    out.put(static_cast<std::uint32_t>(outlines.size()));
    for (const RecordedOutline& o : outlines) {
        out.put(o.body);
        out.put(static_cast<std::uint8_t>(o.kind));
        out.put(o.radius);
        out.put(o.row);
        out.put(static_cast<std::uint32_t>(o.points.size()));
        for (const Vec3& p : o.points)
            for (int k = 0; k < 3; ++k) out.put(p[k]);
    }
}

std::vector<RecordedOutline> get_outlines(ByteReader& in, std::size_t bodies) {
    std::vector<RecordedOutline> outlines(in.get_count(4 + 1 + 8 + 4 + 4));
    for (RecordedOutline& o : outlines) {
        o.body = in.get<std::int32_t>();
        const auto kind = in.get<std::uint8_t>();
        o.radius = get_finite(in);
        o.row = in.get<std::int32_t>();
        o.points.resize(in.get_count(24));
        for (Vec3& p : o.points) p = get_vector(in);
        o.kind = static_cast<OutlineKind>(kind);
        if (o.body < 0 || static_cast<std::size_t>(o.body) >= bodies || kind > 2 ||
            !(o.radius >= 0.0) || o.points.empty() ||
            (o.kind == OutlineKind::plane && o.points.size() != 2) ||
            (o.kind == OutlineKind::lines && o.row < 2))
            throw BadBytes("an outline makes no sense");
    }
    return outlines;
}

}  // namespace hawser::record
