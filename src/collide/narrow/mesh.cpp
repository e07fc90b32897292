// SPDX-License-Identifier: Apache-2.0
// Triangle meshes: checks, neighbours over edges, a tree of boxes, and the contact of a convex
// shape with the triangles near it. Both sides of a triangle can touch.
#include "collide/bounds.h"
#include "collide/narrow/pairs.h"
#include "collide/narrow/shape_data.h"
#include "collide/narrow/triangle_contact.h"

#include <hawser/shapes.h>

#include <algorithm>
#include <map>
#include <utility>

namespace hawser::collide::narrow {
namespace {

constexpr std::size_t kMaxTriangles = 1'048'576;
constexpr int kLeafTriangles = 4, kMaxDepth = 64;

struct TreeBuilder {
    ShapeData& mesh;
    std::vector<int> order;
    std::vector<V3> centre;

    int build(int first, int count) {
        const int index = static_cast<int>(mesh.nodes.size());
        mesh.nodes.push_back({{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}, first, count, -1});
        MeshNode node = mesh.nodes.back();
        double low[3] = {1e300, 1e300, 1e300}, high[3] = {-1e300, -1e300, -1e300};
        for (int i = first; i < first + count; ++i)
            for (int k = 0; k < 3; ++k) {
                low[k] = std::min(low[k], component(centre[order[i]], k));
                high[k] = std::max(high[k], component(centre[order[i]], k));
                for (int c = 0; c < 3; ++c) {
                    const double x = component(mesh.vertices[mesh.triangles[3 * order[i] + c]], k);
                    node.low[k] = std::min(node.low[k], x);
                    node.high[k] = std::max(node.high[k], x);
                }
            }
        if (count > kLeafTriangles) {
            int k = 0;
            for (int j = 1; j < 3; ++j)
                if (high[j] - low[j] > high[k] - low[k]) k = j;
            const auto begin = order.begin() + first;
            std::nth_element(begin, begin + count / 2, begin + count, [&](int i, int j) {
                const double x = component(centre[i], k), y = component(centre[j], k);
                return x != y ? x < y : i < j;
            });
            node.count = 0;
            build(first, count / 2);
            node.second = build(first + count / 2, count - count / 2);
        }
        mesh.nodes[index] = node;
        return index;
    }
};

/// Sort the triangles in the order of the tree.
void sort_by_tree(ShapeData& mesh) {
    const int count = static_cast<int>(mesh.triangles.size() / 3);
    TreeBuilder tree{mesh, std::vector<int>(count), std::vector<V3>(count)};
    for (int t = 0; t < count; ++t) {
        tree.order[t] = t;
        V3 sum{0, 0, 0};
        for (int c = 0; c < 3; ++c) sum = sum + mesh.vertices[mesh.triangles[3 * t + c]];
        tree.centre[t] = (1.0 / 3.0) * sum;
    }
    tree.build(0, count);
    std::vector<std::int32_t> triangles;
    for (const int t : tree.order) {
        for (int c = 0; c < 3; ++c) triangles.push_back(mesh.triangles[3 * t + c]);
        mesh.names.push_back(t);
    }
    mesh.triangles = std::move(triangles);
}

void find_neighbours(ShapeData& mesh) {
    const int count = static_cast<int>(mesh.triangles.size() / 3);
    struct Sides {
        int place[2], uses = 0;  ///< 3 · triangle + edge.
    };
    std::map<std::pair<int, int>, Sides> edges;
    for (int t = 0; t < count; ++t)
        for (int k = 0; k < 3; ++k) {
            const int i = mesh.triangles[3 * t + k], j = mesh.triangles[3 * t + (k + 1) % 3];
            Sides& s = edges[std::minmax(i, j)];
            if (s.uses < 2) s.place[s.uses] = 3 * t + k;
            ++s.uses;
        }
    mesh.opposite.assign(mesh.triangles.size(), -1);
    mesh.ring_first.assign(mesh.vertices.size() + 1, 0);
    for (const auto& [key, s] : edges) {
        ++mesh.ring_first[key.first + 1];
        ++mesh.ring_first[key.second + 1];
        if (s.uses != 2) continue;
        for (int i = 0; i < 2; ++i) {
            const int other = s.place[1 - i];
            mesh.opposite[s.place[i]] = mesh.triangles[other - other % 3 + (other + 2) % 3];
        }
    }
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        mesh.ring_first[v + 1] += mesh.ring_first[v];
    mesh.ring.assign(2 * edges.size(), 0);
    std::vector<int> fill(mesh.ring_first.begin(), mesh.ring_first.end());
    for (const auto& [key, s] : edges) {
        mesh.ring[fill[key.first]++] = key.second;
        mesh.ring[fill[key.second]++] = key.first;
    }
}

/// Context for the contact of a triangle, relative to the centre of the shape.
struct VisitedEdge {
    const ShapeData& mesh;
    V3 centre;
};

int mesh_ring(const SurfaceTriangle& t, int corner, V3* out) {
    const VisitedEdge& seen = *static_cast<const VisitedEdge*>(t.surface);
    const int v = seen.mesh.triangles[3 * t.index + corner];
    int count = 0;
    for (int i = seen.mesh.ring_first[v]; i < seen.mesh.ring_first[v + 1] && count < kMaxRing; ++i)
        out[count++] = seen.mesh.vertices[seen.mesh.ring[i]] - seen.centre;
    return count;
}

SurfaceTriangle triangle_of(const VisitedEdge& seen, int t) {
    const ShapeData& mesh = seen.mesh;
    const auto place = [&](int v) { return mesh.vertices[v] - seen.centre; };
    const std::int32_t* v = &mesh.triangles[3 * t];
    SurfaceTriangle out{};
    out.triangle = make_triangle(place(v[0]), place(v[1]), place(v[2]));
    for (int k = 0; k < 3; ++k) {
        const int w = mesh.opposite[3 * t + k];
        out.has_neighbour[k] = w >= 0;
        if (w >= 0) out.opposite[k] = place(w);
    }
    out.name = static_cast<std::uint32_t>(mesh.names[t]);
    out.surface = &seen;
    out.index = t;
    out.ring = mesh_ring;
    return out;
}

}  // namespace

void make_mesh(const ShapeDef& def, ShapeData& out) {
    if (def.triangles.empty()) throw_shape_error(def, "triangles is empty");
    if (def.triangles.size() > kMaxTriangles || def.vertices.size() > kMaxTriangles)
        throw_shape_error(def, "a mesh has at most " + std::to_string(kMaxTriangles) +
                                   " triangles and as many vertices");
    for (const Vec3& v : def.vertices) out.vertices.push_back({v.x(), v.y(), v.z()});
    const int count = static_cast<int>(def.vertices.size());
    for (std::size_t t = 0; t < def.triangles.size(); ++t) {
        const auto& corners = def.triangles[t];
        const std::string where = "triangles[" + std::to_string(t) + "]";
        for (const std::int32_t i : corners) {
            if (i < 0 || i >= count)
                throw_shape_error(def, where + " names vertex " + std::to_string(i) +
                                           "; there are " + std::to_string(count));
            out.triangles.push_back(i);
        }
        const V3 &a = out.vertices[corners[0]], &b = out.vertices[corners[1]],
                 &c = out.vertices[corners[2]];
        const double longest = std::max({norm(b - a), norm(c - b), norm(a - c)});
        // Thinner triangles have no well-defined normal.
        if (!(norm(cross(b - a, c - a)) > 1e-9 * longest * longest))
            throw_shape_error(def, where + " has no area; leave it out");
    }
    sort_by_tree(out);
    find_neighbours(out);
}

HAWSER_PAIR(convex_mesh) {
    out.count = 0;
    const ShapeData& mesh = *b.data;
    const Placement local = view_from(pa, pb);
    const Bounds box = bounds(a, local);
    // Use coordinates relative to the centre of the shape, so that a large mesh loses no digits.
    const Convex shape = make_convex(a, local, local.x);
    const V3 centre = generic::load3(local.x);
    const VisitedEdge seen{mesh, centre};
    Points points;
    Point nearest{};
    int stack[kMaxDepth], depth = 0;
    stack[depth++] = 0;
    while (depth > 0) {
        const int index = stack[--depth];
        const MeshNode& node = mesh.nodes[index];
        bool meets = true;
        for (int k = 0; k < 3; ++k)
            meets =
                meets && node.low[k] < box.high[k] + margin && node.high[k] > box.low[k] - margin;
        if (!meets) continue;
        if (node.count == 0) {
            stack[depth++] = node.second;
            stack[depth++] = index + 1;
            continue;
        }
        for (int t = node.first; t < node.first + node.count; ++t) {
            reduce_if_full(points, shape);
            touch_triangle(shape, triangle_of(seen, t), margin, points, nearest);
        }
    }
    if (nearest.gap < 0.0 && none_overlaps(points)) points.add(nearest);
    finish_surface(points, pb, centre, shape, out);
}

}  // namespace hawser::collide::narrow
