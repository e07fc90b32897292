// SPDX-License-Identifier: Apache-2.0
/// Check meshes of hulls, make boxes, and compute statics.
#include <hawser/hull.h>

#include "marine/hull_sums.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <utility>

namespace hawser {
namespace {

const Vec3& corner_of(const HullMesh& mesh, std::int32_t i) {
    return mesh.vertices[static_cast<std::size_t>(i)];
}

std::string coordinates_text(const Vec3& x) {
    char text[96];
    std::snprintf(text, sizeof text, "(%.6g, %.6g, %.6g)", x.x(), x.y(), x.z());
    return text;
}

std::string edge_of(const HullMesh& mesh, std::int32_t a, std::int32_t b) {
    return "the edge from vertex " + std::to_string(a) + " at " +
           coordinates_text(corner_of(mesh, a)) + " to vertex " + std::to_string(b) + " at " +
           coordinates_text(corner_of(mesh, b));
}

std::string numbers_fault(const HullMesh& mesh) {
    if (mesh.triangles.empty()) return "it has no triangles";
    for (const Vec3& x : mesh.vertices)
        if (!(x.cwiseAbs().maxCoeff() <= 1e6)) return "a vertex is not finite, or beyond 1e6 m";
    const auto count = static_cast<std::int32_t>(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (const std::int32_t c : mesh.triangles[i])
            if (c < 0 || c >= count)
                return "triangle " + std::to_string(i) + " has a vertex " + std::to_string(c) +
                       ", but there are " + std::to_string(count);
    return {};
}

}  // namespace

std::string hull_fault(const HullMesh& mesh) {
    if (std::string fault = numbers_fault(mesh); !fault.empty()) return fault;
    // Each edge once in each direction: closed, and of one orientation.
    std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> edges;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t a = mesh.triangles[i][k], b = mesh.triangles[i][(k + 1) % 3];
            const auto [there, first] = edges.try_emplace({a, b}, i);
            if (!first)
                return edge_of(mesh, a, b) + " is that of triangles " +
                       std::to_string(there->second) + " and " + std::to_string(i) +
                       " in the same direction: one of them is inverted";
        }
    for (const auto& [edge, triangle] : edges)
        if (edges.find({edge.second, edge.first}) == edges.end())
            return edge_of(mesh, edge.first, edge.second) + " belongs to triangle " +
                   std::to_string(triangle) + " alone: the mesh is open there";
    double volume = 0.0;
    for (const auto& t : mesh.triangles)
        volume += corner_of(mesh, t[0]).dot(corner_of(mesh, t[1]).cross(corner_of(mesh, t[2]))) / 6;
    if (!(volume > 0.0))
        return "its triangles are seen clockwise from outside, inverted: the volume is " +
               std::to_string(volume) + " m^3";
    return {};
}

HullMesh box_hull(const Vec3& half, int nx, int ny, int nz) {
    HullMesh mesh;
    const int n[] = {std::max(nx, 1), std::max(ny, 1), std::max(nz, 1)};
    std::map<std::array<int, 3>, std::int32_t> known;
    const auto vertex = [&](const std::array<int, 3>& at) {
        const auto [there, first] =
            known.try_emplace(at, static_cast<std::int32_t>(mesh.vertices.size()));
        if (first) {
            Vec3 x;
            for (int k = 0; k < 3; ++k)
                x[k] = half[k] * (2.0 * at[static_cast<std::size_t>(k)] / n[k] - 1.0);
            mesh.vertices.push_back(x);
        }
        return there->second;
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {0, 1}) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            for (int i = 0; i < n[u]; ++i)
                for (int j = 0; j < n[v]; ++j) {
                    const auto at = [&](int di, int dj) {
                        std::array<int, 3> p{};
                        p[static_cast<std::size_t>(axis)] = side * n[axis];
                        p[static_cast<std::size_t>(u)] = i + di;
                        p[static_cast<std::size_t>(v)] = j + dj;
                        return vertex(p);
                    };
                    std::int32_t q[] = {at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
                    if (side == 0) std::swap(q[1], q[3]);
                    mesh.triangles.push_back({q[0], q[1], q[2]});
                    mesh.triangles.push_back({q[0], q[2], q[3]});
                }
        }
    return mesh;
}

HullStatics hull_statics(const HullMesh& mesh, const Pose& pose, double level) {
    std::vector<marine::HullCorner> corners(mesh.vertices.size());
    HullStatics out;
    out.lowest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        corners[i].x = pose.position + pose.orientation * mesh.vertices[i];
        corners[i].depth = level - corners[i].x.z();
        out.lowest = std::min(out.lowest, corners[i].x.z());
    }
    marine::HullSums sums;
    for (const auto& t : mesh.triangles)
        sums.add_triangle(corners[static_cast<std::size_t>(t[0])],
                          corners[static_cast<std::size_t>(t[1])],
                          corners[static_cast<std::size_t>(t[2])]);
    out.volume = sums.volume;
    if (sums.volume > 0.0) out.buoyancy = sums.moment / sums.volume;
    out.plane_area = sums.plane;
    if (!(sums.plane > 0.0)) return out;
    const double x = sums.x / sums.plane, y = sums.y / sums.plane;
    out.plane_centre = {x, y, level};
    out.inertia_x = sums.yy - sums.plane * y * y;
    out.inertia_y = sums.xx - sums.plane * x * x;
    out.inertia_xy = sums.xy - sums.plane * x * y;
    return out;
}

}  // namespace hawser
